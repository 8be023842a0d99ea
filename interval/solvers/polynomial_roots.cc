// SPDX-License-Identifier: LGPL-3.0-or-later
#include "interval/solvers/polynomial_roots.h"

#include <string>
#include <vector>

#include "interval/mp_interval.h"
#include "interval/solvers/root_isolation.h"
#include "robust/binary64.h"

namespace veritope {

Status check_options(const SolverOptions& options) {
  if (options.least_width.sign() != Sign::kPositive)
    return bad_argument("least_width is " + options.least_width.to_string() + ", not positive");
  if (options.root_width.sign() != Sign::kPositive)
    return bad_argument("root_width is " + options.root_width.to_string() + ", not positive");
  if (options.max_precision < 53 || options.max_precision > MpInterval::kMaxPrecision)
    return bad_argument("max_precision is " + std::to_string(options.max_precision) +
                        ", not 53 to 2^24");
  return ok_status();
}

template <std::size_t N>
Result<RootReport<N>> polynomial_roots(std::span<const Bezier<Rational, N>> equations,
                                       const SolverOptions& options) {
  if (const Status status = check_options(options); !status) return status.error();
  const Result<PolynomialSystem<N>> system = PolynomialSystem<N>::make(equations);
  if (!system) return system.error();
  if (system->zero_equation()) {
    RootReport<N> out;
    out.clusters.push_back({ExactBox<N>::unit(), OpenReason::kZeroEquation, {}});
    return out;
  }
  return isolate_roots<N>(*system, options);
}

template <std::size_t N>
Result<RootReport<N>> polynomial_roots(std::span<const Bezier<double, N>> equations,
                                       const SolverOptions& options) {
  std::vector<Bezier<Rational, N>> exact;
  for (const Bezier<double, N>& map : equations) {
    std::vector<Rational> values;
    for (const double c : map.coefficients()) {
      if (!is_finite(c))
        return Error{Code::kNotFinite,
                     {},
                     "coefficient " + std::to_string(values.size()) +
                         " of an equation is not a finite number"};
      values.push_back(Rational::from_double(c));
    }
    exact.emplace_back(map.degrees(), map.num_components(), map.is_rational(), std::move(values));
  }
  return polynomial_roots<N>(std::span<const Bezier<Rational, N>>(exact), options);
}

template <std::size_t N>
IsolatedRoot<N> refined(const PolynomialSystem<N>& system, IsolatedRoot<N> root,
                        const Rational& width, int max_precision) {
  VT_CHECK(width.sign() == Sign::kPositive, "a root cannot be refined to no width");
  const ScopedUpward upward;
  SolverEffort effort;
  refine_root(system, width, max_precision, root, effort);
  return root;
}

#define VT_INSTANTIATE(N)                                                                        \
  template Result<RootReport<N>> polynomial_roots(std::span<const Bezier<Rational, N>>,          \
                                                  const SolverOptions&);                         \
  template Result<RootReport<N>> polynomial_roots(std::span<const Bezier<double, N>>,            \
                                                  const SolverOptions&);                         \
  template IsolatedRoot<N> refined(const PolynomialSystem<N>&, IsolatedRoot<N>, const Rational&, \
                                   int);
VT_INSTANTIATE(1)
VT_INSTANTIATE(2)
VT_INSTANTIATE(3)
VT_INSTANTIATE(4)
#undef VT_INSTANTIATE

}  // namespace veritope
