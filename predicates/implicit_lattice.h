// SPDX-License-Identifier: LGPL-3.0-or-later
// predicates/implicit_lattice.h: converts many coordinates at once, as lattice.h does, to one digit each, on a lattice
// that can be kept for later ones.
#pragma once
#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

#include "predicates/lattice.h"
#include "robust/digits.h"

#if defined(__SSE2__)
#include <immintrin.h>
#endif

namespace veritope::internal {

/// Coordinates as integers: c * scale; unit = 1 / scale = 2^exponent. Both are normal numbers.
struct LatticeUnit {
  double scale, unit;
  int exponent;
};

/// The biased exponent of the largest |c[i]|.
template <std::size_t N>
[[gnu::always_inline]] inline std::uint64_t biased_exponent(const std::array<double, N>& c) {
#if defined(__SSE2__)
  // Under DAZ the largest of subnormal numbers may be any of them: their exponents are all 0.
  const __m128d sign = _mm_set1_pd(-0.0);
  __m128d even = _mm_setzero_pd(), odd = _mm_setzero_pd();
  std::size_t i = 0;
  for (; i + 4 <= N; i += 4) {
    even = _mm_max_pd(even, _mm_andnot_pd(sign, _mm_loadu_pd(&c[i])));
    odd = _mm_max_pd(odd, _mm_andnot_pd(sign, _mm_loadu_pd(&c[i + 2])));
  }
  for (; i < N; ++i) even = _mm_max_sd(even, _mm_andnot_pd(sign, _mm_load_sd(&c[i])));
  even = _mm_max_pd(even, odd);
  even = _mm_max_sd(even, _mm_unpackhi_pd(even, even));
  return std::bit_cast<std::uint64_t>(_mm_cvtsd_f64(even)) >> 52;
#else
  std::uint64_t largest = 0;
  for (const double v : c) largest = std::max(largest, std::bit_cast<std::uint64_t>(v) << 1 >> 53);
  return largest;
#endif
}

/// The lattice on which numbers with that biased exponent are less than 2^bits (much less, if they are below
/// approximately 2^-960).
inline LatticeUnit lattice_of(std::uint64_t biased, int bits) {
  const auto n = static_cast<std::uint64_t>(bits);
  biased = std::max(biased, n);
  return {std::bit_cast<double>((2045 + n - biased) << 52),
          std::bit_cast<double>((biased - n + 1) << 52), static_cast<int>(biased - n) - 1022};
}

/// Sets out[i] = c[i] * scale; returns false if some c[i] is not on the lattice. Correct in every floating-point
/// environment, as to_lattice is. REQUIRES |c[i] * scale| <= 2^62.
template <std::size_t N>
[[gnu::always_inline]] inline bool on_lattice(const LatticeUnit& lattice,
                                              const std::array<double, N>& c,
                                              std::array<Digits<1>, N>& out) {
  std::uint64_t differs = 0;
  std::size_t i = 0;
#if defined(__SSE2__)
  const __m128d scale = _mm_set1_pd(lattice.scale), unit = _mm_set1_pd(lattice.unit);
  __m128i differ = _mm_setzero_si128();
  for (; i + 2 <= N; i += 2) {
    const __m128d v = _mm_loadu_pd(&c[i]), t = _mm_mul_pd(v, scale);
    const std::int64_t low = _mm_cvttsd_si64(t), high = _mm_cvttsd_si64(_mm_unpackhi_pd(t, t));
    const __m128d back = _mm_unpacklo_pd(_mm_cvtsi64_sd(_mm_setzero_pd(), low),
                                         _mm_cvtsi64_sd(_mm_setzero_pd(), high));
    differ = _mm_or_si128(
        differ, _mm_xor_si128(_mm_castpd_si128(_mm_mul_pd(back, unit)), _mm_castpd_si128(v)));
    out[i].d[0] = low, out[i + 1].d[0] = high;
  }
  differ = _mm_slli_epi64(differ, 1);  // forgives -0
  differs = static_cast<std::uint64_t>(_mm_cvtsi128_si64(differ)) |
            static_cast<std::uint64_t>(_mm_cvtsi128_si64(_mm_unpackhi_epi64(differ, differ)));
#endif
  for (; i < N; ++i) {
    const std::int64_t v = static_cast<std::int64_t>(c[i] * lattice.scale);
    differs |= (std::bit_cast<std::uint64_t>(static_cast<double>(v) * lattice.unit) ^
                std::bit_cast<std::uint64_t>(c[i]))
               << 1;
    out[i].d[0] = v;
  }
  return differs == 0;
}

}  // namespace veritope::internal
