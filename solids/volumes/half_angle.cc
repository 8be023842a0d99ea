// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/volumes/half_angle.h"

#include <algorithm>
#include <utility>

#include "robust/base/check.h"

namespace veritope::internal {
namespace {

// The sum of (-1)^i x^(2i + first) / denominator(i) until a term is at most 2^-bits: as the terms fall and alternate,
// the sum lies between the last two partial sums.
template <typename Denominator>
RationalRange alternating(const Rational& x, int first, std::int64_t bits,
                          Denominator denominator) {
  const Rational least = Rational::power_of_two(-bits), square = x * x;
  Rational power = first == 0 ? Rational(1) : x, sum, before;
  for (int i = 0;; ++i, power *= square) {
    const Rational term = power / Rational(denominator(i));
    before = sum;
    sum += i % 2 == 0 ? term : -term;
    if (term <= least) return {std::min(before, sum), std::max(before, sum)};
  }
}

// atan(1 / n).
RationalRange arc_tangent_of_one_over(std::int64_t n) {
  return alternating(Rational(Integer(1), Integer(n)), 1, 130,
                     [](int i) { return Integer(2 * i + 1); });
}

// (2i + first)!, called with i = 0, 1, 2, ... in turn.
auto factorials(int first) {
  return [value = Integer(1), first](int i) mutable {
    if (i > 0) value *= Integer((2 * i + first) * (2 * i + first - 1));
    return value;
  };
}

// The number rounded down to a multiple of 2^-bits.
Rational rounded_down(const Rational& x, std::uint64_t bits) {
  return Rational(floor_divide(x.numerator() << bits, x.denominator())) *
         Rational::power_of_two(-static_cast<std::int64_t>(bits));
}

}  // namespace

// Machin: pi / 4 = 4 atan(1/5) - atan(1/239).
const RationalRange& pi_range() {
  static const RationalRange pi = [] {
    const RationalRange a = arc_tangent_of_one_over(5), b = arc_tangent_of_one_over(239);
    return RationalRange{Rational(16) * a.lo - Rational(4) * b.hi,
                         Rational(16) * a.hi - Rational(4) * b.lo};
  }();
  return pi;
}

// Sine and cosine are monotone from 0 to 45 degrees. The angle is rounded to as many bits below its first as the
// tangent needs.
RationalRange tangent_range(const Rational& degrees) {
  VT_CHECK(degrees.sign() != Sign::kNegative && degrees <= Rational(45),
           "tangents are computed from 0 to 45 degrees");
  if (degrees.sign() == Sign::kZero) return {};
  const auto small = std::max<std::int64_t>(
      0, static_cast<std::int64_t>(degrees.denominator().bit_length()) -
             static_cast<std::int64_t>(degrees.numerator().bit_length()) + 8);
  const auto bits = 110 + static_cast<std::uint64_t>(small);
  const Rational part = degrees / Rational(180),
                 step = Rational::power_of_two(-static_cast<std::int64_t>(bits));
  const Rational lo = rounded_down(part * pi_range().lo, bits),
                 hi = rounded_down(part * pi_range().hi, bits) + step;
  const auto terms = static_cast<std::int64_t>(bits);
  const auto sine = [&](const Rational& x) { return alternating(x, 1, terms, factorials(1)); };
  const auto cosine = [&](const Rational& x) { return alternating(x, 0, terms, factorials(0)); };
  return {sine(lo).lo / cosine(lo).hi, sine(hi).hi / cosine(hi).lo};
}

RationalRange square_root_range(const Rational& square) {
  VT_CHECK(square.sign() == Sign::kPositive, "the square root of a positive number");
  const Integer product = square.numerator() * square.denominator();
  const std::uint64_t half = product.bit_length() / 2, shift = half < 104 ? 104 - half : 0;
  const Integer scaled = product << (2 * shift);
  const Integer root = floor_sqrt(scaled);
  const Rational unit(Integer(1), square.denominator() << shift);
  const Rational lo = Rational(root) * unit;
  return {lo, root * root == scaled ? lo : Rational(root + Integer(1)) * unit};
}

}  // namespace veritope::internal
