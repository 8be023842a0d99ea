// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/chain/plane_arc.h: directed curves of the plane, as Bezier curves or conic arcs, and points beside them,
// exactly.  Theory: docs/THEORY.md, CHAIN-5.
#pragma once
#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "robust/base/result.h"
#include "robust/integer.h"
#include "solids/chain/chain_point.h"
#include "splines/bezier.h"

namespace veritope {

/// A parameter at which a curve passes through a point: lo = hi, or the only one between the two, which is irrational
/// or has a denominator of over 20 bits.
using ArcParameter = std::array<Rational, 2>;

class PlaneArc {
 public:
  using Curve = BezierCurve<Rational>;

  /// A polynomial curve, or a rational one with the weight as third component.
  /// @error kBadArgument unless the curve has two coordinates, a degree of 1 or more, and weights > 0
  static Result<PlaneArc> make(Curve curve);

  const Curve& curve() const { return curve_; }
  const PointIn<2>& start() const { return start_; }
  const PointIn<2>& end() const { return end_; }
  /// Contains the curve; the third coordinate is 0.
  const Box3d& box() const { return box_; }
  /// On which sides of the line from the start to the end its control points lie; nothing if both ends are one point.
  struct Sides {
    bool has_left = false, has_right = false;
  };
  std::optional<Sides> sides() const;

  /// How often the curve passes the ray from q along an axis, counter-clockwise as seen from q, minus how often it
  /// passes it clockwise. An end on the line of the ray counts as a point before the ray. Over a closed chain of curves
  /// the sum is the winding number around q. Nothing if q is on the curve: this is exact for all points.
  /// @cost pieces in proportion to the logarithm of the distance from q, in integers where the boxes do not decide
  std::optional<int> passes(const ChainPoint<2>& q, std::size_t axis = 0) const;
  /// A parameter of q: nothing if q is off the curve. A curve that is one point has the parameter 0.
  std::optional<ArcParameter> parameter_of(const PointIn<2>& q) const;

 private:
  PlaneArc(Curve curve, PointIn<2> start, PointIn<2> end, Box3d box);

  Curve curve_;
  PointIn<2> start_, end_;
  Box3d box_;
  std::array<std::vector<Integer>, 3> control_;  // x, y, w, times one positive integer
};

/// passes() of the straight segment from a to b. REQUIRES q not on it.
int passes_of_segment(const PointIn<2>& a, const PointIn<2>& b, const PointIn<2>& q,
                      std::size_t axis = 0);

}  // namespace veritope
