// SPDX-License-Identifier: LGPL-3.0-or-later
// predicates/generated/scaling.h: doubles as integers, by one power of two for a scale. Numbers of
// power p in it (coordinates 1, squared lengths 2) are multiplied by 2^(p k) with the least k that
// makes all of them integers. By their bits: right in every floating-point environment.
#pragma once
#include <array>
#include <bit>
#include <climits>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "robust/binary64.h"
#include "robust/bounded.h"
#include "robust/dyadic.h"
#include "robust/filter.h"
#include "robust/wide.h"

namespace veritope {

/// By doubling: a Wide is made from doubles in units that are not 1.
template <int N, int Limbs>
Wide<Limbs> multiple(const Wide<Limbs>& x) {
  if constexpr (N == 1) {
    return x;
  } else {
    const Wide<Limbs> half = multiple<N / 2>(x);
    return N % 2 == 0 ? half + half : (half + half) + x;
  }
}

}  // namespace veritope

namespace veritope::internal {

/// What lattice tiers hold: |coordinate| <= 2^60 and 2^124; power 2: the squares.
inline constexpr int kOneLimbBits = 60, kTwoLimbBits = 124;

/// Mantissas that are odd or zero, with their exponents. REQUIRES finite numbers.
template <std::size_t N>
std::array<Binary64, N> odd_parts(const std::array<double, N>& c) {
  std::array<Binary64, N> parts;
  for (std::size_t i = 0; i < N; ++i) {
    parts[i] = split(c[i]);
    const auto bits = static_cast<std::uint64_t>(parts[i].mantissa);
    const int zeros = bits == 0 ? 0 : std::countr_zero(bits);
    parts[i].mantissa >>= zeros;  // exact
    parts[i].exponent += zeros;
  }
  return parts;
}

/// The k of one scale.
class CommonScale {
 public:
  template <int Power, std::size_t N>
  void include(const std::array<Binary64, N>& parts) {
    for (const Binary64& p : parts) {
      if (p.mantissa == 0) continue;
      const int wanted = (-p.exponent + (p.exponent < 0 ? Power - 1 : 0)) / Power;  // rounded up
      k_ = wanted > k_ ? wanted : k_;
    }
  }
  /// Of a number of this power, >= 0 unless the mantissa is zero.
  template <int Power>
  int shift(const Binary64& p) const {
    return p.exponent + Power * k_;
  }

 private:
  int k_ = INT_MIN / 8;
};

/// out = the numbers as integers of at most 2^(Power Bits). False if one is larger.
template <int Power, int Bits, std::size_t N>
bool put(const CommonScale& scale, const std::array<Binary64, N>& parts,
         std::array<Bounded<Power * Bits>, N>& out) {
  using Held = typename Bounded<Power * Bits>::Held;
  bool fits = true;
  std::array<int, N> shifts{};
  for (std::size_t i = 0; i < N; ++i) {
    const std::int64_t m = parts[i].mantissa;
    if (m == 0) continue;
    shifts[i] = scale.shift<Power>(parts[i]);
    const auto magnitude = static_cast<std::uint64_t>(m < 0 ? -m : m);
    fits &= static_cast<int>(std::bit_width(magnitude)) + shifts[i] <= Power * Bits;
  }
  if (!fits) return false;
  for (std::size_t i = 0; i < N; ++i) {
    out[i] = Bounded<Power * Bits>::trusted(Held(parts[i].mantissa) << shifts[i]);
  }
  return true;
}

/// v / 2^(Power kMinExponent): 1 is 2^-kMinExponent units. Less than 2^(2099 Power) in magnitude.
template <typename T, int Power>
T wide(double v) {
  if constexpr (Power == 1) {
    return T::from_double(v);
  } else {
    return wide<T, Power - 1>(v) * T::from_double(1.0);
  }
}

/// For polynomials that no scaling turns into integers.
template <std::size_t N>
std::array<Dyadic, N> dyadics(const std::array<double, N>& c) {
  std::array<Dyadic, N> out;
  for (std::size_t i = 0; i < N; ++i) out[i] = Dyadic::from_double(c[i]);
  return out;
}

/// The largest magnitude. REQUIRES no NaN.
template <typename... Rest>
[[gnu::always_inline]] inline double largest_of(double v, Rest... rest) {
  if constexpr (sizeof...(Rest) == 0) {
    return std::abs(v);
  } else {
    return larger(std::abs(v), largest_of(rest...));
  }
}
/// m^N, from left to right.
template <int N, typename T>
constexpr T power_of(const T& m) {
  if constexpr (N == 1) {
    return m;
  } else {
    return power_of<N - 1>(m) * m;
  }
}

}  // namespace veritope::internal
