// SPDX-License-Identifier: LGPL-3.0-or-later
// robust/limbs.h: what our integers of several limbs share: carries, products, comparison. Limbs are unsigned 64-bit
// numbers, least significant first. docs/integers.md says which integer type to take, and which of them use these.
#pragma once
#include <compare>
#include <cstdint>
#include <type_traits>

#if defined(__x86_64__)
#include <immintrin.h>
#endif

#include "robust/base/int128.h"

namespace veritope::internal {

/// a + b + carry modulo 2^64; carry, 0 or 1, becomes what is carried out. A difference a - b is a + ~b + 1: it begins
/// with carry = 1.
[[gnu::always_inline]] constexpr std::uint64_t add_with_carry(unsigned char& carry, std::uint64_t a,
                                                              std::uint64_t b) {
#if defined(__x86_64__)
  if (!std::is_constant_evaluated()) {
    unsigned long long sum;
    carry = _addcarry_u64(carry, a, b, &sum);
    return sum;
  }
#endif
  const uint128 sum = static_cast<uint128>(a) + b + carry;
  carry = static_cast<unsigned char>(sum >> 64);
  return static_cast<std::uint64_t>(sum);
}

/// a b + c + carry modulo 2^64; carry becomes the limb above. The two limbs hold every result:
/// (2^64 - 1)^2 + 2 (2^64 - 1) = 2^128 - 1.
[[gnu::always_inline]] constexpr std::uint64_t multiply_add(std::uint64_t& carry, std::uint64_t a,
                                                            std::uint64_t b, std::uint64_t c) {
  const uint128 t = static_cast<uint128>(a) * b + c + carry;
  carry = static_cast<std::uint64_t>(t >> 64);
  return static_cast<std::uint64_t>(t);
}

/// r = a b, a_size + b_size limbs. For few limbs this is faster than a call of GMP. REQUIRES that both sizes are at
/// least 1 and that r overlaps neither operand.
inline void multiply_limbs(std::uint64_t* r, const std::uint64_t* a, int a_size,
                           const std::uint64_t* b, int b_size) {
  std::uint64_t carry = 0;
  for (int j = 0; j < b_size; ++j) r[j] = multiply_add(carry, a[0], b[j], 0);
  r[b_size] = carry;
  for (int i = 1; i < a_size; ++i) {
    const std::uint64_t factor = a[i];
    carry = 0;
    for (int j = 0; j < b_size; ++j) r[i + j] = multiply_add(carry, factor, b[j], r[i + j]);
    r[i + b_size] = carry;
  }
}

/// r = a + b if IsSum, or else a - b, in a_size limbs; returns what is carried out, of a difference 1 iff it is not
/// negative. REQUIRES a_size >= b_size.
template <bool IsSum>
unsigned char combine_limbs(std::uint64_t* r, const std::uint64_t* a, int a_size,
                            const std::uint64_t* b, int b_size) {
  unsigned char carry = IsSum ? 0 : 1;
  int i = 0;
  for (; i < b_size; ++i) r[i] = add_with_carry(carry, a[i], IsSum ? b[i] : ~b[i]);
  for (; i < a_size; ++i) r[i] = add_with_carry(carry, a[i], IsSum ? 0 : ~std::uint64_t{0});
  return carry;
}

/// a <=> b, `size` limbs each. The highest limbs usually decide.
[[gnu::always_inline]] constexpr std::strong_ordering compare_limbs(const std::uint64_t* a,
                                                                    const std::uint64_t* b,
                                                                    int size) {
  for (int i = size - 1; i >= 0; --i) {
    if (a[i] != b[i]) return a[i] <=> b[i];
  }
  return std::strong_ordering::equal;
}

/// `size` without the highest limbs that are 0. REQUIRES that some limb is not 0.
[[gnu::always_inline]] constexpr int significant_size(const std::uint64_t* limb, int size) {
  while (limb[size - 1] == 0) --size;
  return size;
}

/// |v|, right for -2^63, too.
constexpr std::uint64_t magnitude_of(std::int64_t v) {
  const auto u = static_cast<std::uint64_t>(v);
  return v < 0 ? 0 - u : u;
}

}  // namespace veritope::internal
