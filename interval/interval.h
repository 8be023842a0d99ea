// SPDX-License-Identifier: LGPL-3.0-or-later
// interval/interval.h: sets of reals between two binary64 bounds. An interval is stored as (-lo, hi), so that
// rounding upward widens both ends. Design: docs/design/0005-intervals.md.
#pragma once
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
  constexpr explicit Interval(double v) : Interval(from_bounds(v, v)) {}
  /// REQUIRES lo <= hi, lo < +infinity, hi > -infinity; nums_to_interval of numeric.h checks.
  static constexpr Interval from_bounds(double lo, double hi) {
    return from_bits(internal::bits_of(lo), internal::bits_of(hi));
  }
  /// [lo, hi] from the bits of two numbers; also where flags let the compiler assume that no number is infinite.
  static constexpr Interval from_bits(internal::Bits lo, internal::Bits hi) {
    return Interval(internal::make_pair(internal::negated(lo), hi));
  }
  static constexpr Interval empty() {
    return Interval(internal::make_pair(internal::kEmptyBound, internal::kEmptyBound));
  }
  static constexpr Interval entire() {
    return Interval(internal::make_pair(internal::kInfiniteBits, internal::kInfiniteBits));
  }

  /// NaN if empty; inf and sup of numeric.h return what IEEE 1788 defines. Where the including file is compiled with
  /// -ffinite-math-only, an infinite or NaN double is undefined there: use the bits.
  double lo() const { return std::bit_cast<double>(lo_bits()); }
  double hi() const { return std::bit_cast<double>(hi_bits()); }
  internal::Bits lo_bits() const { return internal::negated(internal::first(v_)); }
  internal::Bits hi_bits() const { return internal::second(v_); }
  bool is_empty() const { return internal::is_nan(hi_bits()); }
  bool is_entire() const {
    return internal::is_infinite(hi_bits()) && internal::is_infinite(lo_bits());
  }

  friend Interval operator-(const Interval& a) { return Interval(internal::swapped(a.v_)); }
  friend Interval operator+(const Interval& a, const Interval& b) {
    return Interval(internal::added(a.v_, b.v_));
  }
  friend Interval operator-(const Interval& a, const Interval& b) {
    return Interval(internal::added(a.v_, internal::swapped(b.v_)));
  }
  friend Interval operator*(const Interval& a, const Interval& b) {
    // Each of the four products of bounds carries its sign in a factor, so that all round outward. A product 0 *
    // infinity stands for 0. If it is one of the first three, the other products cover the 0, and the maximum drops a
    // NaN on its left; the fourth has it replaced by 0. An empty operand makes all four NaN, and a NaN on the right
    // of the maximum stays.
    // Every combination of kinds of bounds: tests/interval/interval_law_test.cc.
    using internal::larger, internal::multiplied;
    const internal::Pair p = a.v_, q = internal::swapped(a.v_);
    const internal::Pair n = internal::both_first(b.v_), h = internal::both_second(b.v_);
    const internal::Pair fourth = internal::zero_for_made_nan(multiplied(internal::negated(h), q));
    return Interval(
        larger(multiplied(h, p),
               larger(multiplied(n, q), larger(multiplied(internal::negated(n), p), fourth))));
  }
  /// a * t for t >= 0, all bounds finite: two of the four products are enough. Equal to the product of intervals at
  /// lower cost.
  static Interval nonnegative_multiple(const Interval& a, const Interval& t) {
    using internal::larger, internal::multiplied;
    return Interval(larger(multiplied(internal::negated(internal::both_first(t.v_)), a.v_),
                           multiplied(internal::both_second(t.v_), a.v_)));
  }
  /// { x / y : x in a, y in b, y != 0 }: the hull where that is two pieces (reverse.h has both).
  friend Interval operator/(const Interval& a, const Interval& b) { return quotient(a, b); }
  friend Interval recip(const Interval& a) { return quotient(Interval(1.0), a); }

  /// { x^2 : x in a }, tighter than a * a when a contains numbers of both signs.
  friend Interval sqr(const Interval& a) {
    using internal::Pair;
    const Pair zero = internal::make_pair(0, 0), other = internal::swapped(a.v_);
    const Pair far = internal::larger(a.v_, other);  // max |x|, twice
    // min |x|, twice: minus the smaller of -lo and hi, where that is positive.
    const Pair near = internal::larger(zero, internal::negated(internal::smaller(a.v_, other)));
    const Pair ends = internal::low_and_high(near, far);
    return Interval(internal::multiplied(
        internal::flip(ends, internal::make_pair(internal::kSignBit, 0)), ends));
  }
  /// { square root of x : x in a, x >= 0 }.
  friend Interval sqrt(const Interval& a) { return square_root(a); }

  friend Interval& operator+=(Interval& a, const Interval& b) { return a = a + b; }
  friend Interval& operator-=(Interval& a, const Interval& b) { return a = a - b; }
  friend Interval& operator*=(Interval& a, const Interval& b) { return a = a * b; }
  friend Interval& operator/=(Interval& a, const Interval& b) { return a = a / b; }

  /// Equal as sets.
  friend bool operator==(const Interval& a, const Interval& b) {
    if (a.is_empty() || b.is_empty()) return a.is_empty() && b.is_empty();
    return internal::key_of(a.lo_bits()) == internal::key_of(b.lo_bits()) &&
           internal::key_of(a.hi_bits()) == internal::key_of(b.hi_bits());
  }

  /// The sign that all members have; uncertain if they differ, and for the empty set.
  Sign3 sign() const {
    if (is_empty()) return Sign3::kUncertain;
    const std::int64_t n = internal::key_of(internal::first(v_));
    const std::int64_t h = internal::key_of(internal::second(v_));
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
  using internal::Bits, internal::key_of;
  if (a.is_empty() || b.is_empty()) return empty();
  internal::Pair numerator = a.v_;
  Bits near = b.lo_bits(), far = b.hi_bits();
  if (key_of(far) <= 0) {  // a / b = (-a) / (-b)
    numerator = internal::swapped(numerator);
    near = internal::negated(b.hi_bits()), far = internal::negated(b.lo_bits());
  }
  if (key_of(far) == 0) return empty();
  if (key_of(near) < 0) return a.sign() == Sign3::kZero ? Interval() : entire();
  if (key_of(near) == 0) near = 0;  // not -0: a positive number / 0 shall be +infinity
  // 0 <= near <= far, far > 0: a positive end of the numerator goes farthest over near.
  return Interval(internal::divided(
      numerator, internal::make_pair(key_of(internal::first(numerator)) > 0 ? near : far,
                                     key_of(internal::second(numerator)) > 0 ? near : far)));
}

inline Interval Interval::square_root(const Interval& a) {
  using internal::Bits, internal::key_of;
  if (a.is_empty() || key_of(a.hi_bits()) < 0) return empty();
  const Bits least = key_of(a.lo_bits()) > 0 ? a.lo_bits() : 0;
  const internal::Pair roots = internal::square_root(internal::make_pair(least, a.hi_bits()));
  Bits low = internal::first(roots);
  // Roots are rounded upward. The square, rounded upward too, exceeds `least` iff the root exceeds the exact one.
  if (internal::less(least, internal::first(internal::multiplied(roots, roots)))) --low;
  return from_bits(low, internal::second(roots));
}

inline Sign3 sign_of(const Interval& a) { return a.sign(); }

/// Is x a member?
bool contains(const Interval& a, const Rational& x);
/// The narrowest interval that contains x.
Interval enclose(const Rational& x);
namespace internal {
/// Formats as printf does, but with a decimal point whatever the locale says.
std::string number_text(const char* format, double v);
}  // namespace internal

/// "[lo, hi]" with 17 digits each: enough to read the same bounds back; "[empty]".
std::string to_string(const Interval& a);

}  // namespace veritope
