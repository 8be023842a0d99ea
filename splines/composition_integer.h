// SPDX-License-Identifier: LGPL-3.0-or-later
// splines/composition_integer.h: composition of rational Bezier maps by integers: denominators are cleared first, and
// divided out of the result, so that no greatest common divisor is taken on the way. Design:
// docs/design/0083-curves-and-sheets.md.
#pragma once
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

#include "robust/base/check.h"
#include "splines/composition.h"

namespace veritope {

namespace internal {

/// Numbers as integers over their least common denominator.
struct ClearedNumbers {
  std::vector<Integer> numerators;
  Integer denominator = Integer(1);
};
template <typename Range>
ClearedNumbers cleared(const Range& numbers) {
  ClearedNumbers out;
  for (const Rational& x : numbers) out.denominator = lcm(out.denominator, x.denominator());
  for (const Rational& x : numbers)
    out.numerators.push_back(x.numerator() * divide_exactly(out.denominator, x.denominator()));
  return out;
}

}  // namespace internal

/// The result of compose(outer, inner), coefficient by coefficient. REQUIRES an inner map that is not rational.
/// @error as compose
/// @cost  products of integers; a greatest common divisor for each coefficient of the result. With short denominators
///        of the inner map a fraction of the time of compose; a common denominator of unrelated ones may be long
template <std::size_t M, std::size_t N>
Result<Bezier<Rational, N>> compose_by_integers(const Bezier<Rational, M>& outer,
                                                const Bezier<Rational, N>& inner) {
  if (Status status = internal::check_composition(outer.degrees(), inner.degrees(),
                                                  inner.dimension(), outer.num_components());
      !status)
    return status.error();
  VT_CHECK(!inner.is_rational(), "the inner map of a composition by integers is polynomial");
  using Algebra = internal::PlainAlgebra<Integer, N>;
  const Algebra algebra{one<Integer>()};
  internal::InnerMap<Algebra, M> prepared;
  const auto binomials = internal::binomial_grid<Rational>(inner.grid());
  // Each term of the result has a_m factors that belong to the variable m, each over its denominator.
  Integer powers(1);
  for (std::size_t m = 0; m < M; ++m) {
    const internal::ClearedNumbers x = internal::cleared(inner.component(static_cast<int>(m)));
    prepared.x[m].grid = prepared.q[m].grid = inner.grid();
    for (std::size_t i = 0; i < binomials.size(); ++i) {
      const Integer b = RingNumbers<Integer>::of_knot(binomials[i]);
      prepared.x[m].c.push_back(b * x.numerators[i]);
      prepared.q[m].c.push_back(b * (x.denominator - x.numerators[i]));
    }
    for (int k = 0; k < outer.degree(m); ++k) powers = powers * x.denominator;
  }
  const auto basis = internal::basis_polynomials(algebra, outer.degrees()[M - 1], prepared.x[M - 1],
                                                 prepared.q[M - 1]);
  Bezier<Rational, N> out(composed_degrees(outer.degrees(), inner.degrees()),
                          outer.num_components(), outer.is_rational());
  const auto scales = internal::binomial_grid<Rational>(out.grid());
  for (int c = 0; c < outer.num_components(); ++c) {
    const internal::ClearedNumbers net = internal::cleared(outer.component(c));
    const auto p = internal::compose_component<Algebra, M>(algebra, outer.degrees(), net.numerators,
                                                           prepared, basis);
    const Integer scale = powers * net.denominator;
    for (std::size_t i = 0; i < scales.size(); ++i)
      out.component(c)[i] = Rational(p.c[i], scale * RingNumbers<Integer>::of_knot(scales[i]));
  }
  return out;
}

}  // namespace veritope
