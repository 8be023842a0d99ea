// SPDX-License-Identifier: LGPL-3.0-or-later
// splines/composition_bounded.h: composition of Bezier maps in binary64, with a proven bound of the error of every
// coefficient. Bound: docs/bounds/composition.md.
#pragma once
#include <vector>

#include "robust/base/result.h"
#include "splines/bezier.h"

namespace veritope {

/// Each coefficient of the exact map differs from that of `map` by at most the number in its place in `error`, which is
/// infinite where a number overflowed.
template <std::size_t N>
struct BoundedBezier {
  Bezier<double, N> map;
  std::vector<double> error;
};

/// outer(inner(x)): the map and degrees that compose() of splines/composition.h says, for the doubles as they are
/// given. The rounding mode of the calling thread does not matter.
/// A bound is at most approximately k 2^-53 times the composition of the absolute values (docs/bounds/composition.md; k
/// = 149 for two maps of degree 3 in 3 variables). If the inner map's net lies in [0,1]^M, it is at most k 2^-53 times
/// the largest coefficients nearby.
/// @error as compose(); kNotFinite with the offending coefficient's number; kBadEnvironment in a build without IEEE
///        arithmetic.
/// @cost  twice the products of numbers of compose(); half of that for components whose coefficients all have one sign
///        if 0 <= x <= w holds for all coefficients x of the inner map and their weights w
template <std::size_t M, std::size_t N>
Result<BoundedBezier<N>> compose_bounded(const Bezier<double, M>& outer,
                                         const Bezier<double, N>& inner);

namespace internal {

/// The most roundings that a coefficient's monomials go through: docs/bounds/composition.md, section 2.
template <std::size_t M, std::size_t N>
int composition_roundings(const std::array<int, M>& outer, const std::array<int, N>& inner);

}  // namespace internal
}  // namespace veritope
