// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/micro/measure/node_basis_internal.h"

#include "solids/micro/measure/gauss_rule_internal.h"
#include "splines/binomial.h"

namespace veritope::internal {
namespace {

std::vector<Interval> bernstein_values(int degree, const Interval& x) {
  const auto n = static_cast<std::size_t>(degree);
  const Interval y = Interval(1.0) - x;
  std::vector<Interval> out(n + 1, Interval(1.0));
  for (std::size_t i = 0; i <= n; ++i) {
    out[i] = enclose(Rational(binomial(degree, static_cast<int>(i))));
    for (std::size_t k = 0; k < n; ++k) out[i] = out[i] * (k < i ? x : y);
  }
  return out;
}

}  // namespace

NodeBasis node_basis(int degree, std::size_t integrand_degree) {
  const GaussRule& rule = gauss_rule_for(integrand_degree);
  const auto n = static_cast<std::size_t>(degree);
  NodeBasis out;
  for (std::size_t g = 0; g < rule.nodes.size(); ++g) {
    const Interval x = Interval(0.5) * (Interval(1.0) + rule.nodes[g]);
    out.weights.push_back(Interval(0.5) * rule.weights[g]);
    out.value.push_back(bernstein_values(degree, x));
    const auto lower = bernstein_values(degree - 1, x);
    auto& slope = out.slope.emplace_back(n + 1);
    for (std::size_t i = 0; i <= n; ++i) {
      if (i > 0) slope[i] += lower[i - 1];
      if (i < n) slope[i] -= lower[i];
      slope[i] *= Interval(static_cast<double>(n));
    }
  }
  return out;
}

}  // namespace veritope::internal
