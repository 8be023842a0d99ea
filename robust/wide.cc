// SPDX-License-Identifier: LGPL-3.0-or-later
#include "robust/wide.h"

#include <gmp.h>

#include <compare>
#include <utility>

#include "robust/limbs.h"

namespace veritope::internal {
namespace {

static_assert(GMP_NUMB_BITS == 64 && sizeof(mp_limb_t) == 8, "written for 64-bit limbs");

mp_limb_t* limbs(std::uint64_t* p) { return reinterpret_cast<mp_limb_t*>(p); }
const mp_limb_t* limbs(const std::uint64_t* p) { return reinterpret_cast<const mp_limb_t*>(p); }

struct Operand {
  WideHead head;
  const std::uint64_t* limb;
  int high() const { return head.low + head.size; }
};

// |a| <=> |b|; both not zero.
std::strong_ordering compare_magnitudes(const Operand& a, const Operand& b) {
  if (a.high() != b.high()) return a.high() <=> b.high();
  const int shared = a.head.size < b.head.size ? a.head.size : b.head.size;
  const auto order =
      compare_limbs(a.limb + a.head.size - shared, b.limb + b.head.size - shared, shared);
  return order != 0 ? order : a.head.size <=> b.head.size;
}

// Drops zero limbs on both ends. REQUIRES that some limb is not 0.
WideHead trimmed(std::uint64_t* r, WideHead h) {
  h.size = significant_size(r, h.size);
  int zeros = 0;
  while (r[zeros] == 0) ++zeros;
  if (zeros > 0) {
    h.size -= zeros;
    h.low += zeros;
    for (int i = 0; i < h.size; ++i) r[i] = r[i + zeros];
  }
  return h;
}

// r = |a| + |b|, or |a| - |b| >= 0, from place `low` up to `high`; the carry out is returned.
template <bool IsSum>
unsigned char combine(std::uint64_t* r, const Operand& a, const Operand& b, int low, int high) {
  for (int i = 0; i < high - low; ++i) r[i] = 0;
  for (int i = 0; i < a.head.size; ++i) r[a.head.low - low + i] = a.limb[i];
  unsigned char carry = IsSum ? 0 : 1;
  std::uint64_t* at = r + (b.head.low - low);
  for (int i = 0; i < b.head.size; ++i) {
    at[i] = add_with_carry(carry, at[i], IsSum ? b.limb[i] : ~b.limb[i]);
  }
  // 0 is added, or -1: the loop may end when the carry no longer changes anything.
  constexpr unsigned char kIdle = IsSum ? 0 : 1;
  constexpr std::uint64_t kRest = IsSum ? 0 : ~std::uint64_t{0};
  for (int i = b.high() - low; i < high - low && carry != kIdle; ++i) {
    r[i] = add_with_carry(carry, r[i], kRest);
  }
  return carry;
}

}  // namespace

WideHead wide_sum(std::uint64_t* r, const WideHead& a_head, const std::uint64_t* a_limb,
                  WideHead b_head, const std::uint64_t* b_limb, bool subtract) noexcept {
  b_head.is_negative = b_head.is_negative != subtract;
  Operand a{a_head, a_limb}, b{b_head, b_limb};
  if (a.head.size == 0) std::swap(a, b);
  if (b.head.size == 0) {
    for (int i = 0; i < a.head.size; ++i) r[i] = a.limb[i];
    return a.head;
  }
  const int low = a.head.low < b.head.low ? a.head.low : b.head.low;
  int high = a.high() > b.high() ? a.high() : b.high();
  if (a.head.is_negative == b.head.is_negative) {
    if (combine<true>(r, a, b, low, high) != 0) r[high++ - low] = 1;
  } else {
    const auto order = compare_magnitudes(a, b);
    if (order == 0) return {};
    if (order < 0) std::swap(a, b);
    combine<false>(r, a, b, low, high);
  }
  return trimmed(r, {high - low, low, a.head.is_negative});
}

WideHead wide_product(std::uint64_t* r, const WideHead& a, const std::uint64_t* a_limb,
                      const WideHead& b, const std::uint64_t* b_limb) noexcept {
  if (a.size == 0 || b.size == 0) return {};
  constexpr int kShort = 6;
  if (a.size <= kShort && b.size <= kShort) {
    multiply_limbs(r, a_limb, a.size, b_limb, b.size);
  } else if (a.size >= b.size) {
    mpn_mul(limbs(r), limbs(a_limb), a.size, limbs(b_limb), b.size);
  } else {
    mpn_mul(limbs(r), limbs(b_limb), b.size, limbs(a_limb), a.size);
  }
  return trimmed(r, {a.size + b.size, a.low + b.low, a.is_negative != b.is_negative});
}

WideHead wide_from(std::uint64_t* r, std::int64_t mantissa, int shift) noexcept {
  if (mantissa == 0) return {};
  const bool is_negative = mantissa < 0;
  const std::uint64_t magnitude = magnitude_of(mantissa);
  const int part = shift % 64;
  r[0] = magnitude << part;
  r[1] = part == 0 ? 0 : magnitude >> (64 - part);
  return trimmed(r, {2, shift / 64, is_negative});
}

}  // namespace veritope::internal
