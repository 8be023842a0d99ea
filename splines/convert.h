// SPDX-License-Identifier: LGPL-3.0-or-later
// splines/convert.h: maps over the rationals as the nearest maps over double, and back exactly. N = 1, 2, 3.
#pragma once
#include <cstddef>

#include "robust/base/result.h"
#include "splines/bezier.h"
#include "splines/bspline.h"

namespace veritope {

/// Rounds every coefficient to nearest.
/// @error kNotFinite, with the coefficient, if one rounds to infinity; kLossy if a weight that is not 0 rounds to 0.
template <std::size_t N>
Result<Bezier<double, N>> nearest_double(const Bezier<Rational, N>& map);
/// Rounds every coefficient and knot to nearest. An axis stays periodic if its rounded knots repeat exactly, and
/// becomes an unclamped one otherwise.
/// @error as above; kNotFinite for a knot; kLossy, with the knot, if different knots become equal.
template <std::size_t N>
Result<BSpline<double, N>> nearest_double(const BSpline<Rational, N>& map);

/// Keeps the numbers. @error kNotFinite, with the coefficient, if one is not finite.
template <std::size_t N>
Result<Bezier<Rational, N>> exact(const Bezier<double, N>& map);
/// Keeps the numbers; make_bspline accepts them. @error kNotFinite, with the coefficient or knot; what make_bspline
/// refuses.
template <std::size_t N>
Result<BSpline<Rational, N>> exact(const BSpline<double, N>& map);

}  // namespace veritope
