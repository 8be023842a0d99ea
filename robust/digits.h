// SPDX-License-Identifier: LGPL-3.0-or-later
// robust/digits.h: integers of a fixed number of 62-bit digits, and sums of their products that are carried once. They
// need no sign corrections and no carries between products; they are for signs of short polynomials.
#pragma once
#include <array>
#include <cstdint>

#include "robust/base/int128.h"
#include "robust/base/sign.h"
#include "robust/fixed_int.h"

namespace veritope {

inline constexpr int kDigitBits = 62;

/// d[0] + d[1] 2^62 + d[2] 2^124 + ...: all but the last are in [0, 2^62); the last has the sign.
template <int N>
struct Digits {
  std::array<std::int64_t, N> d;

  friend constexpr Digits operator-(const Digits& a, const Digits& b) requires(N == 1) {
    return {{a.d[0] - b.d[0]}};
  }
};

/// c[0] + c[1] 2^62 + c[2] 2^124 + ... Sums wrap around if a column leaves (-2^127, 2^127): a column can hold seven
/// products of digits of at most 2^62, carries included.
template <int N>
struct Columns {
  std::array<int128, N> c;

  friend constexpr Columns operator+(Columns a, const Columns& b) {
    VT_UNROLL for (int i = 0; i < N; ++i) a.c[i] += b.c[i];
    return a;
  }
  friend constexpr Columns operator-(Columns a, const Columns& b) {
    VT_UNROLL for (int i = 0; i < N; ++i) a.c[i] -= b.c[i];
    return a;
  }
  friend constexpr Sign sign_of(const Columns& v) {
    int128 rest = v.c[0];
    std::int64_t digits = 0;  // not 0 iff some digit below `rest` is not
    VT_UNROLL for (int i = 1; i < N; ++i) {
      digits |= low_digit(rest);
      rest = v.c[i] + (rest >> kDigitBits);
    }
    return static_cast<Sign>(static_cast<int>(rest >> 127) |
                             static_cast<int>((rest | digits) != 0));
  }

  static constexpr std::int64_t low_digit(int128 v) {
    return static_cast<std::int64_t>(v) & ((std::int64_t{1} << kDigitBits) - 1);
  }
  static constexpr std::int64_t high_digit(int128 v) {
    return static_cast<std::int64_t>(v >> kDigitBits);
  }
};

/// put(i, digit) for the N low digits of the number; returns the rest above them.
template <int N, typename Put>
[[gnu::always_inline]] constexpr int128 carry_digits(const Columns<N>& v, Put put) {
  int128 rest = v.c[0];
  VT_UNROLL for (int i = 1; i < N; ++i) {
    put(i - 1, Columns<N>::low_digit(rest));
    rest = v.c[i] + (rest >> kDigitBits);
  }
  put(N - 1, Columns<N>::low_digit(rest));
  return rest >> kDigitBits;
}

/// Converts the number to digits. REQUIRES that it is less than 2^(62 N + 63) in magnitude.
template <int N>
[[gnu::always_inline]] constexpr Digits<N + 1> settled(const Columns<N>& v) {
  Digits<N + 1> r{};
  r.d[N] = static_cast<std::int64_t>(
      carry_digits(v, [&](int i, std::int64_t digit) { r.d[i] = digit; }));
  return r;
}

/// Carries between the columns; the last carry becomes one more column. The number stays the same.
template <int N>
[[gnu::always_inline]] constexpr Columns<N + 1> carried(const Columns<N>& v) {
  Columns<N + 1> r{};
  r.c[N] = carry_digits(v, [&](int i, std::int64_t digit) { r.c[i] = digit; });
  return r;
}

/// The product; a column holds at most min(A, B) products of digits.
template <int A, int B>
[[gnu::always_inline]] constexpr Columns<A + B - 1> column_product(const Digits<A>& a,
                                                                   const Digits<B>& b) {
  Columns<A + B - 1> r{};
  VT_UNROLL for (int i = 0; i < A; ++i) {
    VT_UNROLL for (int j = 0; j < B; ++j) r.c[i + j] += static_cast<int128>(a.d[i]) * b.d[j];
  }
  return r;
}

}  // namespace veritope
