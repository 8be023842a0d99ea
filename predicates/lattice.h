// SPDX-License-Identifier: LGPL-3.0-or-later
// predicates/lattice.h: doubles as integers. One power of two is taken out of a group of
// coordinates that a predicate may scale together (an axis of orient2d and orient3d, all of
// in_circle and in_sphere): the sign stays, the arithmetic becomes integer.
#pragma once
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

#include "robust/binary64.h"
#include "robust/fixed_int.h"
#include "robust/integer.h"

namespace veritope::internal {

/// Coordinates on a lattice of L limbs are at most 2^lattice_bits(L); three more bits hold a
/// difference and the sign.
constexpr int lattice_bits(int limbs) { return 64 * limbs - 4; }

/// Are all the same number? (0 and -0 may count as different; DAZ does not matter.)
template <typename... Rest>
inline bool same_bits(double first, Rest... rest) {
  const std::uint64_t bits = std::bit_cast<std::uint64_t>(first);
  return ((std::bit_cast<std::uint64_t>(rest) == bits) && ...);
}

/// out[i] = c[i] * 2^k, |out[i]| <= 2^60, for one k. False if no such k is found: some bit lies 60
/// or more binary places under the largest coordinate's first, or the coordinates are below about
/// 2^-960. Right under every rounding mode and with FTZ or DAZ, too: each step is exact or is
/// caught by the comparison of bits.
/// REQUIRES finite coordinates.
template <std::size_t N>
[[gnu::always_inline]] inline bool to_lattice(const std::array<double, N>& c,
                                              std::array<FixedInt<1>, N>& out) {
  std::uint64_t largest = 0;
  VT_UNROLL for (std::size_t i = 0; i < N; ++i) {
    const std::uint64_t magnitude = std::bit_cast<std::uint64_t>(c[i]) << 1 >> 1;
    largest = magnitude > largest ? magnitude : largest;
  }
  std::uint64_t biased = largest >> 52;                               // |c| < 2^(biased - 1022)
  if (biased < 60) biased = 60;                                       // keeps both factors normal
  const double scale = std::bit_cast<double>((2105 - biased) << 52);  // 2^(60 - (biased - 1022))
  const double unit = std::bit_cast<double>((biased - 59) << 52);     // 1 / scale
  std::uint64_t differs = 0;
  VT_UNROLL for (std::size_t i = 0; i < N; ++i) {
    const std::int64_t value = static_cast<std::int64_t>(c[i] * scale);
    out[i].limb[0] = static_cast<std::uint64_t>(value);
    const double back = static_cast<double>(value) * unit;
    differs |= (std::bit_cast<std::uint64_t>(back) ^ std::bit_cast<std::uint64_t>(c[i])) << 1;
  }
  return differs == 0;  // the shift forgives -0
}

/// The finite numbers c as odd mantissa * 2^exponent (0 stays 0), and the least of their exponents.
template <std::size_t N>
struct Parts {
  std::array<Binary64, N> part;
  int least = 1 << 20;
  int end = -(1 << 20);  ///< |c[i]| < 2^end

  explicit Parts(const std::array<double, N>& c) {
    for (std::size_t i = 0; i < N; ++i) {
      Binary64& p = part[i] = split(c[i]);
      if (p.mantissa == 0) continue;
      const int zeros = std::countr_zero(static_cast<std::uint64_t>(p.mantissa));
      p.mantissa >>= zeros;
      p.exponent += zeros;
      const std::int64_t m = p.mantissa < 0 ? -p.mantissa : p.mantissa;
      const int top = p.exponent + static_cast<int>(std::bit_width(static_cast<std::uint64_t>(m)));
      least = p.exponent < least ? p.exponent : least;
      end = top > end ? top : end;
    }
  }
};

/// out[i] = c[i] * 2^k, |out[i]| < 2^lattice_bits(L), for one k; false iff there is no such k.
/// REQUIRES finite coordinates.
template <std::size_t N, int L>
requires(L > 1) bool to_lattice(const std::array<double, N>& c, std::array<FixedInt<L>, N>& out) {
  const Parts<N> parts(c);
  if (parts.end - parts.least > lattice_bits(L)) return false;
  for (std::size_t i = 0; i < N; ++i) {
    const Binary64& p = parts.part[i];
    out[i] =
        p.mantissa == 0 ? FixedInt<L>() : FixedInt<L>(p.mantissa) << (p.exponent - parts.least);
  }
  return true;
}

/// out[i] = c[i] * 2^k exactly, for the largest k with all of them integers (0 if all are zero).
/// REQUIRES finite coordinates.
template <std::size_t N>
std::array<Integer, N> to_integers(const std::array<double, N>& c) {
  const Parts<N> parts(c);
  std::array<Integer, N> out;
  for (std::size_t i = 0; i < N; ++i) {
    const Binary64& p = parts.part[i];
    if (p.mantissa == 0) continue;
    out[i] = Integer(p.mantissa);
    out[i].shift_left(static_cast<std::uint64_t>(p.exponent - parts.least));
  }
  return out;
}

}  // namespace veritope::internal
