// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/micro/cage/content_search_internal.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "interval/upward.h"
#include "robust/base/nearest_on_triangle.h"

namespace veritope::internal {
namespace {

std::vector<HullPoint> hull_of(const EnclosedBezier& patch) {
  std::vector<HullPoint> out;
  for (const auto& p : patch.points) {
    if (patch.is_rational)
      out.push_back({p[0] / p[3], p[1] / p[3], p[2] / p[3]});
    else
      out.push_back({p[0], p[1], p[2]});
  }
  return out;
}

std::size_t longer_axis(const EnclosedBezier& patch, const std::vector<HullPoint>& hull) {
  // The longest way between neighbours, times their number.
  std::array<double, 2> longest{};
  for (std::size_t n = 0; n < hull.size(); ++n) {
    const auto at = patch.grid.index_of(n);
    for (std::size_t a = 0; a < 2; ++a) {
      if (at[a] + 1 == patch.grid.size[a]) continue;
      auto next = at;
      ++next[a];
      const HullPoint& q = hull[patch.grid.at(next)];
      double way = 0;
      for (std::size_t k = 0; k < 3; ++k) way += std::abs(q[k].lo() - hull[n][k].lo());
      longest[a] = std::max(longest[a], way * static_cast<double>(patch.grid.size[a]));
    }
  }
  return longest[0] < longest[1] ? 1 : 0;
}

// The halves along the axis, by the means of neighbours.
std::pair<EnclosedBezier, EnclosedBezier> halves_of(const EnclosedBezier& patch, std::size_t axis) {
  static constexpr Interval kHalf(0.5);
  EnclosedBezier first = patch, second = patch;
  const std::size_t n = patch.grid.size[axis], other = 1 - axis;
  for (std::size_t line = 0; line < patch.grid.size[other]; ++line) {
    const auto place = [&](std::size_t i) {
      std::array<std::size_t, 2> at{};
      at[axis] = i;
      at[other] = line;
      return patch.grid.at(at);
    };
    std::vector<std::array<Interval, 4>> row;
    for (std::size_t i = 0; i < n; ++i) row.push_back(patch.points[place(i)]);
    for (std::size_t left = n; left > 0; --left) {
      first.points[place(n - left)] = row.front();
      second.points[place(left - 1)] = row[left - 1];
      for (std::size_t i = 0; i + 1 < left; ++i)
        for (std::size_t c = 0; c < 4; ++c) row[i][c] = (row[i][c] + row[i + 1][c]) * kHalf;
    }
  }
  return {std::move(first), std::move(second)};
}

double square_between(const Point3d& a, const Point3d& b) {
  double sum = 0;
  for (std::size_t k = 0; k < 3; ++k) sum += (a[k] - b[k]) * (a[k] - b[k]);
  return sum;
}
double square_to_box(const Point3d& p, const Box3d& box) {
  double sum = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const double off = std::max({box.lo[k] - p[k], p[k] - box.hi[k], 0.0});
    sum += off * off;
  }
  return sum;
}

}  // namespace

EnclosedBezier enclosed(const BezierSurface<Rational>& patch) {
  EnclosedBezier out{patch.grid(), patch.is_rational(), {}};
  out.points.resize(patch.grid().count());
  for (int c = 0; c < 3 + (patch.is_rational() ? 1 : 0); ++c) {
    const int from = c == 3 ? patch.num_components() - 1 : c;
    for (std::size_t n = 0; n < out.points.size(); ++n) {
      const Rational& x = patch.component(from)[n];
      out.points[n][static_cast<std::size_t>(c)] =
          Interval::from_bounds(round_down(x), round_up(x));
    }
  }
  return out;
}

ContentSearch::ContentSearch(const CageContent& content) : ends_(content.ends) {
  std::vector<HullPoint> points;
  for (const CellPoint& p : content.points) points.push_back(hull_point(p));
  for (const std::uint32_t c : content.corners) corners_.push_back(points[c]);
  for (std::uint32_t i = 0; i < ends_.size(); ++i) boxes_.push_back(box_of_hull(hull(i)));
  hierarchy_ = BoxHierarchy(boxes_);
}

std::span<const HullPoint> ContentSearch::hull(std::uint32_t part) const {
  const std::size_t begin = part == 0 ? 0 : ends_[part - 1];
  return std::span(corners_).subspan(begin, ends_[part] - begin);
}

std::optional<std::uint32_t> ContentSearch::met_by(const EnclosedBezier& patch,
                                                   int halvings) const {
  const ScopedUpward upward;
  const std::vector<HullPoint> points = hull_of(patch);
  const Box3d box = box_of_hull(points);
  HullSides sides(points);
  std::vector<std::uint32_t> parts;
  const auto keep = [&](const Box3d& b) {
    if (!meets(b, box)) return false;
    std::array<HullPoint, 8> corners;
    for (std::size_t n = 0; n < 8; ++n)
      for (std::size_t k = 0; k < 3; ++k)
        corners[n][k] = Interval((n >> k & 1) == 0 ? b.lo[k] : b.hi[k]);
    return !sides.is_apart_from(corners);
  };
  hierarchy_.visit(keep, [&](std::uint32_t part) { parts.push_back(part); });
  return met(patch, std::move(parts), halvings);
}

std::optional<std::uint32_t> ContentSearch::met(const EnclosedBezier& patch,
                                                std::vector<std::uint32_t> parts,
                                                int halvings) const {
  if (parts.empty()) return std::nullopt;
  const std::vector<HullPoint> points = hull_of(patch);
  const Box3d box = box_of_hull(points);
  HullSides sides(points);
  std::vector<std::uint32_t> left;
  for (const std::uint32_t part : parts)
    if (meets(boxes_[part], box) && !sides.is_apart_from(hull(part))) left.push_back(part);
  if (left.empty()) return std::nullopt;
  if (halvings == 0) return left.front();
  const auto [first, second] = halves_of(patch, longer_axis(patch, points));
  if (const auto part = met(first, left, halvings - 1)) return part;
  return met(second, std::move(left), halvings - 1);
}

Point3d ContentSearch::approx_nearest(const Point3d& p) const {
  Point3d best{};
  double least = std::numeric_limits<double>::infinity();
  const auto corner = [&](std::uint32_t part, std::size_t i) {
    const HullPoint& at = hull(part)[i];
    return Point3d{at[0].lo(), at[1].lo(), at[2].lo()};
  };
  const auto take = [&](const Point3d& q) {
    const double square = square_between(p, q);
    if (square < least) {
      least = square;
      best = q;
    }
  };
  const auto visit = [&](std::uint32_t part) {
    const std::size_t n = hull(part).size();
    if (n == 3)
      return take(approx_nearest_on_triangle(p, corner(part, 0), corner(part, 1), corner(part, 2)));
    for (std::size_t i = 0; i < n; ++i) take(corner(part, i));
  };
  // A few parts first, so that the search through the tree has a bound.
  const std::size_t stride = 1 + boxes_.size() / 64;
  for (std::size_t i = 0; i < boxes_.size(); i += stride) visit(static_cast<std::uint32_t>(i));
  hierarchy_.visit([&](const Box3d& b) { return square_to_box(p, b) < least; }, visit);
  return best;
}

}  // namespace veritope::internal
