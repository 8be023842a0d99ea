// SPDX-License-Identifier: LGPL-3.0-or-later
// robust/dyadic.h: m * 2^e, a ring that contains every finite binary64 number. It has no division and so needs no
// common denominators.
#pragma once
#include <compare>
#include <cstdint>
#include <string>
#include <utility>

#include "robust/base/sign.h"
#include "robust/integer.h"
#include "robust/rational.h"

namespace veritope {

/// mantissa * 2^exponent with an odd mantissa; zero is 0 * 2^0.
class Dyadic {
 public:
  Dyadic() = default;
  /// mantissa * 2^exponent. An integer converts implicitly; a double does not: use from_double.
  Dyadic(Integer mantissa, std::int64_t exponent = 0);
  template <BuiltinInteger T>
  Dyadic(T mantissa, std::int64_t exponent = 0) : Dyadic(Integer(mantissa), exponent) {}
  /// The exact value. REQUIRES a finite argument.
  static Dyadic from_double(double value);

  const Integer& mantissa() const { return mantissa_; }
  std::int64_t exponent() const { return exponent_; }

  Dyadic& operator+=(const Dyadic& b) { return *this = sum(*this, b, false); }
  Dyadic& operator-=(const Dyadic& b) { return *this = sum(*this, b, true); }
  Dyadic& operator*=(const Dyadic& b);
  friend Dyadic operator+(const Dyadic& a, const Dyadic& b) { return sum(a, b, false); }
  friend Dyadic operator-(const Dyadic& a, const Dyadic& b) { return sum(a, b, true); }
  friend Dyadic operator*(Dyadic a, const Dyadic& b) { return a *= b; }
  friend Dyadic operator-(Dyadic a) {
    a.mantissa_.negate();
    return a;
  }

  friend bool operator==(const Dyadic& a, const Dyadic& b) {
    return a.exponent_ == b.exponent_ && a.mantissa_ == b.mantissa_;
  }
  friend std::strong_ordering operator<=>(const Dyadic& a, const Dyadic& b) {
    return to_int((a - b).sign()) <=> 0;
  }

  Sign sign() const { return mantissa_.sign(); }
  Rational to_rational() const { return Rational(mantissa_) * Rational::power_of_two(exponent_); }
  /// "m*2^e", or "m" when e = 0.
  std::string to_string() const;

 private:
  static Dyadic sum(const Dyadic& a, const Dyadic& b, bool subtract);
  void normalise();

  Integer mantissa_;
  std::int64_t exponent_ = 0;
};

inline Sign sign_of(const Dyadic& a) { return a.sign(); }

}  // namespace veritope
