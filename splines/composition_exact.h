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

  /// The map itself, in lowest terms. @cost one greatest common divisor per coefficient
  Bezier<Rational, N> to_rational() const;
};

/// Integers longer than this are computed directly, not by remainders; 512 primes are enough for this length.
inline constexpr std::uint64_t kMaxRemainderBits = 31000;
/// The limit on the bits of all coefficients together: 1 GiB.
inline constexpr std::uint64_t kMaxExactBits = std::uint64_t{1} << 33;

/// outer(inner(x)) exactly: to_rational() equals the result of compose() over Rational, bit for bit. All finite doubles
/// are accepted. Time grows with the bits of the result's integers, approximately (1 + sum of outer degrees) times the
/// bits between the highest and the lowest bit of all coefficients of a map: 56 in doubles of one magnitude, 2098 at
/// most.
/// @error as compose(); kNotFinite with the offending coefficient's number; kOverLimit if the integers could exceed
/// kMaxExactBits.
/// @cost  for a tricubic map in a tricubic volume 11 primes, and per prime and component approximately 4 million
///        products modulo the prime
template <std::size_t M, std::size_t N>
Result<ScaledBezier<N>> compose_exact(const Bezier<double, M>& outer,
                                      const Bezier<double, N>& inner);

namespace internal {

/// Chooses between the two ways of compose_exact: by the bits, or one way whatever the bits.
enum class ExactWay { kByBits, kRemainders, kIntegers };
template <std::size_t M, std::size_t N>
Result<ScaledBezier<N>> compose_exact_by(ExactWay way, const Bezier<double, M>& outer,
                                         const Bezier<double, N>& inner);

}  // namespace internal
}  // namespace veritope
