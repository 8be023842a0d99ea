// SPDX-License-Identifier: LGPL-3.0-or-later
#include "splines/composition_exact.h"

#include <algorithm>
#include <bit>
#include <iterator>
#include <limits>
#include <string>
#include <utility>

#include "robust/binary64.h"
#include "splines/composition.h"
#include "splines/composition_remainders.h"

namespace veritope {
namespace {

// values[i] = integers[i] * 2^exponent
struct Homogeneous {
  std::vector<Integer> integers;
  std::int64_t exponent = 0;
};

// The lowest set bit of all values; at most `most`.
std::int64_t lowest_exponent(std::span<const double> values, std::int64_t most) {
  std::int64_t lowest = most;
  for (const double v : values)
    if (const Binary64 parts = split(v); parts.mantissa != 0)
      lowest = std::min<std::int64_t>(
          lowest, parts.exponent + std::countr_zero(static_cast<std::uint64_t>(parts.mantissa)));
  return lowest == std::numeric_limits<std::int64_t>::max() ? 0 : lowest;
}

Homogeneous homogenised(std::span<const double> values, std::int64_t most) {
  Homogeneous out{{}, lowest_exponent(values, most)};
  for (const double v : values) {
    const Binary64 parts = split(v);
    Integer n(parts.mantissa);
    const std::int64_t shift = parts.exponent - out.exponent;
    if (shift >= 0) {
      n.shift_left(static_cast<std::uint64_t>(shift));
    } else {
      n.shift_right(static_cast<std::uint64_t>(-shift));  // zeros, by the choice of the exponent
    }
    out.integers.push_back(std::move(n));
  }
  return out;
}

// An upper bound of |scaled coefficients|. In Bernstein form the coefficients of a product are weighted means of
// products of coefficients, so none is larger than the product of the largest; the sum over k of C(a, k) |x|^k |q|^(a -
// k) is (|x| + |q|)^a.
template <std::size_t M, std::size_t N>
Integer largest_result(const internal::IntegerProblem<M, N>& problem,
                       std::span<const Integer> unscaled_x, std::span<const Integer> unscaled_q) {
  Integer bound(1);
  for (const Integer& p : problem.coefficients) bound = std::max(bound, abs(p));
  const std::size_t count = problem.inner_grid.count();
  for (std::size_t m = 0; m < M; ++m) {
    Integer largest(1);
    for (std::size_t i = m * count; i < (m + 1) * count; ++i)
      largest = std::max(largest, abs(unscaled_x[i]) + abs(unscaled_q[i]));
    for (int i = 0; i < problem.degrees[m]; ++i) bound *= largest;
  }
  for (const int n : composed_degrees(problem.degrees, problem.inner_degrees()))
    bound *= binomial_row(n)[static_cast<std::size_t>(n) / 2];
  return bound;
}

template <std::size_t M, std::size_t N>
std::vector<Integer> composed_integers(const internal::IntegerProblem<M, N>& problem) {
  using Algebra = internal::PlainAlgebra<Integer, N>;
  const Algebra algebra{Integer(1)};
  internal::InnerMap<Algebra, M> inner;
  const std::size_t count = problem.inner_grid.count();
  for (std::size_t m = 0; m < M; ++m) {
    const auto first = static_cast<std::ptrdiff_t>(m * count),
               last = static_cast<std::ptrdiff_t>((m + 1) * count);
    inner.x[m] = {problem.inner_grid, {problem.x.begin() + first, problem.x.begin() + last}};
    inner.q[m] = {problem.inner_grid, {problem.q.begin() + first, problem.q.begin() + last}};
  }
  const auto basis =
      internal::basis_polynomials(algebra, problem.degrees[M - 1], inner.x[M - 1], inner.q[M - 1]);
  const std::size_t net =
      problem.coefficients.size() / static_cast<std::size_t>(problem.num_components);
  std::vector<Integer> out;
  for (std::size_t c = 0; c < problem.coefficients.size(); c += net) {
    auto p = internal::compose_component<Algebra, M>(
        algebra, problem.degrees, std::span(problem.coefficients).subspan(c, net), inner, basis);
    std::move(p.c.begin(), p.c.end(), std::back_inserter(out));
  }
  return out;
}

}  // namespace

template <std::size_t M, std::size_t N>
Result<ScaledBezier<N>> internal::compose_exact_by(ExactWay way, const Bezier<double, M>& outer_map,
                                                   const Bezier<double, N>& inner) {
  if (Status status = internal::check_finite(outer_map.coefficients(), "outer"); !status)
    return status.error();
  if (Status status = internal::check_finite(inner.coefficients(), "inner"); !status)
    return status.error();
  const auto outer = with_weight_if(inner.is_rational(), outer_map, 1.0);
  if (Status status = check_composition(outer.degrees(), inner.degrees(), inner.dimension(),
                                        outer.num_components());
      !status)
    return status.error();

  constexpr std::int64_t kAny = std::numeric_limits<std::int64_t>::max();
  Homogeneous p = homogenised(outer.coefficients(), kAny);
  const Homogeneous t = homogenised(inner.coefficients(), inner.is_rational() ? kAny : 0);
  IntegerProblem<M, N> problem{
      outer.degrees(), outer.num_components(), inner.grid(), std::move(p.integers), {}, {}};
  const auto binomials = binomial_grid<Integer>(inner.grid());
  const std::size_t count = binomials.size();
  const Integer unit =
      inner.is_rational() ? Integer(0) : power_of_two(static_cast<std::uint64_t>(-t.exponent));
  std::vector<Integer> x, q;  // not scaled
  for (std::size_t i = 0; i < M * count; ++i) {
    const Integer& w = inner.is_rational() ? t.integers[M * count + i % count] : unit;
    x.push_back(t.integers[i]);
    q.push_back(w - t.integers[i]);
    problem.x.push_back(x.back() * binomials[i % count]);
    problem.q.push_back(q.back() * binomials[i % count]);
  }

  ScaledBezier<N> out{composed_degrees(outer.degrees(), inner.degrees()),
                      outer.num_components(),
                      outer.is_rational(),
                      p.exponent,
                      {}};
  for (const int a : outer.degrees()) out.exponent += a * t.exponent;
  const std::uint64_t bits = largest_result(problem, x, q).bit_length();
  const Bezier<double, N> shape(out.degrees, 0, false);
  const std::uint64_t results =
      shape.grid().count() * static_cast<std::uint64_t>(out.num_components);
  if (bits > kMaxExactBits / results)
    return Error{Code::kOverLimit,
                 {},
                 std::to_string(results) + " coefficients of up to " + std::to_string(bits) +
                     " bits are more than the limit of " + std::to_string(kMaxExactBits) + " bits"};
  const bool by_remainders =
      way == ExactWay::kRemainders || (way == ExactWay::kByBits && bits <= kMaxRemainderBits);
  out.scaled = by_remainders ? composed_by_remainders(problem, out.degrees, bits)
                             : composed_integers(problem);
  return out;
}

template <std::size_t M, std::size_t N>
Result<ScaledBezier<N>> compose_exact(const Bezier<double, M>& outer,
                                      const Bezier<double, N>& inner) {
  return internal::compose_exact_by(internal::ExactWay::kByBits, outer, inner);
}

template <std::size_t N>
Bezier<Rational, N> ScaledBezier<N>::to_rational() const {
  Bezier<Rational, N> map(degrees, num_components, is_rational);
  const auto scales = internal::binomial_grid<Integer>(map.grid());
  for (std::size_t i = 0; i < scaled.size(); ++i) {
    Integer numerator = scaled[i], denominator = scales[i % scales.size()];
    if (exponent >= 0) {
      numerator.shift_left(static_cast<std::uint64_t>(exponent));
    } else {
      denominator.shift_left(static_cast<std::uint64_t>(-exponent));
    }
    map.coefficients()[i] = Rational(std::move(numerator), std::move(denominator));
  }
  return map;
}

template struct ScaledBezier<1>;
template struct ScaledBezier<2>;
template struct ScaledBezier<3>;
#define VT_COMPOSE_EXACT(M, N)                                              \
  template Result<ScaledBezier<N>> compose_exact(const Bezier<double, M>&,  \
                                                 const Bezier<double, N>&); \
  template Result<ScaledBezier<N>> internal::compose_exact_by(              \
      internal::ExactWay, const Bezier<double, M>&, const Bezier<double, N>&);
VT_COMPOSE_EXACT(1, 1)
VT_COMPOSE_EXACT(1, 2)
VT_COMPOSE_EXACT(1, 3)
VT_COMPOSE_EXACT(2, 1)
VT_COMPOSE_EXACT(2, 2)
VT_COMPOSE_EXACT(2, 3)
VT_COMPOSE_EXACT(3, 1)
VT_COMPOSE_EXACT(3, 2)
VT_COMPOSE_EXACT(3, 3)
#undef VT_COMPOSE_EXACT

}  // namespace veritope
