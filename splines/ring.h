// SPDX-License-Identifier: LGPL-3.0-or-later
// splines/ring.h: what the algebra of splines asks of its numbers. It adds, subtracts and multiplies
// them and never compares them, so that double, Interval and Rational will all do.
#pragma once
#include <concepts>
#include <cstdint>

#include "robust/base/check.h"
#include "robust/integer.h"
#include "robust/rational.h"

namespace veritope {

/// Where the numbers of a ring come from. A specialisation has
///   using Knot                       the type of knots: exact numbers with an order
///   static R ratio(p, q)             p / q of integers, q > 0
///   static R fraction(t, a, b)       (t - a) / (b - a) of a parameter t and knots a < b
///   static R of_knot(k)              the knot as a number of the ring
/// exactly, rounded to nearest, or enclosed, as the ring can. Every specialisation is here or in the one header
/// that makes the type a ring (Interval: interval/ring_numbers.h): two translation units must not see different ones.
template <typename R>
struct RingNumbers;

template <typename R>
concept Ring = std::copyable<R> && requires(const R& a, const R& b) {
  R();  // zero
  { a + b } -> std::convertible_to<R>;
  { a - b } -> std::convertible_to<R>;
  { a* b } -> std::convertible_to<R>;
  { -a } -> std::convertible_to<R>;
  typename RingNumbers<R>::Knot;
};

template <>
struct RingNumbers<double> {
  using Knot = double;
  /// Rounded once if p and q are below 2^53.
  static double ratio(std::int64_t p, std::int64_t q) {
    return static_cast<double>(p) / static_cast<double>(q);
  }
  static double fraction(double t, double a, double b) { return (t - a) / (b - a); }
  static double of_knot(double k) { return k; }
};

template <>
struct RingNumbers<Rational> {
  using Knot = Rational;
  static Rational ratio(std::int64_t p, std::int64_t q) { return Rational(p) / Rational(q); }
  static Rational fraction(const Rational& t, const Rational& a, const Rational& b) {
    return (t - a) / (b - a);
  }
  static Rational of_knot(const Rational& k) { return k; }
};

/// No fraction is a number of this ring. REQUIRES ratios and knots that are integers.
template <>
struct RingNumbers<Integer> {
  using Knot = Rational;
  static Integer ratio(std::int64_t p, std::int64_t q) {
    VT_CHECK(p % q == 0, "a fraction is no number of the ring of integers");
    return Integer(p / q);
  }
  static Integer of_knot(const Rational& k) {
    VT_CHECK(k.denominator() == Integer(1), "a fraction is no number of the ring of integers");
    return k.numerator();
  }
};

/// a + t (b - a), evaluated as (1 - t) a + t b: exact at t = 0 and t = 1 in every ring.
template <Ring R>
R blend(const R& a, const R& b, const R& one_minus_t, const R& t) {
  return one_minus_t * a + t * b;
}

/// The number 1.
template <Ring R>
R one() {
  return RingNumbers<R>::ratio(1, 1);
}

}  // namespace veritope
