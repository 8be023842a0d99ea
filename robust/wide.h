// SPDX-License-Identifier: LGPL-3.0-or-later
// robust/wide.h: integers on the stack that hold polynomials of all binary64 numbers: no heap, no
// rounding, no control word. For the last tier of predicates whose degree is known.
#pragma once
#include <cstdint>

#include "robust/base/sign.h"
#include "robust/binary64.h"

namespace veritope {

namespace internal {
/// sign * (limb[0] + limb[1] 2^64 + ...) 2^(64 low), limb[0] and limb[size - 1] not 0; size 0 is zero.
struct WideHead {
  std::int32_t size = 0;
  std::int32_t low = 0;
  bool is_negative = false;
};
// r = a + b, with b's sign reversed if `subtract`; r = a b. r's limbs overlap neither operand's. REQUIRES
// room for the span of the operands and one limb more (sum), or for all limbs of both (product).
WideHead wide_sum(std::uint64_t* r, const WideHead& a, const std::uint64_t* a_limb, WideHead b,
                  const std::uint64_t* b_limb, bool subtract) noexcept;
WideHead wide_product(std::uint64_t* r, const WideHead& a, const std::uint64_t* a_limb,
                      const WideHead& b, const std::uint64_t* b_limb) noexcept;
// mantissa 2^shift in at most two limbs. REQUIRES shift >= 0.
WideHead wide_from(std::uint64_t* r, std::int64_t mantissa, int shift) noexcept;
}  // namespace internal

/// An integer of magnitude below 2^kBits. Only the limbs between the highest and the lowest one that is
/// not 0 are kept and computed with, so that numbers of a few bits cost little wherever these bits are.
/// Whoever uses it proves that nothing exceeds kBits, with degree_limbs. Copies cost what is kept.
template <int Limbs>
class Wide {
 public:
  static constexpr int kBits = 64 * Limbs;

  Wide() = default;
  /// v * 2^-kMinExponent: any finite double becomes an integer of at most 2098 bits.
  static Wide from_double(double v) noexcept {
    static_assert(Limbs >= 34);
    Wide r;
    const Binary64 parts = split(v);
    r.head_ = internal::wide_from(r.limb_, parts.mantissa, parts.exponent - kMinExponent);
    return r;
  }

  Wide(const Wide& other) noexcept : head_(other.head_) { copy(other); }
  Wide& operator=(const Wide& other) noexcept {
    head_ = other.head_;
    copy(other);
    return *this;
  }

  friend Wide operator+(const Wide& a, const Wide& b) noexcept { return sum(a, b, false); }
  friend Wide operator-(const Wide& a, const Wide& b) noexcept { return sum(a, b, true); }
  friend Wide operator*(const Wide& a, const Wide& b) noexcept {
    Wide r;
    r.head_ = internal::wide_product(r.limb_, a.head_, a.limb_, b.head_, b.limb_);
    return r;
  }

  Sign sign() const noexcept {
    if (head_.size == 0) return Sign::kZero;
    return head_.is_negative ? Sign::kNegative : Sign::kPositive;
  }

 private:
  static Wide sum(const Wide& a, const Wide& b, bool subtract) noexcept {
    Wide r;
    r.head_ = internal::wide_sum(r.limb_, a.head_, a.limb_, b.head_, b.limb_, subtract);
    return r;
  }
  void copy(const Wide& other) noexcept {
    for (int i = 0; i < head_.size; ++i) limb_[i] = other.limb_[i];
  }

  internal::WideHead head_;
  std::uint64_t limb_[Limbs];  // of which head_.size are set
};

template <int Limbs>
Sign sign_of(const Wide<Limbs>& v) noexcept {
  return v.sign();
}

/// Limbs for a polynomial of this degree in differences of doubles whose sum of absolute
/// coefficients, intermediate results included, is at most 2^extra_bits: differences are below
/// 2^2099 units. One limb more is what a sum may touch before its carry is known.
constexpr int degree_limbs(int degree, int extra_bits) {
  return (2099 * degree + extra_bits + 63) / 64 + 1;
}

}  // namespace veritope
