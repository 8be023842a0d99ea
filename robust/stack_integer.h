// SPDX-License-Identifier: LGPL-3.0-or-later
// robust/stack_integer.h: integers as long as they need to be, up to a capacity, on the stack: the signs of polynomials
// whose values are usually short, without an allocation. Which integer when: docs/integers.md.
#pragma once
#include <algorithm>
#include <compare>
#include <cstddef>
#include <cstdint>

#include "robust/base/int128.h"
#include "robust/base/sign.h"
#include "robust/limbs.h"

namespace veritope {

/// An integer of at most Capacity limbs, or unknown: a result that does not fit is unknown, and so is
/// everything that is computed from it. It never wraps around.
template <int Capacity>
class StackInteger {
 public:
  StackInteger() : size_(0), is_negative_(false) {}
  explicit StackInteger(std::int64_t v) : size_(v != 0), is_negative_(v < 0) {
    limb_[0] = internal::magnitude_of(v);
  }
  // Only the limbs in use.
  StackInteger(const StackInteger& v) { assign(v); }
  StackInteger& operator=(const StackInteger& v) {
    if (this != &v) assign(v);
    return *this;
  }
  /// The sum of the count digits d[i] 2^(62 i): all but the last in [0, 2^62), the last signed.
  static StackInteger from_digits(const std::int64_t* d, int count) {
    static_assert(Capacity > 8);
    // |v| = sum of t[i] 2^(62 i) with t = d, or with t = -d carried.
    const bool is_negative = d[count - 1] < 0;
    StackInteger r;
    r.is_negative_ = is_negative;
    std::int64_t borrow = 0;
    uint128 low = 0;  // bits that are not yet a limb
    int bits = 0;
    for (int i = 0; i < count; ++i) {
      std::int64_t t = is_negative ? -d[i] + borrow : d[i];
      if (i + 1 < count) {
        borrow = t >> 62;
        t &= (std::int64_t{1} << 62) - 1;
      }
      low |= static_cast<uint128>(static_cast<std::uint64_t>(t)) << bits;
      bits += 62;
      if (bits < 64 && i + 1 < count) continue;
      r.limb_[r.size_++] = static_cast<std::uint64_t>(low);
      low >>= 64;
      bits -= 64;
    }
    r.limb_[r.size_++] = static_cast<std::uint64_t>(low);
    while (r.size_ > 0 && r.limb_[r.size_ - 1] == 0) --r.size_;
    return r;
  }

  /// Uncertain iff unknown.
  Sign3 sign() const {
    if (size_ == kUnknown) return Sign3::kUncertain;
    return size_ == 0 ? Sign3::kZero : (is_negative_ ? Sign3::kNegative : Sign3::kPositive);
  }

  friend StackInteger operator-(StackInteger a) {
    a.is_negative_ = !a.is_negative_;
    return a;
  }
  friend StackInteger operator+(const StackInteger& a, const StackInteger& b) {
    return sum(a, b, b.is_negative_);
  }
  friend StackInteger operator-(const StackInteger& a, const StackInteger& b) {
    return sum(a, b, !b.is_negative_);
  }
  friend StackInteger operator*(const StackInteger& a, const StackInteger& b) {
    StackInteger r;
    if (a.size_ == 0 || b.size_ == 0) {
      if (a.size_ == kUnknown || b.size_ == kUnknown) r.size_ = kUnknown;
      return r;
    }
    if (a.size_ == kUnknown || b.size_ == kUnknown || a.size_ + b.size_ > Capacity) {
      r.size_ = kUnknown;
      return r;
    }
    r.is_negative_ = a.is_negative_ != b.is_negative_;
    internal::multiply_limbs(r.limb_, a.limb_, a.size_, b.limb_, b.size_);
    r.size_ = a.size_ + b.size_;
    if (r.limb_[r.size_ - 1] == 0) --r.size_;
    return r;
  }
  /// REQUIRES n >= 0.
  friend StackInteger operator<<(const StackInteger& a, int n) {
    const int whole = n / 64, part = n % 64;
    if (a.size_ <= 0 || n == 0) return a;
    StackInteger r;
    const std::uint64_t top = part == 0 ? 0 : a.limb_[a.size_ - 1] >> (64 - part);
    if (a.size_ + whole + (top != 0) > Capacity) {
      r.size_ = kUnknown;
      return r;
    }
    r.is_negative_ = a.is_negative_;
    std::fill(r.limb_, r.limb_ + whole, 0);
    std::uint64_t carry = 0;
    for (int i = 0; i < a.size_; ++i) {
      r.limb_[i + whole] = a.limb_[i] << part | carry;
      carry = part == 0 ? 0 : a.limb_[i] >> (64 - part);
    }
    r.size_ = a.size_ + whole;
    if (top != 0) r.limb_[r.size_++] = top;
    return r;
  }

 private:
  static constexpr int kUnknown = -1;

  void assign(const StackInteger& v) {
    size_ = v.size_, is_negative_ = v.is_negative_;
    for (int i = 0; i < size_; ++i) limb_[i] = v.limb_[i];
  }
  // |a| <=> |b|
  static std::strong_ordering compare_magnitudes(const StackInteger& a, const StackInteger& b) {
    if (a.size_ != b.size_) return a.size_ <=> b.size_;
    return internal::compare_limbs(a.limb_, b.limb_, a.size_);
  }
  // a + |b| or a - |b|
  static StackInteger sum(const StackInteger& a, const StackInteger& b, bool b_is_negative) {
    StackInteger r;
    if (a.size_ == kUnknown || b.size_ == kUnknown) {
      r.size_ = kUnknown;
      return r;
    }
    if (a.is_negative_ == b_is_negative) {
      add_magnitudes(a.size_ < b.size_ ? b : a, a.size_ < b.size_ ? a : b, r);
      r.is_negative_ = b_is_negative;
      return r;
    }
    const auto order = compare_magnitudes(a, b);
    if (order == 0) return r;
    subtract_magnitudes(order > 0 ? a : b, order > 0 ? b : a, r);
    r.is_negative_ = order > 0 ? a.is_negative_ : b_is_negative;
    return r;
  }
  // REQUIRES a.size_ >= b.size_
  static void add_magnitudes(const StackInteger& a, const StackInteger& b, StackInteger& r) {
    const unsigned char carry =
        internal::combine_limbs<true>(r.limb_, a.limb_, a.size_, b.limb_, b.size_);
    r.size_ = a.size_;
    if (carry == 0) return;
    if (r.size_ == Capacity) {
      r.size_ = kUnknown;
    } else {
      r.limb_[r.size_++] = carry;
    }
  }
  // REQUIRES |a| > |b|
  static void subtract_magnitudes(const StackInteger& a, const StackInteger& b, StackInteger& r) {
    internal::combine_limbs<false>(r.limb_, a.limb_, a.size_, b.limb_, b.size_);
    r.size_ = internal::significant_size(r.limb_, a.size_);
  }

  std::uint64_t limb_[Capacity];  // of the magnitude, least significant first
  int size_;                      // the highest limb is not 0
  bool is_negative_;
};

template <int Capacity>
Sign3 sign_of(const StackInteger<Capacity>& v) {
  return v.sign();
}

}  // namespace veritope
