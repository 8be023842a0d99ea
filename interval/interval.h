// SPDX-License-Identifier: LGPL-3.0-or-later
// interval/interval.h: sets of reals between two binary64 bounds. Held as (-lo, hi), so that
// rounding upward widens both ends. Design: docs/design/0005-intervals.md.
#pragma once
#include <limits>
#include <string>

#include "interval/bound_pair.h"
#include "robust/base/sign.h"
#include "robust/rational.h"

namespace veritope {

/// [lo, hi] = { x real : lo <= x <= hi }, or empty; lo may be -infinity and hi +infinity.
/// Operations enclose: x in a, y in b implies x op y in a op b where that is defined, overflow and
/// underflow included; each bound of + - * / sqr recip sqrt is the nearest binary64 number outside,
/// and the result is empty iff no x op y is defined.
/// REQUIRES for + - * / sqr recip sqrt a live ScopedUpward in this thread. Everything else (also
/// relations.h, numeric.h, functions.h) works in any floating-point environment.
/// Cost, in cache, one thread: + 0.3 ns, * 1.1 ns (design note).
class Interval {
 public:
  /// [0, 0].
  constexpr Interval() : v_(internal::make_pair(0, 0)) {}
  /// The one point v. REQUIRES finite.
  constexpr explicit Interval(double v) : v_(internal::make_pair(internal::negated(v), v)) {}
  /// REQUIRES lo <= hi, lo < +infinity, hi > -infinity; numbers.h checks.
  static constexpr Interval from_bounds(double lo, double hi) {
    return Interval(internal::make_pair(internal::negated(lo), hi));
  }
  static constexpr Interval empty() {
    return Interval(internal::make_pair(internal::kEmptyBound, internal::kEmptyBound));
  }
  static constexpr Interval entire() {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    return Interval(internal::make_pair(infinity, infinity));
  }

  /// NaN if empty; inf and sup of numeric.h say what IEEE 1788 says.
  double lo() const { return internal::negated(internal::first(v_)); }
  double hi() const { return internal::second(v_); }
  bool is_empty() const { return internal::is_nan(hi()); }
  bool is_entire() const { return internal::is_infinite(hi()) && internal::is_infinite(lo()); }

  friend Interval operator-(const Interval& a) { return Interval(internal::swapped(a.v_)); }
  friend Interval operator+(const Interval& a, const Interval& b) {
    return Interval(internal::added(a.v_, b.v_));
  }
  friend Interval operator-(const Interval& a, const Interval& b) {
    return Interval(internal::added(a.v_, internal::swapped(b.v_)));
  }
  friend Interval operator*(const Interval& a, const Interval& b) {
    // The four products of bounds, each with its sign in a factor, so that all round outward.
    // One that is 0 * infinity stands for 0. Where it is one of the first three, the other products
    // cover the 0, and the maximum drops a NaN on its left. The fourth is mended. An empty operand
    // makes all NaN, the fourth too, and a NaN on the right stays.
    // Every combination of kinds of bounds: tests/interval/interval_law_test.cc.
    using internal::larger, internal::multiplied;
    const internal::Pair p = a.v_, q = internal::swapped(a.v_);
    const internal::Pair n = internal::both_first(b.v_), h = internal::both_second(b.v_);
    const internal::Pair fourth = internal::zero_for_made_nan(multiplied(internal::negated(h), q));
    return Interval(
        larger(multiplied(h, p),
               larger(multiplied(n, q), larger(multiplied(internal::negated(n), p), fourth))));
  }
  /// { x / y : x in a, y in b, y != 0 }: the hull where that is two pieces (reverse.h has both).
  friend Interval operator/(const Interval& a, const Interval& b) { return quotient(a, b); }
  friend Interval recip(const Interval& a) { return quotient(Interval(1.0), a); }

  /// { x^2 : x in a }, tighter than a * a when a contains numbers of both signs.
  friend Interval sqr(const Interval& a) {
    const internal::Pair other = internal::swapped(a.v_);
    const internal::Pair far = internal::larger(a.v_, other);  // max |x|
    // min |x|: minus the smaller of -lo and hi, where that is positive.
    const internal::Pair near = internal::larger(internal::make_pair(0, 0),
                                                 internal::negated(internal::smaller(a.v_, other)));
    return Interval(internal::multiplied(
        internal::make_pair(internal::negated(internal::first(near)), internal::first(far)),
        internal::make_pair(internal::first(near), internal::first(far))));
  }
  /// { root of x : x in a, x >= 0 }.
  friend Interval sqrt(const Interval& a) { return square_root(a); }

  friend Interval& operator+=(Interval& a, const Interval& b) { return a = a + b; }
  friend Interval& operator-=(Interval& a, const Interval& b) { return a = a - b; }
  friend Interval& operator*=(Interval& a, const Interval& b) { return a = a * b; }
  friend Interval& operator/=(Interval& a, const Interval& b) { return a = a / b; }

  /// The same set.
  friend bool operator==(const Interval& a, const Interval& b) {
    if (a.is_empty() || b.is_empty()) return a.is_empty() && b.is_empty();
    return internal::order_key(a.lo()) == internal::order_key(b.lo()) &&
           internal::order_key(a.hi()) == internal::order_key(b.hi());
  }

  /// The sign that all members have, or uncertain; uncertain if there is none.
  Sign3 sign() const {
    if (is_empty()) return Sign3::kUncertain;
    const std::int64_t n = internal::order_key(internal::first(v_));
    const std::int64_t h = internal::order_key(internal::second(v_));
    if (n < 0) return Sign3::kPositive;
    if (h < 0) return Sign3::kNegative;
    return n == 0 && h == 0 ? Sign3::kZero : Sign3::kUncertain;
  }

 private:
  friend class NearestInterval;
  constexpr explicit Interval(internal::Pair v) : v_(v) {}
  static Interval quotient(const Interval& a, const Interval& b);
  static Interval square_root(const Interval& a);

  internal::Pair v_;
};

inline Interval Interval::quotient(const Interval& a, const Interval& b) {
  if (a.is_empty() || b.is_empty()) return empty();
  internal::Pair numerator = a.v_;
  double near = b.lo(), far = b.hi();
  if (internal::order_key(far) <= 0) {  // a / b = (-a) / (-b)
    numerator = internal::swapped(numerator);
    near = internal::negated(b.hi()), far = internal::negated(b.lo());
  }
  const std::int64_t near_key = internal::order_key(near);
  if (internal::order_key(far) == 0) return empty();
  if (near_key < 0) return a.sign() == Sign3::kZero ? Interval() : entire();
  if (near_key == 0) near = 0;  // not -0: a positive number / 0 shall be +infinity
  // 0 <= near <= far, far > 0: a positive end of the numerator goes farthest over near.
  const double n = internal::first(numerator), h = internal::second(numerator);
  return Interval(
      internal::divided(numerator, internal::make_pair(internal::order_key(n) > 0 ? near : far,
                                                       internal::order_key(h) > 0 ? near : far)));
}

inline Interval Interval::square_root(const Interval& a) {
  if (a.is_empty() || internal::order_key(a.hi()) < 0) return empty();
  double low = 0;
  if (internal::order_key(a.lo()) > 0) {
    low = internal::square_root(a.lo());
    // Rounded upward: the square, rounded upward too, exceeds lo iff the root does.
    const internal::Pair r = internal::make_pair(low, low);
    if (internal::less(a.lo(), internal::first(internal::multiplied(r, r))))
      low = std::bit_cast<double>(std::bit_cast<std::uint64_t>(low) - 1);
  }
  return Interval::from_bounds(low, internal::square_root(a.hi()));
}

inline Sign3 sign_of(const Interval& a) { return a.sign(); }

/// Is x a member?
bool contains(const Interval& a, const Rational& x);
/// The narrowest interval around x.
Interval enclose(const Rational& x);
/// "[lo, hi]" with 17 digits each: enough to read the same bounds back; "[empty]".
std::string to_string(const Interval& a);

}  // namespace veritope
