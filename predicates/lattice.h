// SPDX-License-Identifier: LGPL-3.0-or-later
// predicates/lattice.h: doubles as integers. One power of two is taken out of a group of coordinates that a predicate may scale
// together (an axis of orient2d and orient3d, all of in_circle and in_sphere): the sign stays, the arithmetic becomes integer.
#pragma once
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

#include "robust/binary64.h"
#include "robust/integer.h"

namespace veritope::internal {

/// Bits of a coordinate on the short lattice: |out| <= 2^kLatticeBits.
inline constexpr int kLatticeBits = 60;

/// out[i] = c[i] * 2^k, |out[i]| <= 2^60, for one k. False if no such k is found: some bit lies 60 or more binary places under
/// the largest coordinate's first, or the coordinates are below about 2^-960.
/// Right under every rounding mode and with FTZ/DAZ, too: each step is exact or is caught by the comparison of bits.
/// REQUIRES finite coordinates.
template <std::size_t N>
inline bool to_short_lattice(const std::array<double, N>& c, std::array<std::int64_t, N>& out) {
  std::uint64_t largest = 0;
  for (std::size_t i = 0; i < N; ++i) {
    const std::uint64_t magnitude = std::bit_cast<std::uint64_t>(c[i]) << 1 >> 1;
    largest = magnitude > largest ? magnitude : largest;
  }
  std::uint64_t biased = largest >> 52;  // |c| < 2^(biased - 1022)
  if (biased < 60) biased = 60;          // keeps both factors normal
  const double scale = std::bit_cast<double>((2105 - biased) << 52);  // 2^(60 - (biased - 1022))
  const double unit = std::bit_cast<double>((biased - 59) << 52);     // 1 / scale
  std::uint64_t differs = 0;
  for (std::size_t i = 0; i < N; ++i) {
    out[i] = static_cast<std::int64_t>(c[i] * scale);
    const double back = static_cast<double>(out[i]) * unit;
    differs |= (std::bit_cast<std::uint64_t>(back) ^ std::bit_cast<std::uint64_t>(c[i])) << 1;
  }
  return differs == 0;  // the shift forgives -0
}

/// out[i] = c[i] * 2^k exactly, for the largest k with all of them integers (0 if all are zero). REQUIRES finite coordinates.
template <std::size_t N>
std::array<Integer, N> to_integers(const std::array<double, N>& c) {
  std::array<Binary64, N> parts;
  int least = 1 << 20;
  for (std::size_t i = 0; i < N; ++i) {
    parts[i] = split(c[i]);
    if (parts[i].mantissa == 0) continue;
    const int zeros = std::countr_zero(static_cast<std::uint64_t>(parts[i].mantissa));
    parts[i].mantissa >>= zeros;
    parts[i].exponent += zeros;
    least = parts[i].exponent < least ? parts[i].exponent : least;
  }
  std::array<Integer, N> out;
  for (std::size_t i = 0; i < N; ++i) {
    if (parts[i].mantissa == 0) continue;
    out[i] = Integer(parts[i].mantissa);
    out[i].shift_left(static_cast<std::uint64_t>(parts[i].exponent - least));
  }
  return out;
}

}  // namespace veritope::internal
