// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/micro/measure/node_basis_internal.h: Bernstein polynomials at the nodes of Gauss rules. Internal to
// solids/micro/measure.
#pragma once
#include <cstddef>
#include <vector>

#include "interval/interval.h"

namespace veritope::internal {

/// Bernstein polynomials and their derivatives at the nodes of a rule, brought to [0, 1].
struct NodeBasis {
  std::vector<Interval> weights;                    ///< half of the rule's
  std::vector<std::vector<Interval>> value, slope;  ///< by nodes
};
/// The rule is the least one that is exact for polynomials of `integrand_degree`. REQUIRES degree >= 1, and a live
/// ScopedUpward.
NodeBasis node_basis(int degree, std::size_t integrand_degree);

}  // namespace veritope::internal
