// SPDX-License-Identifier: LGPL-3.0-or-later
// splines/composition_exact.h: composition of Bezier maps of binary64 numbers, exactly, by remainders modulo primes.
// Design: docs/design/0009-composition.md.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "robust/base/result.h"
#include "robust/integer.h"
#include "splines/bezier.h"

namespace veritope {

/// A Bezier map with dyadic scaled coefficients: the coefficient with index (i, j, ...) is
/// scaled * 2^exponent / (C(n_1, i) C(n_2, j) ...), exactly. Layout as in Bezier.
template <std::size_t N>
struct ScaledBezier {
  std::array<int, N> degrees{};
  int num_components = 0;
  bool is_rational = false;
  std::int64_t exponent = 0;
  std::vector<Integer> scaled;

  /// The map itself, in lowest terms. @cost a greatest common divisor a coefficient
  Bezier<Rational, N> to_rational() const;
};

/// Integers longer than this are computed as such, not by remainders: 512 primes.
inline constexpr std::uint64_t kMaxRemainderBits = 31000;
/// All coefficients together: 1 GiB.
inline constexpr std::uint64_t kMaxExactBits = std::uint64_t{1} << 33;

/// outer(inner(x)) exactly: to_rational() is what compose() over Rational says, bit for bit. All finite doubles are
/// taken. Time grows with the bits of the result's integers, about (1 + sum of outer degrees) times the bits between
/// the highest and the lowest bit of all coefficients of a map: 56 in doubles of one magnitude, 2098 at most.
/// @error as compose(); kNotFinite with the offending coefficient's number; kOverLimit if the integers could exceed
/// kMaxExactBits.
/// @cost  for a tricubic map in a tricubic volume 11 primes, and for each about 4 million products modulo it a
/// component
template <std::size_t M, std::size_t N>
Result<ScaledBezier<N>> compose_exact(const Bezier<double, M>& outer,
                                      const Bezier<double, N>& inner);

namespace internal {

/// The two ways of compose_exact, whatever the bits.
enum class ExactWay { kByBits, kRemainders, kIntegers };
template <std::size_t M, std::size_t N>
Result<ScaledBezier<N>> compose_exact_by(ExactWay way, const Bezier<double, M>& outer,
                                         const Bezier<double, N>& inner);

}  // namespace internal
}  // namespace veritope
