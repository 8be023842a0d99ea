// SPDX-License-Identifier: LGPL-3.0-or-later
// robust/fixed_int.h: two's complement integers of L 64-bit limbs, on the stack, constexpr. They
// wrap around; whoever uses them proves that the values fit, with the bit budgets at the end of
// this file in a static_assert.
#pragma once
#include <array>
#include <compare>
#include <concepts>
#include <cstdint>
#include <type_traits>

#include "robust/base/int128.h"
#include "robust/base/sign.h"
#include "robust/integer.h"
#include "robust/limbs.h"

#if defined(__GNUC__) && !defined(__clang__)
#define VT_UNROLL _Pragma("GCC unroll 16")
#else
#define VT_UNROLL
#endif

namespace veritope {

template <int L>
struct FixedInt {
  static_assert(L >= 1);
  static constexpr int kLimbs = L;
  /// Values in [-2^kBits, 2^kBits) are held exactly.
  static constexpr int kBits = 64 * L - 1;

  std::array<std::uint64_t, L> limb{};  ///< least significant first

  constexpr FixedInt() = default;
  /// From the signed built-in integers, exactly; from nothing else: a double does not convert.
  template <std::signed_integral T>
  requires(sizeof(T) <= 8)  // gnu++20 counts __int128 among them
      constexpr FixedInt(T v) {
    limb[0] = static_cast<std::uint64_t>(static_cast<std::int64_t>(v));
    fill(1, v < 0);
  }
  template <typename T>
  requires(std::same_as<T, int128>&& L >= 2) constexpr explicit FixedInt(T v) {
    limb[0] = static_cast<std::uint64_t>(v);
    limb[1] = static_cast<std::uint64_t>(v >> 64);
    fill(2, v < 0);
  }
  /// Sign extension.
  template <int K>
  requires(K < L) constexpr explicit FixedInt(const FixedInt<K>& v) {
    for (int i = 0; i < K; ++i) limb[i] = v.limb[i];
    fill(K, v.is_negative());
  }

  /// The lowest limb as a signed number: for L = 1, the value.
  constexpr std::int64_t low() const { return static_cast<std::int64_t>(limb[0]); }
  constexpr bool is_negative() const { return limb[L - 1] >> 63 != 0; }
  constexpr bool is_zero() const {
    std::uint64_t any = 0;
    VT_UNROLL for (int i = 0; i < L; ++i) any |= limb[i];
    return any == 0;
  }
  constexpr Sign sign() const {
    const auto top = static_cast<std::int64_t>(limb[L - 1]);
    return static_cast<Sign>(static_cast<int>(top >> 63) | static_cast<int>(!is_zero()));
  }

  constexpr FixedInt& operator+=(const FixedInt& b) {
    if constexpr (L == 1) {
      limb[0] += b.limb[0];
    } else if constexpr (L == 2) {
      set(pair() + b.pair());
    } else {
      unsigned char carry = 0;
      VT_UNROLL for (int i = 0; i < L; ++i) limb[i] =
          internal::add_with_carry(carry, limb[i], b.limb[i]);
    }
    return *this;
  }
  constexpr FixedInt& operator-=(const FixedInt& b) {
    if constexpr (L == 1) {
      limb[0] -= b.limb[0];
    } else if constexpr (L == 2) {
      set(pair() - b.pair());
    } else {
      unsigned char carry = 1;
      VT_UNROLL for (int i = 0; i < L; ++i) limb[i] =
          internal::add_with_carry(carry, limb[i], ~b.limb[i]);
    }
    return *this;
  }
  friend constexpr FixedInt operator+(FixedInt a, const FixedInt& b) { return a += b; }
  friend constexpr FixedInt operator-(FixedInt a, const FixedInt& b) { return a -= b; }
  friend constexpr FixedInt operator-(const FixedInt& a) { return FixedInt() - a; }
  /// The low limbs of the product.
  friend constexpr FixedInt operator*(const FixedInt& a, const FixedInt& b) {
    FixedInt r;
    VT_UNROLL for (int i = 0; i < L; ++i) {
      std::uint64_t carry = 0;
      VT_UNROLL for (int j = 0; j < L - i; ++j) {
        r.limb[i + j] = internal::multiply_add(carry, a.limb[i], b.limb[j], r.limb[i + j]);
      }
    }
    return r;
  }
  /// this * 2^n modulo 2^(64 L). REQUIRES 0 <= n < 64 L.
  friend constexpr FixedInt operator<<(const FixedInt& a, int n) {
    FixedInt r;
    const int whole = n / 64, part = n % 64;
    for (int i = L - 1; i >= whole; --i) {
      r.limb[i] = a.limb[i - whole] << part;
      if (part != 0 && i > whole) r.limb[i] |= a.limb[i - whole - 1] >> (64 - part);
    }
    return r;
  }
  /// floor(this / 2^n). REQUIRES 0 <= n < 64 L.
  friend constexpr FixedInt operator>>(const FixedInt& a, int n) {
    FixedInt r;
    const int whole = n / 64, part = n % 64;
    const std::uint64_t sign_limb = a.is_negative() ? ~std::uint64_t{0} : 0;
    for (int i = 0; i < L; ++i) {
      const std::uint64_t low = i + whole < L ? a.limb[i + whole] : sign_limb;
      const std::uint64_t high = i + whole + 1 < L ? a.limb[i + whole + 1] : sign_limb;
      r.limb[i] = part == 0 ? low : low >> part | high << (64 - part);
    }
    return r;
  }

  friend constexpr bool operator==(const FixedInt&, const FixedInt&) = default;
  friend constexpr std::strong_ordering operator<=>(const FixedInt& a, const FixedInt& b) {
    if (a.is_negative() != b.is_negative()) {
      return a.is_negative() ? std::strong_ordering::less : std::strong_ordering::greater;
    }
    for (int i = L - 1; i > 0; --i) {
      if (a.limb[i] != b.limb[i]) return a.limb[i] <=> b.limb[i];
    }
    return a.limb[0] <=> b.limb[0];
  }

  /// The lowest two limbs as one unsigned number.
  constexpr uint128 pair() const requires(L >= 2) {
    return static_cast<uint128>(limb[1]) << 64 | limb[0];
  }

  Integer to_integer() const {
    const FixedInt magnitude =
        is_negative() ? -*this : *this;  // as unsigned limbs also right for -2^kBits
    return Integer::from_limbs(magnitude.limb.data(), L, is_negative());
  }

 private:
  constexpr void set(uint128 v) {
    limb[0] = static_cast<std::uint64_t>(v);
    limb[1] = static_cast<std::uint64_t>(v >> 64);
  }
  constexpr void fill(int from, bool negative) {
    for (int i = from; i < L; ++i) limb[i] = negative ? ~std::uint64_t{0} : 0;
  }
};

template <int L>
constexpr Sign sign_of(const FixedInt<L>& v) {
  return v.sign();
}

/// The whole product; it never wraps.
template <int A, int B>
[[gnu::always_inline]] constexpr FixedInt<A + B> wide_product(const FixedInt<A>& a,
                                                              const FixedInt<B>& b) {
  if constexpr (A == 1 && B == 1) {
    return FixedInt<2>(static_cast<int128>(a.low()) * b.low());
  }
  if constexpr (A < B) return wide_product(b, a);
  FixedInt<A + B> r;
  VT_UNROLL for (int i = 0; i < A; ++i) {
    std::uint64_t carry = 0;
    VT_UNROLL for (int j = 0; j < B; ++j) {
      r.limb[i + j] = internal::multiply_add(carry, a.limb[i], b.limb[j], r.limb[i + j]);
    }
    r.limb[i + B] = carry;
  }
  // That was the product of the limbs as unsigned numbers: a negative operand was read as itself +
  // 2^(64 length).
  const std::uint64_t take_b = a.is_negative() ? ~std::uint64_t{0} : 0;
  const std::uint64_t take_a = b.is_negative() ? ~std::uint64_t{0} : 0;
  unsigned char carry = 1;
  VT_UNROLL for (int j = 0; j < B; ++j) {
    r.limb[A + j] = internal::add_with_carry(carry, r.limb[A + j], ~(b.limb[j] & take_b));
  }
  carry = 1;
  VT_UNROLL for (int i = 0; i < A; ++i) {
    r.limb[B + i] = internal::add_with_carry(carry, r.limb[B + i], ~(a.limb[i] & take_a));
  }
  return r;
}

/// Bit budgets: if |a| <= 2^p and |b| <= 2^q, then |a b| <= 2^bits_of_product(p, q), and the sum of
/// n terms of at most 2^p is at most 2^bits_of_sum(n, p). A value with |v| <= 2^p fits FixedInt<L>
/// if p < FixedInt<L>::kBits.
constexpr int bits_of_product(int p, int q) { return p + q; }
constexpr int bits_of_sum(int n, int p) {
  int extra = 0;
  while ((1 << extra) < n) ++extra;
  return p + extra;
}

}  // namespace veritope
