// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/patches/patch_knots.h: where B-spline surfaces that share sides must be cut so that their pieces share sides.
// Design: docs/design/0015-patch-complex.md.
#pragma once
#include <array>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "solids/patches/patch_sides.h"
#include "splines/bspline.h"

namespace veritope {

/// The breaks of the axes of several surfaces, each axis on [0,1].
struct CommonBreaks {
  std::vector<std::vector<Rational>> lists;           ///< ascending, with 0 and 1
  std::vector<std::array<std::uint32_t, 2>> list_of;  ///< of each surface's two axes
  const std::vector<Rational>& of(std::size_t surface, std::size_t axis) const {
    return lists[list_of[surface][axis]];
  }
};
/// The fewest breaks that contain each axis' own knots, such that two axes (or an axis and itself) along whose ends
/// equal curves run have the same breaks, reversed where the curves run in opposite directions. Collapsed sides tie no
/// axes. REQUIRES clamped axes, surfaces in space.
CommonBreaks common_breaks(std::span<const BSplineSurface<Rational>> surfaces);

namespace internal {

/// A B-spline curve on [0,1] whatever its degree and knots: the breaks at which the curve is not one polynomial, and a
/// form of each piece between them.
struct SplineCurveForm {
  std::vector<Rational> breaks;  ///< the inner breaks
  std::vector<CanonicalCurve> pieces;
  Travel travel = Travel::kForward;  ///< no part of the comparison

  friend std::strong_ordering operator<=>(const SplineCurveForm& a, const SplineCurveForm& b);
};
/// The forms of two curves are equal iff the curves are, in one of the two directions. Each piece of a rational curve
/// counts up to a factor of its own; a break where the factor jumps is kept.
SplineCurveForm canonical_spline(const BSplineCurve<Rational>& curve);
std::uint64_t hash_of(const SplineCurveForm& form);

}  // namespace internal

}  // namespace veritope
