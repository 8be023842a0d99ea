// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/classify/distance_net_internal.h: the squared distance from a point to a part of a patch, with derivatives,
// enclosed. Internal to solids/classify.
#pragma once
#include <array>

#include "interval/box.h"
#include "interval/ring_numbers.h"
#include "splines/bezier.h"

namespace veritope::internal {

/// Enclosures over [0,1]^2 of the half squared distance's first and second derivatives: of D = |S - q|^2 / 2.
struct DistanceBounds {
  std::array<Interval, 2> first;
  std::array<Interval, 3> second;  ///< D_uu, D_uv, D_vv

  /// D is strictly convex: it has at most one least point on any convex part of the square.
  bool is_convex() const;
};

/// All functions REQUIRE a live ScopedUpward, and positive weights.
DistanceBounds distance_bounds(const Box3& q, const BezierSurface<Interval>& net);
/// The first derivatives at these parameters of the square.
std::array<Interval, 2> distance_gradient(const Box3& q, const BezierSurface<Interval>& net,
                                          const std::array<double, 2>& at);
/// A part of the net over a box in [0,1]^2, as a net over [0,1]^2.
BezierSurface<Interval> net_over(const BezierSurface<Interval>& net, const Box2& part);
/// S_u and S_v over a box in [0,1]^2 whose sides are longer than 0.
std::array<Box3, 2> first_derivatives(const BezierSurface<Interval>& net, const Box2& part);
/// Contains all points.
Box3 hull_of_net(const BezierSurface<Interval>& net);

/// A part of `within` that contains every zero of D's gradient there, by Krawczyk's operator; empty if it has none.
Box2 contracted(const Box3& q, const BezierSurface<Interval>& net, const Box2& within);
/// A part that contains every zero of D_u, for a net that does not depend on v, by Newton's operator.
/// REQUIRES D_uu > 0 there.
Interval contracted_curve(const Box3& q, const BezierSurface<Interval>& net,
                          const Interval& within);

}  // namespace veritope::internal
