// SPDX-License-Identifier: LGPL-3.0-or-later
// splines/bspline_make.h: B-splines from data that may be wrong.
#pragma once
#include <array>
#include <cstddef>
#include <vector>

#include "robust/base/result.h"
#include "splines/bspline.h"

namespace veritope {

/// The B-spline, if the data describe one; N = 1, 2, 3. make_knot_axis must accept the axes; every component and
/// control point needs a coefficient; a rational map needs at least one component besides the weight, and every weight
/// positive; along a periodic axis of degree p the last p control points must equal the first p.
/// @error kBadArgument or kOverLimit, with the axis, the index of the knot or control point, from 0, and the value.
template <std::size_t N>
Result<BSpline<Rational, N>> make_bspline(std::array<KnotAxis<Rational>, N> axes,
                                          int num_components, bool is_rational,
                                          std::vector<Rational> coefficients);

}  // namespace veritope
