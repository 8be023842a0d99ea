// SPDX-License-Identifier: LGPL-3.0-or-later
// interval/mp_interval.h: intervals whose bounds have as many bits as the caller asks for. MPFR [FHL07] is hidden
// behind this header. The operations work in any floating-point environment.
#pragma once
#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "interval/interval.h"
#include "robust/rational.h"

namespace veritope {

/// [lo, hi] with bounds of `precision` significant bits, or infinite; or empty. The laws are those of Interval: every
/// operation encloses, and each bound is the nearest such number outside. The result of an
/// operation has the larger precision of its operands. REQUIRES that this thread has MPFR's default
/// range of exponents: no underflow or overflow within 2^(+-2^30).
class MpInterval {
 public:
  static constexpr int kMinPrecision = 2, kMaxPrecision = 1 << 24;

  /// [0, 0]. REQUIRES here and below kMinPrecision <= precision <= kMaxPrecision.
  explicit MpInterval(int precision);
  /// The narrowest such interval around x; it is the same set if precision >= 53.
  MpInterval(const Interval& x, int precision);
  MpInterval(const Rational& x, int precision);
  MpInterval(const MpInterval& other);
  MpInterval(MpInterval&& other) noexcept;
  MpInterval& operator=(const MpInterval& other);
  MpInterval& operator=(MpInterval&& other) noexcept;
  ~MpInterval();
  static MpInterval empty(int precision);

  int precision() const;
  bool is_empty() const;
  /// The exact bound. REQUIRES nonempty, and finite on that side.
  Rational lo() const;
  Rational hi() const;
  bool has_lo() const;  ///< nonempty and bounded below
  bool has_hi() const;

  friend MpInterval operator-(const MpInterval& a);
  friend MpInterval operator+(const MpInterval& a, const MpInterval& b);
  friend MpInterval operator-(const MpInterval& a, const MpInterval& b);
  friend MpInterval operator*(const MpInterval& a, const MpInterval& b);
  /// The hull of the quotients; empty for b = [0, 0].
  friend MpInterval operator/(const MpInterval& a, const MpInterval& b);
  friend MpInterval sqr(const MpInterval& a);
  friend MpInterval sqrt(const MpInterval& a);
  /// For n < 0 there is one more rounding. REQUIRES n != INT64_MIN.
  friend MpInterval pown(const MpInterval& a, std::int64_t n);
  /// The elementary functions of functions.h, with their laws. The cost of sin and cos grows with the
  /// exponents of the bounds.
  friend MpInterval pow(const MpInterval& a, const MpInterval& b);
  friend MpInterval exp(const MpInterval& a);
  friend MpInterval sin(const MpInterval& a);
  friend MpInterval cos(const MpInterval& a);
  /// { |x| : x in a }, { min(x, y) }, { max(x, y) }.
  friend MpInterval abs(const MpInterval& a);
  friend MpInterval min(const MpInterval& a, const MpInterval& b);
  friend MpInterval max(const MpInterval& a, const MpInterval& b);
  static MpInterval pi(int precision);

  friend bool operator==(const MpInterval& a, const MpInterval& b);
  friend bool is_subset(const MpInterval& a, const MpInterval& b);
  friend MpInterval intersection(const MpInterval& a, const MpInterval& b);
  friend MpInterval hull(const MpInterval& a, const MpInterval& b);
  /// The sign of x - y for all members, or uncertain, like compare of relations.h.
  friend Sign3 compare(const MpInterval& a, const MpInterval& b);
  friend bool contains(const MpInterval& a, const Rational& x);
  /// The integer n for which n 2^exponent is nearest to x, ties to even, if all members x have the same one, and it
  /// fits int64_t; no value for the empty set.
  friend std::optional<std::int64_t> nearest_multiple(const MpInterval& a, int exponent);
  /// The sign that all members have, or uncertain.
  Sign3 sign() const;
  /// The narrowest Interval that contains it.
  Interval to_interval() const;

  class Bounds;  ///< two MPFR numbers

 private:
  explicit MpInterval(std::unique_ptr<Bounds> bounds);

  std::unique_ptr<Bounds> bounds_;
};

inline Sign3 sign_of(const MpInterval& a) { return a.sign(); }

}  // namespace veritope
