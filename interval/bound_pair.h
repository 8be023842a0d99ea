// SPDX-License-Identifier: LGPL-3.0-or-later
// interval/bound_pair.h: two binary64 numbers that are computed side by side, each rounded as the
// thread's control word says. Every operation is one machine instruction of an asm volatile: no
// compiler flag (-ffast-math, -Ofast, contraction) can reorder, fold, fuse or assume anything.
// Numbers that may be NaN or infinite are held as integers: with -ffinite-math-only, clang assumes that a double
// parameter or result is finite, even where it is only copied.
#pragma once
#include <bit>
#include <cstdint>
#include <type_traits>

#include "interval/upward.h"

namespace veritope::internal {

using Bits = std::uint64_t;  ///< of a binary64 number

inline constexpr Bits kSignBit = Bits{1} << 63;
inline constexpr Bits kInfiniteBits = 0x7ff0000000000000u;
/// The NaN that 0 * infinity gives on x86, whose low 32 bits are zero; an empty interval's NaN has other high bits.
inline constexpr Bits kMadeNan = 0xfff8000000000000u;
inline constexpr Bits kEmptyBound = ~kSignBit;

constexpr Bits bits_of(double v) {
  Bits bits = std::bit_cast<Bits>(v);
  // Hides the origin of the bits: a test of bits for 0 must not become a comparison of doubles (robust/binary64.h).
  if (!std::is_constant_evaluated()) asm("" : "+r"(bits));
  return bits;
}
/// Keys are ordered as the numbers are; -0 and 0 have the same key. Keys are integers, so that neither compiler flags
/// nor DAZ spoil a comparison. Infinities are ordered; the key of a NaN means nothing.
constexpr std::int64_t key_of(Bits v) {
  const auto bits = static_cast<std::int64_t>(v);
  return bits < 0 ? INT64_MIN - bits : bits;
}
constexpr bool is_nan(Bits v) { return (v & ~kSignBit) > kInfiniteBits; }
constexpr bool is_infinite(Bits v) { return (v & ~kSignBit) == kInfiniteBits; }
constexpr Bits negated(Bits v) { return v ^ kSignBit; }
constexpr bool less(Bits a, Bits b) { return key_of(a) < key_of(b); }
constexpr bool less_equal(Bits a, Bits b) { return key_of(a) <= key_of(b); }
/// Returns the first argument if the two are equal, as 0 and -0 are.
constexpr Bits larger(Bits a, Bits b) { return less(a, b) ? b : a; }
constexpr Bits smaller(Bits a, Bits b) { return less(b, a) ? b : a; }

// Overloads for doubles that are known to be numbers, or for files whose compiler flags we choose.
constexpr std::int64_t order_key(double v) { return key_of(bits_of(v)); }
constexpr bool is_nan(double v) { return is_nan(bits_of(v)); }
constexpr bool is_infinite(double v) { return is_infinite(bits_of(v)); }
constexpr double negated(double v) { return std::bit_cast<double>(negated(bits_of(v))); }
constexpr bool less(double a, double b) { return less(bits_of(a), bits_of(b)); }
constexpr double larger(double a, double b) { return less(a, b) ? b : a; }
constexpr double smaller(double a, double b) { return less(b, a) ? b : a; }

#if defined(__SSE2__)

using Pair = __m128i;

constexpr Pair make_pair(Bits first, Bits second) {
  return Pair{static_cast<long long>(first), static_cast<long long>(second)};
}
inline Bits first(Pair p) { return static_cast<Bits>(_mm_cvtsi128_si64(p)); }
inline Bits second(Pair p) {
  return static_cast<Bits>(_mm_cvtsi128_si64(_mm_unpackhi_epi64(p, p)));
}
// pshufd is the one shuffle of SSE2 that leaves its operand unchanged, so that no copy is needed.
inline Pair swapped(Pair p) { return _mm_shuffle_epi32(p, 0x4e); }
inline Pair both_first(Pair p) { return _mm_shuffle_epi32(p, 0x44); }
inline Pair both_second(Pair p) { return _mm_shuffle_epi32(p, 0xee); }
inline Pair low_and_high(Pair low, Pair high) { return _mm_unpacklo_epi64(low, high); }
inline Pair flip(Pair p, Pair mask) { return _mm_xor_si128(p, mask); }
/// In each place the number of `plus` or of `minus`, as the sign bit of `sign` says.
inline Pair chosen_by_sign(Pair sign, Pair plus, Pair minus) {
  const Pair is_minus = _mm_shuffle_epi32(_mm_srai_epi32(sign, 31), 0xf5);
  return _mm_or_si128(_mm_andnot_si128(is_minus, plus), _mm_and_si128(is_minus, minus));
}

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

[[gnu::always_inline]] inline Pair square_root(Pair v) {
  asm volatile("sqrtpd %0, %0" : "+x"(v));
  return v;
}
/// Replaces the NaN that 0 * infinity makes by 0; an empty operand's NaN stays. It is enough to compare halves: where
/// the high halves are equal, the low one is zero.
inline Pair zero_for_made_nan(Pair p) {
  return _mm_andnot_si128(_mm_cmpeq_epi32(p, make_pair(kMadeNan, kMadeNan)), p);
}

#else  // any other processor: two scalars behind fences

#if defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__ != 0
#error "veritope: -ffinite-math-only is not allowed here on processors without SSE2"
#endif

struct Pair {
  Bits a, b;
};
constexpr Pair make_pair(Bits first, Bits second) { return {first, second}; }
inline constexpr Bits first(Pair p) { return p.a; }
inline constexpr Bits second(Pair p) { return p.b; }
inline Pair swapped(Pair p) { return {p.b, p.a}; }
inline Pair both_first(Pair p) { return {p.a, p.a}; }
inline Pair both_second(Pair p) { return {p.b, p.b}; }
inline Pair low_and_high(Pair low, Pair high) { return {low.a, high.a}; }
inline Pair flip(Pair p, Pair mask) { return {p.a ^ mask.a, p.b ^ mask.b}; }
inline Pair chosen_by_sign(Pair sign, Pair plus, Pair minus) {
  return {(sign.a & kSignBit) != 0 ? minus.a : plus.a, (sign.b & kSignBit) != 0 ? minus.b : plus.b};
}
inline double number(Bits v) { return fenced(std::bit_cast<double>(v)); }
// f of two numbers; the empty bound if either is NaN. A NaN that f itself makes becomes kMadeNan.
template <typename F>
Bits lane(Bits a, Bits b, F f) {
  if (is_nan(a) || is_nan(b)) return kEmptyBound;
  const Bits out = bits_of(fenced(f(number(a), number(b))));
  return is_nan(out) ? kMadeNan : out;
}
template <typename F>
Pair lanes(Pair p, Pair q, F f) {
  return {lane(p.a, q.a, f), lane(p.b, q.b, f)};
}
inline Pair added(Pair p, Pair q) {
  return lanes(p, q, [](double x, double y) { return x + y; });
}
inline Pair multiplied(Pair p, Pair q) {
  return lanes(p, q, [](double x, double y) { return x * y; });
}
inline Pair divided(Pair p, Pair q) {
  return lanes(p, q, [](double x, double y) { return x / y; });
}
inline Bits larger_or_second(Bits a, Bits b) { return is_nan(a) || is_nan(b) ? b : larger(a, b); }
inline Bits smaller_or_second(Bits a, Bits b) { return is_nan(a) || is_nan(b) ? b : smaller(a, b); }
inline Pair larger(Pair p, Pair q) {
  return {larger_or_second(p.a, q.a), larger_or_second(p.b, q.b)};
}
inline Pair smaller(Pair p, Pair q) {
  return {smaller_or_second(p.a, q.a), smaller_or_second(p.b, q.b)};
}
inline Pair square_root(Pair p) {
  return lanes(p, p, [](double x, double) { return __builtin_sqrt(x); });
}
inline Pair zero_for_made_nan(Pair p) {
  return {p.a == kMadeNan ? 0 : p.a, p.b == kMadeNan ? 0 : p.b};
}

#endif

inline Pair negated(Pair p) { return flip(p, make_pair(kSignBit, kSignBit)); }

}  // namespace veritope::internal
