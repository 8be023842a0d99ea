// SPDX-License-Identifier: LGPL-3.0-or-later
#include <algorithm>
#include <bit>

#include "solids/dms/dms_polygon_internal.h"

namespace veritope {
namespace {

using internal::DmsPolygon;
using internal::DmsSegment;

std::array<double, 3> rounded(const ExactPoint3& p) {
  return {p.rounded().x, p.rounded().y, p.rounded().z};
}
std::size_t hash_of(const ExactPoint3& p) {
  std::uint64_t out = 0;
  for (const double x : rounded(p))
    out = (out ^ std::bit_cast<std::uint64_t>(x + 0.0)) * 0x9e3779b97f4a7c15u;  // -0 is 0
  return static_cast<std::size_t>(out ^ (out >> 29));
}

// Nearest doubles never are in the wrong order.
std::strong_ordering compare(const ExactPoint3& a, const ExactPoint3& b, std::size_t c) {
  const double x = rounded(a)[c], y = rounded(b)[c];
  if (x < y) return std::strong_ordering::less;
  if (x > y) return std::strong_ordering::greater;
  return a.at()[c] <=> b.at()[c];
}
// Whether p is surely off the box around a and b.
bool is_far(const std::array<double, 3>& a, const std::array<double, 3>& b,
            const std::array<double, 3>& p) {
  for (std::size_t c = 0; c < 3; ++c)
    if (p[c] < std::min(a[c], b[c]) || p[c] > std::max(a[c], b[c])) return true;
  return false;
}
bool are_collinear(const ExactPoint3& a, const ExactPoint3& b, const ExactPoint3& c) {
  for (int axis = 0; axis < 3; ++axis)
    if (orient2d_projected(a, b, c, axis) != Sign::kZero) return false;
  return true;
}

}  // namespace

std::uint32_t internal::DmsPoints::add(DmsPoint p) {
  ExactPoint3 exact(std::move(p));
  const std::size_t hash = hash_of(exact);
  const auto [first, last] = by_hash_.equal_range(hash);
  for (auto it = first; it != last; ++it)
    if (points_[it->second].at() == exact.at()) return it->second;
  const auto number = static_cast<std::uint32_t>(points_.size());
  by_hash_.emplace(hash, number);
  points_.push_back(std::move(exact));
  return number;
}

internal::DmsDrawingPlane::DmsDrawingPlane(DmsPoints& points, const DmsPoint& normal)
    : points_(points), axis_(0) {
  for (int c = 1; c < 3; ++c)
    if (abs(normal[static_cast<std::size_t>(c)]) > abs(normal[static_cast<std::size_t>(axis_)]))
      axis_ = c;
  up_ = normal[static_cast<std::size_t>(axis_)].sign();
}

Sign internal::DmsDrawingPlane::turn(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
  return up_ * orient2d_projected(points_.at(a), points_.at(b), points_.at(c), axis_);
}

// The determinant of the coordinates across the axis of the line's points and p, times the scales of all three.
Integer internal::DmsDrawingPlane::height(const DmsSegment& line, std::uint32_t p) const {
  const auto x = static_cast<std::size_t>((axis_ + 1) % 3),
             y = static_cast<std::size_t>((axis_ + 2) % 3);
  const ExactPoint3 &a = points_.at(line[0]), &b = points_.at(line[1]), &c = points_.at(p);
  const auto minor = [&](const ExactPoint3& r, const ExactPoint3& s) {
    return r.scaled()[x] * s.scaled()[y] - r.scaled()[y] * s.scaled()[x];
  };
  return minor(a, b) * c.scale() + minor(b, c) * a.scale() + minor(c, a) * b.scale();
}

// Where the side from a to b meets the line; its ends are on different sides of it.
std::uint32_t internal::DmsDrawingPlane::crossing(const DmsSegment& line, std::uint32_t a,
                                                  std::uint32_t b) const {
  const ExactPoint3 &p = points_.at(a), &q = points_.at(b);
  const Integer here = height(line, a), next = height(line, b);
  const Integer weight = here * q.scale() - next * p.scale();
  DmsPoint out;
  for (std::size_t c = 0; c < 3; ++c)
    out[c] = Rational(here * q.scaled()[c] - next * p.scaled()[c], weight);
  return points_.add(std::move(out));
}

// A segment reaches into a convex polygon unless its own line or that of a side parts them.
std::optional<std::pair<DmsPolygon, DmsPolygon>> internal::DmsDrawingPlane::cut(
    const DmsPolygon& polygon, const DmsSegment& segment) const {
  DmsSegment line = segment;
  if (line[0] == line[1]) line[1] = polygon[0];
  if (line[0] == line[1]) return std::nullopt;  // a corner
  std::vector<Sign> sides;
  bool has_left = false, has_right = false;
  for (const std::uint32_t p : polygon) {
    sides.push_back(turn(line[0], line[1], p));
    has_left |= sides.back() == Sign::kPositive;
    has_right |= sides.back() == Sign::kNegative;
  }
  if (!has_left || !has_right) return std::nullopt;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const std::uint32_t a = polygon[i], b = polygon[(i + 1) % polygon.size()];
    if (turn(a, b, segment[0]) != Sign::kPositive && turn(a, b, segment[1]) != Sign::kPositive)
      return std::nullopt;
  }
  DmsPolygon left, right;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const std::size_t k = (i + 1) % polygon.size();
    if (sides[i] != Sign::kNegative) left.push_back(polygon[i]);
    if (sides[i] != Sign::kPositive) right.push_back(polygon[i]);
    if (sides[i] == Sign::kZero || sides[i] != -sides[k]) continue;
    left.push_back(crossing(line, polygon[i], polygon[k]));
    right.push_back(left.back());
  }
  return std::pair{std::move(left), std::move(right)};
}

std::vector<std::array<std::uint32_t, 3>> internal::DmsDrawingPlane::triangles(
    const DmsPolygon& polygon) const {
  if (polygon.size() == 3) return {{polygon[0], polygon[1], polygon[2]}};
  DmsPoint mean;
  for (const std::uint32_t p : polygon)
    for (std::size_t c = 0; c < 3; ++c) mean[c] += points_.at(p).at()[c];
  for (Rational& x : mean) x /= Rational(static_cast<std::int64_t>(polygon.size()));
  const std::uint32_t middle = points_.add(std::move(mean));
  std::vector<std::array<std::uint32_t, 3>> out;
  for (std::size_t i = 0; i < polygon.size(); ++i)
    out.push_back({polygon[i], polygon[(i + 1) % polygon.size()], middle});
  return out;
}

bool internal::is_between(const ExactPoint3& a, const ExactPoint3& b, const ExactPoint3& p) {
  if (is_far(rounded(a), rounded(b), rounded(p)) || !are_collinear(a, b, p)) return false;
  for (std::size_t c = 0; c < 3; ++c) {
    const auto way = compare(a, b, c);
    if (way != 0) return compare(a, p, c) == way && compare(p, b, c) == way;
  }
  return false;
}

DmsPolygon internal::with_corners(const DmsPoints& points, const DmsPolygon& polygon,
                                  std::span<const std::uint32_t> candidates) {
  DmsPolygon out;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const ExactPoint3 &a = points.at(polygon[i]), &b = points.at(polygon[(i + 1) % polygon.size()]);
    std::vector<std::uint32_t> inside;
    for (const std::uint32_t p : candidates)
      if (is_between(a, b, points.at(p))) inside.push_back(p);
    // Points of a segment are in the order of the first coordinate that differs.
    std::sort(inside.begin(), inside.end(), [&](std::uint32_t p, std::uint32_t q) {
      for (std::size_t c = 0; c < 3; ++c) {
        const auto way = compare(a, b, c);
        if (way != 0) return compare(points.at(p), points.at(q), c) == way;
      }
      return false;
    });
    out.push_back(polygon[i]);
    out.insert(out.end(), inside.begin(), inside.end());
  }
  return out;
}

}  // namespace veritope
