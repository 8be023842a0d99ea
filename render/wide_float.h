// SPDX-License-Identifier: LGPL-3.0-or-later
// render/wide_float.h: floating-point numbers of 256 bits as a ring for splines, for pictures of splines whose exact
// pieces would take too long to cut.
#pragma once
#include "robust/rational.h"
#include "splines/ring.h"

namespace veritope::internal {

/// mantissa * 2^exponent. Every operation rounds down to kBits bits: its error is below 2^-255 of its result. Exponents
/// are not bounded in practice. A result is 0 only if the exact one is, so weights stay positive when a spline is cut,
/// which takes convex combinations only.
class WideFloat {
 public:
  static constexpr std::uint64_t kBits = 256;

  WideFloat() = default;
  explicit WideFloat(const Rational& x);

  Rational exact() const { return Rational(mantissa_) * Rational::power_of_two(exponent_); }

  friend WideFloat operator+(const WideFloat& a, const WideFloat& b);
  friend WideFloat operator-(const WideFloat& a, const WideFloat& b) { return a + -b; }
  friend WideFloat operator*(const WideFloat& a, const WideFloat& b) {
    return {a.mantissa_ * b.mantissa_, a.exponent_ + b.exponent_};
  }
  friend WideFloat operator-(WideFloat a) {
    a.mantissa_.negate();
    return a;
  }

 private:
  WideFloat(Integer mantissa, std::int64_t exponent);

  Integer mantissa_;
  std::int64_t exponent_ = 0;
};

}  // namespace veritope::internal

namespace veritope {

template <>
struct RingNumbers<internal::WideFloat> {
  using Knot = Rational;
  static internal::WideFloat ratio(std::int64_t p, std::int64_t q) {
    return internal::WideFloat(Rational(p) / Rational(q));
  }
  static internal::WideFloat fraction(const Rational& t, const Rational& a, const Rational& b) {
    return internal::WideFloat((t - a) / (b - a));
  }
  static internal::WideFloat of_knot(const Rational& k) { return internal::WideFloat(k); }
};

}  // namespace veritope
