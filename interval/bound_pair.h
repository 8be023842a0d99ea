// SPDX-License-Identifier: LGPL-3.0-or-later
// interval/bound_pair.h: two binary64 numbers that are computed side by side, each rounded as the
// thread's control word says. Every operation is one machine instruction of an asm volatile: no
// compiler flag (-ffast-math, -Ofast, contraction) can reorder, fold, fuse or assume anything.
#pragma once
#include <bit>
#include <cstdint>

#include "interval/upward.h"

namespace veritope::internal {

inline constexpr std::uint64_t kSignBit = std::uint64_t{1} << 63;
/// What 0 * infinity gives on x86, low 32 bits zero; an empty interval's NaN has other high bits.
inline constexpr std::uint64_t kMadeNan = 0xfff8000000000000u;
inline constexpr double kEmptyBound = std::bit_cast<double>(~kSignBit);

/// Numbers in order have keys in order, -0 and 0 the same one; integers, so that neither flags nor
/// DAZ spoil a comparison. Infinities are ordered, NaN is not meant.
constexpr std::int64_t order_key(double v) {
  const std::int64_t bits = std::bit_cast<std::int64_t>(v);
  return bits < 0 ? INT64_MIN - bits : bits;
}
constexpr bool is_nan(double v) {
  return (std::bit_cast<std::uint64_t>(v) & ~kSignBit) > 0x7ff0000000000000u;
}
constexpr bool is_infinite(double v) {
  return (std::bit_cast<std::uint64_t>(v) & ~kSignBit) == 0x7ff0000000000000u;
}
constexpr double negated(double v) {
  return std::bit_cast<double>(std::bit_cast<std::uint64_t>(v) ^ kSignBit);
}
constexpr bool less(double a, double b) { return order_key(a) < order_key(b); }
constexpr bool less_equal(double a, double b) { return order_key(a) <= order_key(b); }
constexpr double larger(double a, double b) { return less(a, b) ? b : a; }
constexpr double smaller(double a, double b) { return less(b, a) ? b : a; }

#if defined(__SSE2__)

using Pair = __m128d;

inline constexpr Pair make_pair(double first, double second) { return Pair{first, second}; }
inline double first(Pair p) { return _mm_cvtsd_f64(p); }
inline double second(Pair p) { return _mm_cvtsd_f64(_mm_unpackhi_pd(p, p)); }
// pshufd: the one shuffle of SSE2 that leaves its operand as it was, so that no copy is needed.
// AVX has such forms of the others, which stay in the floating-point domain.
template <int kHalves, int kDoubles>
inline Pair shuffled(Pair p) {
#if defined(__AVX__)
  return _mm_shuffle_pd(p, p, kDoubles);
#else
  return _mm_castsi128_pd(_mm_shuffle_epi32(_mm_castpd_si128(p), kHalves));
#endif
}
inline Pair swapped(Pair p) { return shuffled<0x4e, 1>(p); }
inline Pair both_first(Pair p) { return shuffled<0x44, 0>(p); }
inline Pair both_second(Pair p) { return shuffled<0xee, 3>(p); }
// Through integers: compilers must not learn that this is a negation, which they would move
// through a product: (-x) * y and -(x * y) round differently.
inline Pair flip(Pair p, std::uint64_t first_bits, std::uint64_t second_bits) {
  const __m128i mask =
      _mm_set_epi64x(static_cast<long long>(second_bits), static_cast<long long>(first_bits));
  return _mm_castsi128_pd(_mm_xor_si128(_mm_castpd_si128(p), mask));
}
inline Pair negated(Pair p) { return flip(p, kSignBit, kSignBit); }

#if defined(__AVX__)
#define VT_PAIR_OPERATION(name, instruction)                                  \
  [[gnu::always_inline]] inline Pair name(Pair a, Pair b) {                   \
    Pair out;                                                                 \
    asm volatile("v" instruction " %2, %1, %0" : "=x"(out) : "x"(a), "x"(b)); \
    return out;                                                               \
  }
#else
#define VT_PAIR_OPERATION(name, instruction)                \
  [[gnu::always_inline]] inline Pair name(Pair a, Pair b) { \
    asm volatile(instruction " %1, %0" : "+x"(a) : "x"(b)); \
    return a;                                               \
  }
#endif
VT_PAIR_OPERATION(added, "addpd")
VT_PAIR_OPERATION(multiplied, "mulpd")
VT_PAIR_OPERATION(divided, "divpd")
VT_PAIR_OPERATION(larger, "maxpd")   ///< b where either is NaN
VT_PAIR_OPERATION(smaller, "minpd")  ///< b where either is NaN
#undef VT_PAIR_OPERATION

[[gnu::always_inline]] inline double square_root(double v) {
  asm volatile("sqrtsd %0, %0" : "+x"(v));
  return v;
}
/// 0 where p is the NaN that 0 * infinity makes; an empty operand's NaN stays. Of equal high
/// halves the low one is zero, so that comparing halves is enough.
inline Pair zero_for_made_nan(Pair p) {
  const __m128i made = _mm_set1_epi64x(static_cast<long long>(kMadeNan));
  const __m128i bits = _mm_castpd_si128(p);
  return _mm_castsi128_pd(_mm_andnot_si128(_mm_cmpeq_epi32(bits, made), bits));
}

#else  // any other processor: two scalars behind fences

struct Pair {
  double a, b;
};
inline constexpr Pair make_pair(double first, double second) { return {first, second}; }
inline constexpr double first(Pair p) { return p.a; }
inline constexpr double second(Pair p) { return p.b; }
inline Pair swapped(Pair p) { return {p.b, p.a}; }
inline Pair both_first(Pair p) { return {p.a, p.a}; }
inline Pair both_second(Pair p) { return {p.b, p.b}; }
inline Pair flip(Pair p, std::uint64_t first_bits, std::uint64_t second_bits) {
  return {fenced(std::bit_cast<double>(std::bit_cast<std::uint64_t>(p.a) ^ first_bits)),
          fenced(std::bit_cast<double>(std::bit_cast<std::uint64_t>(p.b) ^ second_bits))};
}
inline Pair negated(Pair p) { return flip(p, kSignBit, kSignBit); }
inline double or_nan(double a, double b, double result) {
  return is_nan(a) || is_nan(b) ? kEmptyBound : result;
}
inline Pair added(Pair p, Pair q) {
  return {or_nan(p.a, q.a, fenced(fenced(p.a) + fenced(q.a))),
          or_nan(p.b, q.b, fenced(fenced(p.b) + fenced(q.b)))};
}
inline double product(double a, double b) {
  const double p = fenced(fenced(a) * fenced(b));
  return or_nan(a, b, is_nan(p) ? std::bit_cast<double>(kMadeNan) : p);
}
inline Pair multiplied(Pair p, Pair q) { return {product(p.a, q.a), product(p.b, q.b)}; }
inline Pair divided(Pair p, Pair q) {
  return {or_nan(p.a, q.a, fenced(fenced(p.a) / fenced(q.a))),
          or_nan(p.b, q.b, fenced(fenced(p.b) / fenced(q.b)))};
}
inline double larger_or_second(double a, double b) {
  return is_nan(a) || is_nan(b) ? b : larger(a, b);
}
inline double smaller_or_second(double a, double b) {
  return is_nan(a) || is_nan(b) ? b : smaller(a, b);
}
inline Pair larger(Pair p, Pair q) {
  return {larger_or_second(p.a, q.a), larger_or_second(p.b, q.b)};
}
inline Pair smaller(Pair p, Pair q) {
  return {smaller_or_second(p.a, q.a), smaller_or_second(p.b, q.b)};
}
inline double square_root(double v) { return fenced(__builtin_sqrt(fenced(v))); }
inline Pair zero_for_made_nan(Pair p) {
  const auto fix = [](double v) { return std::bit_cast<std::uint64_t>(v) == kMadeNan ? 0.0 : v; };
  return {fix(p.a), fix(p.b)};
}

#endif

}  // namespace veritope::internal
