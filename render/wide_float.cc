// SPDX-License-Identifier: LGPL-3.0-or-later
#include "render/wide_float.h"

#include <utility>

namespace veritope::internal {

WideFloat::WideFloat(Integer mantissa, std::int64_t exponent)
    : mantissa_(std::move(mantissa)), exponent_(exponent) {
  const std::uint64_t length = mantissa_.bit_length();
  if (length == 0) exponent_ = 0;
  if (length <= kBits) return;
  mantissa_.shift_right(length - kBits);
  exponent_ += static_cast<std::int64_t>(length - kBits);
}

// floor(x 2^s) with at least kBits bits.
WideFloat::WideFloat(const Rational& x) {
  const auto digits = static_cast<std::int64_t>(x.numerator().bit_length()) -
                      static_cast<std::int64_t>(x.denominator().bit_length());
  const std::int64_t shift = static_cast<std::int64_t>(kBits) + 1 - digits;
  Integer p = x.numerator(), q = x.denominator();
  if (shift > 0) p.shift_left(static_cast<std::uint64_t>(shift));
  if (shift < 0) q.shift_left(static_cast<std::uint64_t>(-shift));
  *this = WideFloat(floor_divide(p, q), -shift);
}

WideFloat operator+(const WideFloat& a, const WideFloat& b) {
  if (a.mantissa_.is_zero()) return b;
  if (b.mantissa_.is_zero()) return a;
  if (a.exponent_ < b.exponent_) return b + a;
  const auto gap = static_cast<std::uint64_t>(a.exponent_ - b.exponent_);
  // |b| < 2^-(kBits + 1) |a|.
  if (gap > 2 * WideFloat::kBits + 1) return a;
  Integer sum = a.mantissa_;
  sum.shift_left(gap);
  return {sum += b.mantissa_, b.exponent_};
}

}  // namespace veritope::internal
