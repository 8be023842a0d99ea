// SPDX-License-Identifier: LGPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "interval/box_geometry.h"
#include "solids/micro/filter/separation_internal.h"

namespace veritope::internal {

namespace {

Point3d approx_difference(const Point3d& a, const Point3d& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
Point3d approx_cross(const Point3d& a, const Point3d& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
double approx_dot(const Point3d& a, const Point3d& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

}  // namespace

GrownHull::GrownHull(const TilePiece& piece) {
  points_.assign(piece.corners.begin(), piece.corners.end());
  for (const Box3& p : points_) approx_.push_back(approx_middle(p));
  excess_ = excess_of(piece);
  box_ = box_of(piece);
  edges_ = {approx_difference(approx_[1], approx_[0]), approx_difference(approx_[3], approx_[2]),
            approx_difference(approx_[2], approx_[0]), approx_difference(approx_[3], approx_[1]),
            approx_difference(approx_[3], approx_[0]), approx_difference(approx_[2], approx_[1])};
  normal_ = approx_cross(edges_[4], edges_[5]);
}

GrownHull::GrownHull(const TilePiece& piece, const Box3& apex) : GrownHull(piece) {
  points_.push_back(apex);
  approx_.push_back(approx_middle(apex));
  box_ = hull(box_, outer_box(apex));
  for (std::size_t i = 0; i < 4; ++i)
    edges_.push_back(approx_difference(approx_.back(), approx_[i]));
}

// Whether the greatest value of the hull along the direction is less than the facet's least one.
bool GrownHull::is_proved_apart(const Point3d& direction, const std::array<Vec3d, 3>& facet) const {
  if (!std::isfinite(direction[0] + direction[1] + direction[2])) return false;
  const Box3 d{Interval(direction[0]), Interval(direction[1]), Interval(direction[2])};
  Interval excess;
  for (std::size_t c = 0; c < 3; ++c) excess += Interval(mag(d[c])) * Interval(excess_[c]);
  Interval nearest;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3d& q = facet[i];
    const Interval at = dot(d, Box3(Interval(q.x), Interval(q.y), Interval(q.z)));
    nearest = i == 0 || at.lo() < nearest.lo() ? at : nearest;
  }
  return std::all_of(points_.begin(), points_.end(), [&](const Box3& p) {
    return (nearest - dot(d, p) - excess).sign() == Sign3::kPositive;
  });
}

// Guesses what is_proved_apart will say, at a fraction of the cost.
bool GrownHull::may_be_apart(const Point3d& d, const std::array<Vec3d, 3>& facet,
                             const Point3d& excess) const {
  double nearest = approx_dot(d, to_point(facet[0]));
  for (std::size_t i = 1; i < 3; ++i)
    nearest = std::min(nearest, approx_dot(d, to_point(facet[i])));
  for (std::size_t c = 0; c < 3; ++c) nearest -= std::abs(d[c]) * excess[c];
  return std::all_of(approx_.begin(), approx_.end(),
                     [&](const Point3d& p) { return approx_dot(d, p) < nearest; });
}

// Whether separates(d) holds for a candidate d or its opposite.
template <typename Separates>
bool GrownHull::finds_direction(const std::array<Vec3d, 3>& facet, Separates separates) const {
  const auto holds = [&](const Point3d& d) {
    return separates(d) || separates(Point3d{-d[0], -d[1], -d[2]});
  };
  std::array<Point3d, 3> sides;
  for (std::size_t i = 0; i < 3; ++i)
    sides[i] = approx_difference(to_point(facet[(i + 1) % 3]), to_point(facet[i]));
  const Point3d normal = approx_cross(sides[0], sides[1]);
  if (holds(normal) || holds(normal_)) return true;
  for (const Point3d& e : edges_)
    for (const Point3d& s : sides)
      if (holds(approx_cross(e, s))) return true;
  for (const Point3d& s : sides)
    if (holds(approx_cross(normal, s))) return true;
  for (const Point3d& e : edges_)
    if (holds(approx_cross(normal_, e))) return true;
  return false;
}

bool GrownHull::is_apart(const std::array<Vec3d, 3>& facet) const {
  Box3d other = empty_box();
  for (const Vec3d& q : facet) add(to_point(q), &other);
  if (!meets(box_, other)) return true;
  return finds_direction(facet, [&](const Point3d& d) {
    return may_be_apart(d, facet, excess_) && is_proved_apart(d, facet);
  });
}

bool GrownHull::may_have_gap(const std::array<Vec3d, 3>& facet, double gap) const {
  const Point3d excess{gap, gap, gap};
  const auto has_gap = [&](const Point3d& d) { return may_be_apart(d, facet, excess); };
  for (std::size_t c = 0; c < 3; ++c) {
    Point3d axis{};
    for (const double sign : {1.0, -1.0}) {
      axis[c] = sign;
      if (has_gap(axis)) return true;
    }
  }
  return finds_direction(facet, has_gap);
}

}  // namespace veritope::internal
