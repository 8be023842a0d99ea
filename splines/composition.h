// SPDX-License-Identifier: LGPL-3.0-or-later
// splines/composition.h: T(t(...)) of Bezier maps as a Bezier map: curves, surfaces and volumes in volumes and
// surfaces, over any ring. With an error bound in double: composition_bounded.h; exact and fast: composition_exact.h;
// in B-splines: composition_span.h. Design: docs/design/0009-composition.md.
#pragma once
#include <array>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "robust/base/result.h"
#include "splines/bezier.h"
#include "splines/composition_nested.h"
#include "splines/scaled_polynomial.h"

namespace veritope {

/// The limit on coefficients, counted over all components of a composed map.
inline constexpr std::size_t kMaxComposedCoefficients = std::size_t{1} << 24;

/// The degrees of the composed map: those of the inner one, each times the sum of the outer ones.
template <std::size_t M, std::size_t N>
std::array<int, N> composed_degrees(const std::array<int, M>& outer,
                                    const std::array<int, N>& inner) {
  int sum = 0;
  for (const int a : outer) sum += a;
  std::array<int, N> out;
  for (std::size_t j = 0; j < N; ++j) out[j] = inner[j] * sum;
  return out;
}

namespace internal {

/// What every composition refuses.
/// @error kBadArgument if the inner map's points do not have as many coordinates as the outer map has variables;
///        kOverLimit over kMaxComposedCoefficients.
Status check_composition(std::span<const int> outer_degrees, std::span<const int> inner_degrees,
                         int inner_dimension, int num_components);
/// @error kNotFinite with the first such coefficient's number.
Status check_finite(std::span<const double> coefficients, const char* which_map);

/// The outer map, with a weight of 1 if only the inner one is rational: its composition is w^(sum of degrees).
template <Ring R, std::size_t M>
Bezier<R, M> with_weight_if(bool inner_is_rational, const Bezier<R, M>& outer, const R& unit) {
  if (!inner_is_rational || outer.is_rational()) return outer;
  std::vector<R> c(outer.coefficients().begin(), outer.coefficients().end());
  c.resize(c.size() + outer.grid().count(), unit);
  return Bezier<R, M>(outer.degrees(), outer.num_components() + 1, true, std::move(c));
}

}  // namespace internal

/// The map x -> outer(inner(x)), of the degrees composed_degrees(). If one of the two is rational, so is the result
/// (homogeneous: if only the inner one is, the weight is the inner weight to the power of the sum of the outer
/// degrees). The inner map may leave [0,1]^M. Exact for Rational, an enclosure for Interval; for double no bound is
/// given: see composition_bounded.h.
/// @error as internal::check_composition says.
/// @cost  see composition_nested.h; Rational numbers are for small degrees
template <Ring R, std::size_t M, std::size_t N>
Result<Bezier<R, N>> compose(const Bezier<R, M>& outer_map, const Bezier<R, N>& inner) {
  const Bezier<R, M> outer = internal::with_weight_if(inner.is_rational(), outer_map, one<R>());
  if (Status status = internal::check_composition(outer.degrees(), inner.degrees(),
                                                  inner.dimension(), outer.num_components());
      !status)
    return status.error();
  using Knot = typename RingNumbers<R>::Knot;
  using Algebra = internal::PlainAlgebra<R, N>;
  const Algebra algebra{one<R>()};
  internal::InnerMap<Algebra, M> prepared;
  const auto binomials = internal::binomial_grid<Knot>(inner.grid());
  for (std::size_t m = 0; m < M; ++m) {
    prepared.x[m].grid = prepared.q[m].grid = inner.grid();
    for (std::size_t i = 0; i < binomials.size(); ++i) {
      const R& x = inner.component(static_cast<int>(m))[i];
      const R w = inner.is_rational() ? inner.component(static_cast<int>(M))[i] : one<R>();
      const R b = RingNumbers<R>::of_knot(binomials[i]);
      prepared.x[m].c.push_back(b * x);
      prepared.q[m].c.push_back(b * (w - x));
    }
  }
  const auto basis = internal::basis_polynomials(algebra, outer.degrees()[M - 1], prepared.x[M - 1],
                                                 prepared.q[M - 1]);
  Bezier<R, N> out(composed_degrees(outer.degrees(), inner.degrees()), outer.num_components(),
                   outer.is_rational());
  const auto scales = internal::binomial_grid<Knot>(out.grid());
  for (int c = 0; c < outer.num_components(); ++c) {
    const auto p = internal::compose_component<Algebra, M>(algebra, outer.degrees(),
                                                           outer.component(c), prepared, basis);
    for (std::size_t i = 0; i < scales.size(); ++i)
      out.component(c)[i] = internal::divided<R>(p.c[i], scales[i]);
  }
  return out;
}

}  // namespace veritope
