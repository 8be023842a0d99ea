// SPDX-License-Identifier: LGPL-3.0-or-later
// robust/rational.h: exact fractions in lowest terms. They are slow and sure: for oracles, witnesses and reports, not
// for hot loops.
#pragma once
#include <compare>
#include <string>
#include <utility>

#include "robust/base/sign.h"
#include "robust/integer.h"

namespace veritope {

/// p / q with q > 0 and gcd(p, q) = 1; zero is 0 / 1.
class Rational {
 public:
  Rational() noexcept : den_(1) {}
  /// An integer converts exactly; a double converts exactly, too, but only by from_double.
  Rational(Integer numerator) noexcept : num_(std::move(numerator)), den_(1) {}
  template <BuiltinInteger T>
  Rational(T numerator) noexcept : num_(numerator), den_(1) {}
  /// REQUIRES denominator != 0; any sign.
  Rational(Integer numerator, Integer denominator);
  /// The exact value. REQUIRES a finite argument.
  static Rational from_double(double value);
  /// 2^n for n of either sign.
  static Rational power_of_two(std::int64_t n) noexcept;

  const Integer& numerator() const noexcept { return num_; }
  const Integer& denominator() const noexcept { return den_; }

  Rational& operator+=(const Rational& b) noexcept;
  Rational& operator-=(const Rational& b) noexcept;
  Rational& operator*=(const Rational& b) noexcept;
  /// REQUIRES b != 0.
  Rational& operator/=(const Rational& b);
  friend Rational operator+(Rational a, const Rational& b) noexcept { return a += b; }
  friend Rational operator-(Rational a, const Rational& b) noexcept { return a -= b; }
  friend Rational operator*(Rational a, const Rational& b) noexcept { return a *= b; }
  friend Rational operator/(Rational a, const Rational& b) { return a /= b; }
  friend Rational operator-(Rational a) noexcept { return a.negate(); }
  Rational& negate() noexcept;

  friend bool operator==(const Rational& a, const Rational& b) noexcept {
    return a.num_ == b.num_ && a.den_ == b.den_;
  }
  friend std::strong_ordering operator<=>(const Rational& a, const Rational& b) noexcept;

  Sign sign() const noexcept { return num_.sign(); }
  /// "p/q", or "p" when q = 1.
  std::string to_string() const;

 private:
  // Lowest terms, positive denominator. REQUIRES den_ != 0.
  Rational& canonicalise() noexcept;
  Rational& add(const Rational& b, bool is_difference) noexcept;

  Integer num_;
  Integer den_;
};

Rational abs(Rational a) noexcept;
inline Sign sign_of(const Rational& a) noexcept { return a.sign(); }

/// The binary64 number nearest to `a`, ties to even; infinity from the overflow threshold on, as IEEE 754 rounds. It
/// does not depend on the rounding mode.
double nearest_double(const Rational& a);
/// nearest_double of the quotient, without its lowest terms. REQUIRES denominator > 0.
double nearest_quotient(const Integer& numerator, const Integer& denominator);
/// The largest binary64 number <= a, and the least >= a; infinities where no finite one is.
double round_down(const Rational& a);
double round_up(const Rational& a);

}  // namespace veritope
