// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/interval_boxes/chord_circle.h: R_max <= R_kappa: boxes along a curve or surface are small enough against its
// curvature for the sub-collections of Remark 3.1 to exist. Source: [SSP01] 3, eq. 2-4, figures 7 and 8. Design:
// docs/design/0019-paper-conditions.md.
#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <span>

#include "interval/interval.h"
#include "robust/base/result.h"
#include "splines/bspline.h"

namespace veritope {

/// Two boxes of the plane with centres c1 = 0 and c2 and half-widths e1, e2, each {x, y}.
struct BoxPair {
  std::array<Interval, 2> c2, e1, e2;
};

/// psi(c2, e1, e2) of eq. 2 for every choice in the intervals: the radius of the circle through c1 = 0 and c2 that
/// passes through the point p in which the right edge of b1 meets the line l: y = c2y - (e1y + e2y), p being the one of
/// its two points of l with the larger x; or, if there is no such p, that is tangent to l between c1 and c2. A curve
/// from c1 to c2 in the lens of the two arcs of that radius over the chord (curvatures up to 1 / r keep it there) is
/// above l, or to the left of p. Where there is a p it may leave b1 through its lower side, which [SSP01] overlooks:
/// for c2 = (0.95, 0.05), e1 = (0.95, 0.03), e2y = 0.03, by over ten times e1y. In samples R_max was great enough for
/// all pairs (a test); we found no proof. With h = e1y + e2y - c2y: p exists iff h <= e1y and the circle's centre is
/// not to the right of p; then r = |c2| |p| |c2 - p| / (2 (c2x h + c2y e1x)); else r = (|c2|^2 + 4 h (h + c2y)) / (2 (2
/// h + c2y + 2 sqrt(h (h + c2y)) c2x / |c2|)), which is also right for c2y = 0, and bounded at c2 = 0. REQUIRES a live
/// ScopedUpward; c2x, c2y >= 0 and half-widths > 0. Choices with h < 0 (boxes apart) are left out; empty if there are
/// no others.
Interval psi(const BoxPair& pair);
/// The tangent case for all choices: never less sufficient, and all that figure 8 needs. h >= 0 as above, c2x >= 0.
Interval tangent_radius(const std::array<Interval, 2>& c2, const Interval& h);

/// Bounds of the half-widths of all boxes, [least, greatest] for each axis.
struct HalfWidths {
  std::array<Interval, 2> range;
};

struct RadiusOptions {
  double relative_width = 0x1p-6;  ///< wanted of the enclosure
  std::uint64_t max_boxes = 200'000;
};
struct RadiusEnclosure {
  Interval radius;
  bool is_as_asked = false;
  std::uint64_t boxes = 0;
};

/// R_max of eq. 3: the greatest psi over all pairs of boxes that meet, c2x in [0, e1x + e2x], c2y in [0, e1y + e2y],
/// with half-widths in their ranges and e1y <= e2y (the paper's assumption; the other order is the mirror image).
/// Branch and bound over six variables with rigorous bounds.
/// @error kBadArgument unless the half-widths are positive and finite
Result<RadiusEnclosure> greatest_chord_radius(const HalfWidths& half_widths,
                                              const RadiusOptions& options = {});
/// The chord circle's radius for boxes in space whose surface is nearly level along axis `up` (figure 8): in the
/// vertical plane through both centres, by tangent circles, with the greatest horizontal distance of centres and the
/// vertical half-widths. A geodesic from c1 to c2 is no more curved than the surface, so it stays in the lens of that
/// circle revolved about the chord, whose lowest point is in this plane.
Result<RadiusEnclosure> greatest_chord_radius(const std::array<Interval, 3>& half_widths,
                                              std::size_t up, const RadiusOptions& options = {});

/// R_kappa: a lower and an upper bound of the least radius of curvature; hi is infinite for what is straight. The first
/// overload is for a curve in the plane, the second for a surface in space (1 / the greatest principal curvature).
/// @error kBadArgument for another dimension, where curvatures stay unbounded, and for a knot of multiplicity degree or
/// more inside the domain: there may be a corner, which no curvature shows
Result<RadiusEnclosure> least_curvature_radius(const BSpline<Rational, 1>& curve,
                                               const RadiusOptions& options = {});
Result<RadiusEnclosure> least_curvature_radius(const BSpline<Rational, 2>& surface,
                                               const RadiusOptions& options = {});

/// Eq. 4, R_max <= R_kappa: true or false where the enclosures are apart, else nothing.
std::optional<bool> satisfies_eq4(const RadiusEnclosure& r_max, const RadiusEnclosure& r_kappa);

}  // namespace veritope
