// SPDX-License-Identifier: LGPL-3.0-or-later
// robust/binary64.h: the parts of an IEEE 754 binary64 number, by its bits: correct in every floating-point
// environment.
#pragma once
#include <bit>
#include <cstdint>
#include <limits>
#include <type_traits>

namespace veritope {

static_assert(std::numeric_limits<double>::is_iec559 && sizeof(double) == 8);

inline constexpr int kMinExponent = -1074;  ///< of the least subnormal's unit, 2^-1074
inline constexpr std::uint64_t kInfinityBits = 0x7ff0000000000000u;
inline constexpr std::uint64_t kMaxFiniteBits = kInfinityBits - 1;

/// The bits of v, as an integer whose origin the compiler may not know: clang 19 turns a test of bits for
/// 0 into a comparison of doubles, which takes subnormal numbers for 0 in a thread with DAZ.
constexpr std::uint64_t integer_bits(double v) {
  std::uint64_t bits = std::bit_cast<std::uint64_t>(v);
  if (!std::is_constant_evaluated()) asm("" : "+r"(bits));
  return bits;
}

/// mantissa * 2^exponent with |mantissa| < 2^53; not normalised.
struct Binary64 {
  std::int64_t mantissa;
  int exponent;
};

constexpr bool is_finite(double v) { return (integer_bits(v) & kInfinityBits) != kInfinityBits; }

/// The exact parts of a finite number; exponent >= kMinExponent. REQUIRES is_finite(v).
constexpr Binary64 split(double v) {
  const std::uint64_t bits = integer_bits(v);
  const int biased = static_cast<int>(bits >> 52 & 0x7ff);
  const std::uint64_t fraction = bits & 0xfffffffffffffu;
  const std::uint64_t m = biased == 0 ? fraction : fraction | std::uint64_t{1} << 52;
  const std::int64_t mantissa = static_cast<std::int64_t>(m);
  return {(bits >> 63) != 0 ? -mantissa : mantissa, (biased == 0 ? 1 : biased) - 1075};
}

/// Integers in the order of the doubles, equal for 0 and -0: a comparison of doubles themselves takes subnormal ones
/// for 0 in a thread with DAZ. REQUIRES no NaN.
constexpr std::int64_t binary64_order(double v) {
  const std::int64_t bits = static_cast<std::int64_t>(integer_bits(v));
  return bits < 0 ? std::numeric_limits<std::int64_t>::min() - bits : bits;
}

namespace internal {
/// Are all the same number? (0 and -0 may count as different; DAZ does not matter.)
template <typename... Rest>
inline bool same_bits(double first, Rest... rest) {
  const std::uint64_t bits = std::bit_cast<std::uint64_t>(first);
  return ((std::bit_cast<std::uint64_t>(rest) == bits) && ...);
}
}  // namespace internal

/// 2^n as a double. REQUIRES -1022 <= n <= 1023.
constexpr double exp2_int(int n) {
  return std::bit_cast<double>(static_cast<std::uint64_t>(n + 1023) << 52);
}

}  // namespace veritope
