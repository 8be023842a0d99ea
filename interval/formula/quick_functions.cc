// SPDX-License-Identifier: LGPL-3.0-or-later
#include <array>
#include <cmath>
#include <cstddef>

#include "interval/formula/quick_functions_internal.h"
#include "interval/functions.h"
#include "interval/relations.h"

namespace veritope::internal {
namespace {

constexpr double kMostWaveArgument = 0x1p20;
constexpr double kMostTurn = TaylorSeries::kMostTurn, kMostRest = TaylorSeries::kMostRest;

Interval symmetric(double most) { return Interval::from_bounds(-most, most); }

}  // namespace

TaylorSeries::TaylorSeries() {
  std::array<Interval, 21> inverse_factorial;  // factorials up to 20! are binary64 numbers
  double factorial = 1;
  for (std::size_t n = 0; n < inverse_factorial.size(); ++n) {
    if (n > 0) factorial *= static_cast<double>(n);
    inverse_factorial[n] = recip(Interval(factorial));
  }
  const auto with_sign = [](std::size_t j, const Interval& x) { return j % 2 == 0 ? x : -x; };
  for (std::size_t j = 0; j < sine.size(); ++j)
    sine[j] = with_sign(j, inverse_factorial[2 * j + 1]);
  for (std::size_t j = 0; j < cosine.size(); ++j)
    cosine[j] = with_sign(j, inverse_factorial[2 * j]);
  for (std::size_t j = 0; j < exponent.size(); ++j) exponent[j] = inverse_factorial[j];
  // |sin(r) - series| <= |r|^19 / 19! = |r| (r^2)^8 (r^2 / 19!).
  const Interval square = sqr(Interval(kMostTurn));
  sine.back() += symmetric(1) * square * inverse_factorial[19];
  // |cos(r) - series| <= |r|^20 / 20! = (r^2)^9 (r^2 / 20!).
  cosine.back() += symmetric(1) * square * inverse_factorial[20];
  // |exp(r) - series| <= exp(|r|) |r|^16 / 16! <= |r|^15 (2 |r| / 16!), because exp(3/8) < 2.
  exponent.back() += symmetric(2 * kMostRest) * inverse_factorial[16];
}

namespace {

const TaylorSeries& taylor_series() {
  static const TaylorSeries series;
  return series;
}

// x = rest + quarters pi / 2, modulo 2 pi.
struct ReducedTurn {
  Interval rest;
  unsigned quarters;
};
// Any integer k is right, however the product was rounded; a bad one leaves a rest that is too large.
bool reduce_turn(const Interval& x, ReducedTurn* out) {
  const double lo = x.lo(), hi = x.hi();
  if (!(lo >= -kMostWaveArgument && hi <= kMostWaveArgument)) return false;
  constexpr double kInverse = 0x1.45f306dc9c883p-1;  // approximately 2 / pi
  const double quarters = lo * kInverse;
  const auto k = static_cast<std::int64_t>(quarters + (quarters < 0 ? -0.5 : 0.5));
  const Interval turns(static_cast<double>(k));
  out->rest = x - turns * Interval(kHalfPi1) - turns * Interval(kHalfPi2) -
              turns * Interval::from_bounds(kHalfPiLow, kHalfPiHigh);
  out->quarters = static_cast<unsigned>(k & 3);
  return is_subset(out->rest, symmetric(kMostTurn));
}

template <std::size_t N>
Interval horner_in_square(const std::array<Interval, N>& c, const Interval& square) {
  Interval sum = c[N - 1];
  for (std::size_t j = N - 1; j-- > 0;) sum = Interval::nonnegative_multiple(sum, square) + c[j];
  return sum;
}
// sin(rest + quarters pi / 2).
Interval turned_sine(const Interval& rest, unsigned quarters) {
  const TaylorSeries& series = taylor_series();
  const Interval square = sqr(rest);
  const Interval value = quarters % 2 == 0 ? rest * horner_in_square(series.sine, square)
                                           : horner_in_square(series.cosine, square);
  return quarters % 4 < 2 ? value : -value;
}

}  // namespace

Interval quick_sin(const Interval& x) {
  ReducedTurn reduced;
  return reduce_turn(x, &reduced) ? turned_sine(reduced.rest, reduced.quarters) : sin(x);
}
Interval quick_cos(const Interval& x) {
  ReducedTurn reduced;
  return reduce_turn(x, &reduced) ? turned_sine(reduced.rest, reduced.quarters + 1) : cos(x);
}

Interval quick_exp(const Interval& x) {
  const double lo = x.lo();
  if (!(lo >= -700 && x.hi() <= 700)) return exp(x);
  constexpr double kInverse = 0x1.71547652b82fep+0;  // approximately 1 / log 2
  const double doublings = lo * kInverse;
  const int k = static_cast<int>(doublings + (doublings < 0 ? -0.5 : 0.5));
  const Interval steps(static_cast<double>(k));
  const Interval rest =
      x - steps * Interval(kLog2) - steps * Interval::from_bounds(kLog2Low, kLog2High);
  if (!is_subset(rest, symmetric(kMostRest))) return exp(x);
  const auto& c = taylor_series().exponent;
  Interval sum = c.back();
  for (std::size_t j = c.size() - 1; j-- > 0;) sum = sum * rest + c[j];
  return Interval::nonnegative_multiple(sum, Interval(std::ldexp(1.0, k)));
}

Interval quick_power(const Interval& x, std::int64_t n) {
  constexpr std::int64_t kMostProducts = 64;
  if (n < -kMostProducts || n > kMostProducts) return pown(x, n);
  if (n < 0) return recip(quick_power(x, -n));
  Interval power(1.0), square = x;
  for (std::int64_t rest = n; rest > 0; rest /= 2) {
    if (rest % 2 != 0) power *= square;
    if (rest > 1) square = sqr(square);
  }
  return power;
}

}  // namespace veritope::internal
