// SPDX-License-Identifier: LGPL-3.0-or-later
#include "interval/solvers/exact_bernstein.h"

#include <utility>

#include "interval/solvers/mp_restriction_internal.h"
#include "robust/base/check.h"
#include "splines/bezier_calculus.h"
#include "splines/bezier_degree.h"
#include "splines/bezier_product.h"

namespace veritope {

template <std::size_t N>
ExactPolynomial<N> product(const ExactPolynomial<N>& a, const ExactPolynomial<N>& b) {
  return multiplied(a, b);
}

template <std::size_t N>
ExactPolynomial<N> raised(const ExactPolynomial<N>& map, std::size_t axis) {
  return elevate(map, axis, 1);
}

template <std::size_t N>
ExactPolynomial<N> plus(const ExactPolynomial<N>& a, const ExactPolynomial<N>& b,
                        const Rational& k) {
  VT_CHECK(!a.is_rational() && !b.is_rational(), "a sum of coefficients of rational maps");
  auto [p, q] = to_common_degrees(a, b);
  for (std::size_t i = 0; i < p.coefficients().size(); ++i)
    p.coefficients()[i] += k * q.coefficients()[i];
  return std::move(p);
}

template <std::size_t N>
ExactPolynomial<N> derivative(const ExactPolynomial<N>& a, std::size_t axis) {
  return derivative<Rational, N>(a, axis);
}

template <std::size_t N>
Bezier<Interval, N> enclosed_on(const Bezier<Rational, N>& map, const ExactBox<N>& box,
                                int precision) {
  Bezier<Interval, N> out(map.degrees(), map.num_components(), map.is_rational());
  for (int c = 0; c < map.num_components(); ++c) {
    std::vector<MpInterval> values;
    for (const Rational& v : map.component(c)) values.emplace_back(v, precision);
    internal::restrict_to(values, map.grid(), box, precision);
    for (std::size_t i = 0; i < values.size(); ++i) out.component(c)[i] = values[i].to_interval();
  }
  return out;
}

#define VT_INSTANTIATE(N)                                                                    \
  template ExactPolynomial<N> product(const ExactPolynomial<N>&, const ExactPolynomial<N>&); \
  template ExactPolynomial<N> plus(const ExactPolynomial<N>&, const ExactPolynomial<N>&,     \
                                   const Rational&);                                         \
  template ExactPolynomial<N> derivative(const ExactPolynomial<N>&, std::size_t);            \
  template ExactPolynomial<N> raised(const ExactPolynomial<N>&, std::size_t);                \
  template Bezier<Interval, N> enclosed_on(const Bezier<Rational, N>&, const ExactBox<N>&, int);
VT_INSTANTIATE(1)
VT_INSTANTIATE(2)
VT_INSTANTIATE(3)
VT_INSTANTIATE(4)
#undef VT_INSTANTIATE

}  // namespace veritope
