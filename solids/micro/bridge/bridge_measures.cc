// SPDX-License-Identifier: LGPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "interval/box_geometry.h"
#include "interval/functions.h"
#include "solids/micro/bridge/bridge_measures_internal.h"

namespace veritope::internal {
namespace {

// Bounds of 180 / pi.
constexpr double kDegreesBelow = 57.2957795130823, kDegreesAbove = 57.2957795130824;

}  // namespace

void widen(const BridgeRange& more, bool is_first, BridgeRange* range) {
  range->lo = is_first ? more.lo : std::min(range->lo, more.lo);
  range->hi = is_first ? more.hi : std::max(range->hi, more.hi);
}

Box3 hull_of(const HullPoints& points) {
  Box3 out = Box3::empty();
  for (const Box3& p : points) out = hull(out, p);
  return out;
}

BridgeRange angle_between(const Box3& a, const Box3& b) {
  const Interval cosine = dot(a, b) / (norm(a) * norm(b));
  const Interval angle = acos(intersection(cosine, Interval::from_bounds(-1, 1))) *
                         Interval::from_bounds(kDegreesBelow, kDegreesAbove);
  if (angle.is_empty() || !(angle.hi() < 200)) return kAnyAngle;
  return {std::max(0.0, angle.lo()), std::min(180.0, angle.hi())};
}

double distance_below(const SkinProjection& projection, const Box3& at) {
  ExactPoint middle;
  Interval radius;
  for (std::size_t c = 0; c < 3; ++c) {
    const double m = 0.5 * at[c].lo() + 0.5 * at[c].hi();
    middle[c] = Rational::from_double(m);
    const Interval off = at[c] - Interval(m);
    radius += Interval(std::max(std::abs(off.lo()), std::abs(off.hi())));
  }
  const Interval distance = sqrt(projection.squared_distance(middle));
  return std::max(0.0, (distance - radius).lo());
}

}  // namespace veritope::internal
