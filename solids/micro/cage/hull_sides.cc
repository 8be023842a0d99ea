// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/micro/cage/hull_sides_internal.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace veritope::internal {
namespace {

constexpr std::size_t kMostSides = 24;
constexpr int kSteps = 48;

Interval along(const Point3d& d, const HullPoint& p) {
  return Interval(d[0]) * p[0] + Interval(d[1]) * p[1] + Interval(d[2]) * p[2];
}

// A number of the interval, for the search.
double approx_middle(const Interval& x) { return 0.5 * x.lo() + 0.5 * x.hi(); }
Point3d approx_of(const HullPoint& p) {
  return {approx_middle(p[0]), approx_middle(p[1]), approx_middle(p[2])};
}
double approx_dot(const Point3d& a, const Point3d& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
Point3d approx_mean(std::span<const HullPoint> hull) {
  Point3d sum{};
  for (const HullPoint& p : hull) {
    const Point3d q = approx_of(p);
    for (std::size_t k = 0; k < 3; ++k) sum[k] += q[k] / static_cast<double>(hull.size());
  }
  return sum;
}
// The point that is farthest in the direction, or in the opposite one.
Point3d approx_support(std::span<const HullPoint> hull, const Point3d& d, double sign) {
  Point3d best{};
  double most = -std::numeric_limits<double>::infinity();
  for (const HullPoint& p : hull) {
    const Point3d q = approx_of(p);
    const double value = sign * approx_dot(d, q);
    if (value > most) {
      most = value;
      best = q;
    }
  }
  return best;
}

}  // namespace

HullPoint hull_point(const std::array<Rational, 3>& p) {
  const auto enclosed = [](const Rational& x) {
    return Interval::from_bounds(round_down(x), round_up(x));
  };
  return {enclosed(p[0]), enclosed(p[1]), enclosed(p[2])};
}

Box3d box_of_hull(std::span<const HullPoint> hull) {
  Box3d box = empty_box();
  for (const HullPoint& p : hull) {
    add({p[0].lo(), p[1].lo(), p[2].lo()}, &box);
    add({p[0].hi(), p[1].hi(), p[2].hi()}, &box);
  }
  return box;
}

HullSides::HullSides(std::span<const HullPoint> hull) : hull_(hull) {}

bool HullSides::is_beyond(const Side& side, std::span<const HullPoint> other) const {
  for (const HullPoint& p : other)
    if (!(along(side.direction, p).lo() > side.most)) return false;
  return true;
}

bool HullSides::try_direction(const Point3d& d, std::span<const HullPoint> other) {
  Side side{d, -std::numeric_limits<double>::infinity()};
  for (const HullPoint& p : hull_) {
    const double value = along(d, p).hi();
    if (!(value <= std::numeric_limits<double>::max())) return false;
    side.most = std::max(side.most, value);
  }
  if (!is_beyond(side, other)) return false;
  if (sides_.size() == kMostSides) sides_.pop_back();
  sides_.insert(sides_.begin(), side);
  return true;
}

bool HullSides::is_apart_from(std::span<const HullPoint> other) {
  for (std::size_t i = 0; i < sides_.size(); ++i) {
    if (!is_beyond(sides_[i], other)) continue;
    std::rotate(sides_.begin(), sides_.begin() + static_cast<std::ptrdiff_t>(i),
                sides_.begin() + static_cast<std::ptrdiff_t>(i) + 1);
    return true;
  }
  const Point3d a = approx_mean(hull_), b = approx_mean(other);
  Point3d x = {b[0] - a[0], b[1] - a[1], b[2] - a[2]};  // of the difference other - hull
  for (int step = 0; step < kSteps; ++step) {
    const double square = approx_dot(x, x);
    if (!(square > 0) || !std::isfinite(square)) return false;
    const Point3d q = approx_support(other, x, -1), p = approx_support(hull_, x, 1);
    const Point3d s = {q[0] - p[0], q[1] - p[1], q[2] - p[2]};
    const double ahead = approx_dot(x, s);
    if (ahead > 0) {
      // Directions of length near 1, so that products stay in the range.
      const double length = std::sqrt(square);
      return try_direction({x[0] / length, x[1] / length, x[2] / length}, other);
    }
    const Point3d way = {s[0] - x[0], s[1] - x[1], s[2] - x[2]};
    const double whole = approx_dot(way, way);
    if (!(whole > 0)) return false;
    const double t = std::min(1.0, (square - ahead) / whole);
    for (std::size_t k = 0; k < 3; ++k) x[k] += t * way[k];
  }
  return false;
}

}  // namespace veritope::internal
