// SPDX-License-Identifier: LGPL-3.0-or-later
// predicates/lattice.h: doubles as integers. One power of two is taken out of a group of
// coordinates that a predicate may scale together (an axis of orient2d and orient3d, all of
// in_circle and in_sphere): the sign stays, the arithmetic becomes integer.
#pragma once
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <utility>

#include "robust/binary64.h"
#include "robust/fixed_int.h"
#include "robust/integer.h"
#include "robust/wide.h"

namespace veritope::internal {

/// Coordinates on a lattice of L limbs are at most 2^lattice_bits(L); three more bits hold a
/// difference and the sign.
constexpr int lattice_bits(int limbs) {
  return 64 * limbs - 4;
}  // NOT COVERED: at compile time only

/// Do c[Axis], c[Axis + Dim], ... take at most two values? (0 and -0 may count as two.)
template <std::size_t Dim, std::size_t Axis, std::size_t N>
[[gnu::always_inline]] inline bool takes_two_values(const std::array<double, N>& c) {
  const auto change = [&](std::size_t i) {
    return std::bit_cast<std::uint64_t>(c[i]) ^ std::bit_cast<std::uint64_t>(c[Axis]);
  };
  std::uint64_t any = 0, others = 0;
  VT_UNROLL for (std::size_t i = Axis + Dim; i < N; i += Dim) any |= change(i);
  VT_UNROLL for (std::size_t i = Axis + Dim; i < N; i += Dim) {
    others |= change(i) == 0 ? 0 : change(i) ^ any;
  }
  return others == 0;
}

/// Are the points, of Dim coordinates each, corners of one box along the axes? Then one circle or
/// sphere goes through all of them.
template <std::size_t Dim, std::size_t N>
inline bool are_corners_of_a_box(const std::array<double, N>& c) {
  if (!takes_two_values<Dim, 0>(c) || !takes_two_values<Dim, 1>(c)) return false;
  if constexpr (Dim == 3) return takes_two_values<Dim, 2>(c);
  return true;
}

/// Are two of the points, of Dim coordinates each, the same by their bits?
template <std::size_t Dim, std::size_t N>
inline bool has_equal_points(const std::array<double, N>& c) {
  for (std::size_t i = Dim; i < N; i += Dim) {
    for (std::size_t j = 0; j < i; j += Dim) {
      bool is_equal = true;
      for (std::size_t k = 0; k < Dim; ++k) is_equal = is_equal && same_bits(c[i + k], c[j + k]);
      if (is_equal) return true;
    }
  }
  return false;
}

/// The integer part of t, and that number again as a double. |t| <= 2^lattice_bits(L); where t has bits
/// below 1 it is less than 2^53, so that the sums here are exact in every rounding mode.
template <int L>
[[gnu::always_inline]] inline FixedInt<L> truncated(double t, double& back) {
  if constexpr (L == 1) {
    const std::int64_t low = static_cast<std::int64_t>(t);
    back = static_cast<double>(low);
    return FixedInt<1>(low);
  } else {
    static_assert(L == 2);
    const std::int64_t high = static_cast<std::int64_t>(t * 0x1p-62);
    const double upper = static_cast<double>(high) * 0x1p62;
    const std::int64_t low = static_cast<std::int64_t>(t - upper);
    back = upper + static_cast<double>(low);
    return FixedInt<2>((static_cast<int128>(high) << 62) + low);
  }
}

/// Sets out[i] = c[i] * 2^k, |out[i]| <= 2^lattice_bits(L), for one k. Returns false if no such k is found: the
/// coordinates' bits span more than that many places, or the coordinates are below approximately 2^-960 (L = 1) or
/// 2^-900 (L = 2). Correct under every rounding mode and with FTZ or DAZ, too: each step is exact or is caught by the
/// comparison of bits.
/// REQUIRES finite coordinates.
template <int L, std::size_t N>
[[gnu::always_inline]] inline bool to_lattice(const std::array<double, N>& c,
                                              std::array<FixedInt<L>, N>& out) {
  constexpr std::uint64_t kBits = lattice_bits(L);
  std::uint64_t largest = 0;
  VT_UNROLL for (std::size_t i = 0; i < N; ++i) {
    const std::uint64_t magnitude = std::bit_cast<std::uint64_t>(c[i]) << 1 >> 1;
    largest = magnitude > largest ? magnitude : largest;
  }
  // |c| < 2^(biased - 1022), scale = 2^(kBits + 1022 - biased), unit = 1 / scale; both are normal.
  const std::uint64_t biased = largest >> 52 < kBits ? kBits : largest >> 52;
  const double scale = std::bit_cast<double>((2045 + kBits - biased) << 52);
  const double unit = std::bit_cast<double>((biased - kBits + 1) << 52);
  std::uint64_t differs = 0;
  VT_UNROLL for (std::size_t i = 0; i < N; ++i) {
    double back;
    out[i] = truncated<L>(c[i] * scale, back);
    differs |= (std::bit_cast<std::uint64_t>(back * unit) ^ std::bit_cast<std::uint64_t>(c[i]))
               << 1;
  }
  return differs == 0;  // the shift forgives -0
}

/// The type of a difference of lattice coordinates.
template <int L>
using LatticeDifference = std::conditional_t<L == 1, std::int64_t, FixedInt<L>>;

template <int L>
[[gnu::always_inline]] inline LatticeDifference<L> difference(const FixedInt<L>& a,
                                                              const FixedInt<L>& b) {
  if constexpr (L == 1) {
    return a.low() - b.low();
  } else {
    return a - b;
  }
}

/// c[i + 1] - c[0]
template <int L, std::size_t N>
[[gnu::always_inline]] inline std::array<LatticeDifference<L>, N - 1> from_first(
    const std::array<FixedInt<L>, N>& c) {
  std::array<LatticeDifference<L>, N - 1> d;
  VT_UNROLL for (std::size_t i = 0; i < N - 1; ++i) d[i] = difference(c[i + 1], c[0]);
  return d;
}

/// Points of Dim coordinates each, minus the last one.
template <std::size_t Dim, int L, std::size_t N>
[[gnu::always_inline]] inline std::array<LatticeDifference<L>, N - Dim> from_last(
    const std::array<FixedInt<L>, N>& c) {
  std::array<LatticeDifference<L>, N - Dim> d;
  VT_UNROLL for (std::size_t i = 0; i < N - Dim; ++i) d[i] = difference(c[i], c[N - Dim + i % Dim]);
  return d;
}

/// Divides the numbers by the power of two that they share; |d[i]| <= 2^n then for the n returned.
/// REQUIRES |d[i]| < 2^62.
template <std::size_t N>
[[gnu::always_inline]] inline int shorten(std::array<std::int64_t, N>& d) {
  std::uint64_t any = 0, size = 0;
  VT_UNROLL for (std::size_t i = 0; i < N; ++i) {
    any |= static_cast<std::uint64_t>(d[i]);
    size |= static_cast<std::uint64_t>(d[i] ^ (d[i] >> 63));  // |d| or |d| - 1
  }
  const int zeros = std::countr_zero(any | std::uint64_t{1} << 62);
  VT_UNROLL for (std::size_t i = 0; i < N; ++i) d[i] >>= zeros;
  return std::bit_width(size >> zeros);
}

/// c[i] / 2^kMinExponent. REQUIRES finite coordinates.
template <typename T, std::size_t N>
std::array<T, N> to_wide(const std::array<double, N>& c) {
  std::array<T, N> out;
  for (std::size_t i = 0; i < N; ++i) out[i] = T::from_double(c[i]);
  return out;
}

/// c[i] = out[i] * 2^exponent, exactly, for the largest exponent with which all out[i] are integers; returns it, or 0
/// if all are zero. T holds an int64_t and is shifted by <<.
/// REQUIRES finite coordinates.
template <typename T, std::size_t N>
int to_integers(const std::array<double, N>& c, std::array<T, N>& out) {
  std::array<Binary64, N> part;
  int least = 1 << 20;
  for (std::size_t i = 0; i < N; ++i) {
    part[i] = split(c[i]);
    if (part[i].mantissa == 0) continue;
    const int zeros = std::countr_zero(static_cast<std::uint64_t>(part[i].mantissa));
    part[i].mantissa >>= zeros;  // exact
    part[i].exponent += zeros;
    least = part[i].exponent < least ? part[i].exponent : least;
  }
  for (std::size_t i = 0; i < N; ++i) {
    out[i] = T(part[i].mantissa);
    if (part[i].mantissa != 0) out[i] = std::move(out[i]) << (part[i].exponent - least);
  }
  return least == 1 << 20 ? 0 : least;
}

}  // namespace veritope::internal
