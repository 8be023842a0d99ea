// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/micro/measure/gauss_rule_internal.h: Gauss-Legendre quadrature with enclosed nodes and weights, and enclosed
// values of Legendre polynomials. Internal to solids/micro/measure.
#pragma once
#include <cstddef>
#include <span>
#include <vector>

#include "interval/interval.h"

namespace veritope::internal {

/// The sum of weights[i] f(nodes[i]) is the integral of f over [-1, 1] for polynomials of degree 2n - 1 and less, n the
/// number of nodes.
struct GaussRule {
  std::vector<Interval> nodes, weights;  ///< nodes rise
};

/// The rule with n nodes, computed once. Each bound is next to the exact number or one further. May be called from
/// several threads. REQUIRES 1 <= n <= 512.
/// @cost  n^2 operations with 128 + 3n bits when a rule is made
const GaussRule& gauss_rule(std::size_t n);
/// The least rule that is exact for polynomials of this degree.
inline const GaussRule& gauss_rule_for(std::size_t degree) { return gauss_rule(degree / 2 + 1); }

/// P_0(x), P_1(x), ... for each member of x in [-1, 1]. Widths are at most approximately 1000 + k^2 times that of x and
/// of one rounding. REQUIRES at most 256 values, and a live ScopedUpward.
void legendre_values(const Interval& x, std::span<Interval> out);

}  // namespace veritope::internal
