// SPDX-License-Identifier: LGPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>

#include "interval/formula/quick_functions_internal.h"
#include "interval/functions.h"
#include "interval/mp_interval.h"
#include "interval/numeric.h"
#include "interval/relations.h"
#include "interval/upward.h"
#include "tests/interval/draw.h"
#include "tests/predicates/test_scale.h"

namespace veritope {
namespace {

using Function = Interval (*)(const Interval&);

Interval quick(Function f, const Interval& x) {
  const ScopedUpward upward;
  return f(x);
}

// Contains the tightest enclosure, and has at most `most` in excess of its width.
void expect_close(Function f, Function tightest, const Interval& x, double most) {
  const Interval got = quick(f, x), want = tightest(x);
  EXPECT_TRUE(is_subset(want, got)) << to_string(x) << to_string(want) << to_string(got);
  EXPECT_LE(wid(got), wid(want) + most) << to_string(x) << to_string(want) << to_string(got);
}

TEST(QuickFunctions, WavesContainTheTightestIntervalsAndAreHardlyWider) {
  Random random(721);
  for (long i = 0; i < scaled(20000); ++i) {
    const double size = std::ldexp(1.0, static_cast<int>(random.between(-40, 21)));
    const double lo = size * (2 * random.unit() - 1);
    const Interval point(lo);
    expect_close(internal::quick_sin, sin, point, 0x1p-50);
    expect_close(internal::quick_cos, cos, point, 0x1p-50);
    const double width = std::ldexp(random.unit(), -static_cast<int>(random.below(50)));
    const Interval narrow = Interval::from_bounds(lo, lo + width);
    expect_close(internal::quick_sin, sin, narrow, 8 * width + 0x1p-50);
    expect_close(internal::quick_cos, cos, narrow, 8 * width + 0x1p-50);
    if (HasFailure()) FAIL() << i;
  }
}

TEST(QuickFunctions, WavesAreRightBesideMultiplesOfAQuarterTurnAndOnAnyInterval) {
  for (int k = -2000; k <= 2000; ++k)
    for (int d = -2; d <= 2; ++d) {
      const Interval x(std::nextafter(k * 0x1.921fb54442d18p-1, 4000.0 * d));
      expect_close(internal::quick_sin, sin, x, 0x1p-50);
      expect_close(internal::quick_cos, cos, x, 0x1p-50);
    }
  Random random(722);
  for (long i = 0; i < scaled(3000); ++i) {
    const Interval x = draw_interval(random);
    EXPECT_TRUE(is_subset(sin(x), quick(internal::quick_sin, x))) << to_string(x);
    EXPECT_TRUE(is_subset(cos(x), quick(internal::quick_cos, x))) << to_string(x);
    EXPECT_TRUE(is_subset(exp(x), quick(internal::quick_exp, x))) << to_string(x);
  }
}

TEST(QuickFunctions, ExponentialsContainTheTightestIntervalsAndAreHardlyWider) {
  Random random(723);
  for (long i = 0; i < scaled(20000); ++i) {
    const double lo = std::ldexp(2 * random.unit() - 1, static_cast<int>(random.between(-40, 10)));
    const double most = std::exp(std::min(lo, 700.0)) * 0x1p-49;
    expect_close(internal::quick_exp, exp, Interval(lo), std::max(most, 0x1p-1060));
    const Interval narrow = Interval::from_bounds(lo, lo + std::ldexp(random.unit(), -60));
    EXPECT_TRUE(is_subset(exp(narrow), quick(internal::quick_exp, narrow))) << to_string(narrow);
    if (HasFailure()) FAIL() << i << ' ' << lo;
  }
}

TEST(QuickFunctions, PowersContainTheTightestIntervals) {
  Random random(724);
  for (long i = 0; i < scaled(20000); ++i) {
    const std::int64_t n = random.between(-70, 70);
    const double lo = 4 * random.unit() - 2;
    const Interval x = Interval::from_bounds(lo, lo + 0.25 * random.unit());
    if (n < 0 && is_member(0, x)) continue;
    const Interval got = [&] {
      const ScopedUpward upward;
      return internal::quick_power(x, n);
    }();
    EXPECT_TRUE(is_subset(pown(x, n), got)) << n << to_string(x);
    if (n >= 0 && n % 2 == 0) {
      EXPECT_FALSE(got.lo() < 0) << n << to_string(x);
    }
  }
}

// Remainders by Lagrange: |r|^19 / 19! of the sine, |r|^20 / 20! of the cosine, exp(|r|) |r|^16 / 16! of the exponential,
// divided by the power of r that the last coefficient has. Dropped, they would hide below roundings of random tests.
TEST(QuickFunctions, LastCoefficientsContainTheRemainders) {
  const auto inverse_factorial = [](std::int64_t n) {
    Rational out(1);
    for (std::int64_t k = 2; k <= n; ++k) out /= Rational(k);
    return out;
  };
  const auto expect_between = [](const Interval& c, const Rational& least, const Rational& most) {
    EXPECT_TRUE(contains(c, least) && contains(c, most)) << to_string(c);
    const Rational width = Rational::from_double(c.hi()) - Rational::from_double(c.lo());
    EXPECT_LT(width, most - least + abs(most) * Rational::power_of_two(-48));
  };
  const internal::TaylorSeries series = [] {
    const ScopedUpward upward;
    return internal::TaylorSeries();
  }();
  const Rational turn = Rational::from_double(internal::TaylorSeries::kMostTurn),
                 rest = Rational::from_double(internal::TaylorSeries::kMostRest);
  const auto expect_series = [&](const auto& coefficients, bool alternates, int first, int step,
                                 const Rational& remainder) {
    for (std::size_t j = 0; j < coefficients.size(); ++j) {
      const Rational size = inverse_factorial(first + step * static_cast<int>(j));
      const Rational exact = alternates && j % 2 != 0 ? -size : size;
      const Rational slack = j + 1 == coefficients.size() ? remainder : Rational(0);
      expect_between(coefficients[j], exact - slack, exact + slack);
    }
  };
  expect_series(series.sine, true, 1, 2, turn * turn * inverse_factorial(19));
  expect_series(series.cosine, true, 0, 2, turn * turn * inverse_factorial(20));
  expect_series(series.exponent, false, 0, 1, Rational(2) * rest * inverse_factorial(16));
}

TEST(QuickFunctions, ConstantsEncloseHalfPiAndTheLogarithmOfTwo) {
  const auto sum = [](double a, double b, double c) {
    return Rational::from_double(a) + Rational::from_double(b) + Rational::from_double(c);
  };
  const MpInterval half_pi = MpInterval::pi(400) / MpInterval(Rational(2), 400);
  EXPECT_LT(sum(internal::kHalfPi1, internal::kHalfPi2, internal::kHalfPiLow), half_pi.lo());
  EXPECT_LT(half_pi.hi(), sum(internal::kHalfPi1, internal::kHalfPi2, internal::kHalfPiHigh));
  // log 2 lies between a and b iff exp(a) < 2 < exp(b).
  const auto exp_of = [&](double low) {
    return exp(MpInterval(sum(internal::kLog2, low, 0), 400));
  };
  EXPECT_LT(exp_of(internal::kLog2Low).hi(), Rational(2));
  EXPECT_LT(Rational(2), exp_of(internal::kLog2High).lo());
  // The remainder of the exponential series: exp(3/8) < 2.
  EXPECT_LT(exp(MpInterval(Rational(Integer(3), Integer(8)), 60)).hi(), Rational(2));
}

}  // namespace
}  // namespace veritope
