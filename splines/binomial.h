// SPDX-License-Identifier: LGPL-3.0-or-later
// splines/binomial.h: binomial coefficients of any size, exact, and as numbers of a ring; other exact fractions as
// numbers of a ring.
#pragma once
#include <concepts>
#include <cstdint>
#include <vector>

#include "robust/integer.h"
#include "robust/rational.h"
#include "splines/ring.h"

namespace veritope {

/// C(n, 0), ..., C(n, n). REQUIRES n >= 0.
inline std::vector<Integer> binomial_row(int n) {
  std::vector<Integer> row{Integer(1)};
  for (int i = 0; i < n; ++i)
    row.push_back(divide_exactly(row.back() * Integer(n - i), Integer(i + 1)));
  return row;
}

namespace internal {
/// The integer as a knot: exact, or the double next to it.
template <typename Knot>
Knot knot_of(const Integer& n) {
  if constexpr (std::same_as<Knot, double>) {
    return nearest_double(Rational(n));
  } else {
    return Knot(Rational(n));
  }
}
template <Ring R>
R divided(const R& value, const typename RingNumbers<R>::Knot& by) {
  return RingNumbers<R>::fraction(value, knot_of<typename RingNumbers<R>::Knot>(Integer(0)), by);
}
}  // namespace internal

/// n over k; 0 for k < 0 and k > n. REQUIRES n >= 0.
Integer binomial(int n, int k);

/// The greatest n such that all n over k are below 2^63.
inline constexpr int kMaxBinomialRow = 66;
/// The binomial coefficient as an integer. REQUIRES 0 <= n <= kMaxBinomialRow.
std::int64_t binomial_int64(int n, int k);

/// A fraction as a number of the ring: exact, nearest, or enclosed, as RingNumbers says.
template <Ring R>
R ring_number(const Rational& q) {
  if constexpr (std::same_as<typename RingNumbers<R>::Knot, Rational>) {
    return RingNumbers<R>::of_knot(q);
  } else {
    return RingNumbers<R>::of_knot(nearest_double(q));
  }
}

/// n over k in the ring; rings of double round it once. REQUIRES n >= 0.
template <Ring R>
R binomial_in(int n, int k) {
  if (n <= kMaxBinomialRow) return RingNumbers<R>::ratio(binomial_int64(n, k), 1);
  return ring_number<R>(Rational(binomial(n, k)));
}
/// 1 / (n over k); rings of double round it at most twice. REQUIRES 0 <= k <= n.
template <Ring R>
R inverse_binomial_in(int n, int k) {
  if (n <= kMaxBinomialRow) return RingNumbers<R>::ratio(1, binomial_int64(n, k));
  return ring_number<R>(Rational(Integer(1), binomial(n, k)));
}

namespace internal {
/// binomial_in<R>(n, k), computed once in each thread, for code that asks for the same few very often. REQUIRES 0 <= k
/// <= n.
template <Ring R>
const R& known_binomial(int n, int k) {
  static thread_local std::vector<std::vector<R>> rows;
  while (rows.size() <= static_cast<std::size_t>(n)) {
    const int m = static_cast<int>(rows.size());
    std::vector<R>& row = rows.emplace_back();
    for (int j = 0; j <= m; ++j) row.push_back(binomial_in<R>(m, j));
  }
  return rows[static_cast<std::size_t>(n)][static_cast<std::size_t>(k)];
}
}  // namespace internal

/// (p over i) (q over j) / (p + q over i + j), which is at most 1: the factor of a_i b_j in coefficient i + j of the
/// product of polynomials of degrees p and q in Bernstein form. Rings of double round it at most three times. REQUIRES
/// 0 <= i <= p, 0 <= j <= q.  Source: [FR88].
template <Ring R>
R product_weight(int p, int i, int q, int j) {
  if (p + q <=
      kMaxBinomialRow)  // the numerator is one term of Vandermonde's sum for the denominator
    return RingNumbers<R>::ratio(binomial_int64(p, i) * binomial_int64(q, j),
                                 binomial_int64(p + q, i + j));
  return ring_number<R>(Rational(binomial(p, i) * binomial(q, j), binomial(p + q, i + j)));
}

}  // namespace veritope
