// SPDX-License-Identifier: LGPL-3.0-or-later
#include "robust/dyadic.h"

#include "robust/base/check.h"
#include "robust/binary64.h"

namespace veritope {

Dyadic::Dyadic(Integer mantissa, std::int64_t exponent)
    : mantissa_(std::move(mantissa)), exponent_(exponent) {
  normalise();
}

void Dyadic::normalise() {
  if (mantissa_.is_zero()) {
    exponent_ = 0;
    return;
  }
  const std::uint64_t zeros = mantissa_.trailing_zeros();
  if (zeros == 0) return;
  mantissa_.shift_right(zeros);  // exact
  exponent_ += static_cast<std::int64_t>(zeros);
}

Dyadic Dyadic::from_double(double value) {
  VT_CHECK(is_finite(value), "from_double of NaN or infinity");
  const Binary64 b = split(value);
  return Dyadic(Integer(b.mantissa), b.exponent);
}

Dyadic& Dyadic::operator*=(const Dyadic& b) {
  const std::int64_t exponent = exponent_ + b.exponent_;
  mantissa_ *= b.mantissa_;
  exponent_ = mantissa_.is_zero() ? 0 : exponent;  // a product of odd numbers is odd
  return *this;
}

Dyadic Dyadic::sum(const Dyadic& a, const Dyadic& b, bool subtract) {
  if (a.mantissa_.is_zero()) return subtract ? -b : b;
  if (b.mantissa_.is_zero()) return a;
  const std::int64_t least = a.exponent_ < b.exponent_ ? a.exponent_ : b.exponent_;
  Integer m = a.mantissa_, n = b.mantissa_;
  m.shift_left(static_cast<std::uint64_t>(a.exponent_ - least));
  n.shift_left(static_cast<std::uint64_t>(b.exponent_ - least));
  subtract ? m -= n : m += n;
  return Dyadic(std::move(m), least);
}

std::string Dyadic::to_string() const {
  return exponent_ == 0 ? mantissa_.to_string()
                        : mantissa_.to_string() + "*2^" + std::to_string(exponent_);
}

}  // namespace veritope
