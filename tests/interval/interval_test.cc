// SPDX-License-Identifier: LGPL-3.0-or-later
#include "interval/interval.h"

#include <gtest/gtest.h>
#include <immintrin.h>

#include <bit>
#include <cfenv>
#include <cmath>
#include <limits>

#include "robust/base/fp_guard.h"
#include "robust/base/random.h"
#include "robust/binary64.h"

namespace veritope {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

TEST(ScopedUpward, RoundsUpInsideAndRestoresTheCallersWord) {
  const unsigned before = _mm_getcsr();
  {
    const ScopedUpward upward;
    EXPECT_GT(fenced(fenced(1.0) + fenced(0x1p-60)), 1);
    EXPECT_EQ(fenced(fenced(-1.0) - fenced(0x1p-60)), -1);
  }
  EXPECT_EQ(_mm_getcsr() & ~0x3fu, before & ~0x3fu);
  EXPECT_EQ(fenced(fenced(1.0) + fenced(0x1p-60)), 1);
}

TEST(ScopedUpward, OverridesACallersModeAndFlushing) {
  const unsigned saved = _mm_getcsr();
  _mm_setcsr(saved | 0xe040u);  // toward zero, FTZ, DAZ
  Interval product;
  {
    const ScopedUpward upward;
    product = Interval(0x1p-600) * Interval(0x1p-600);
  }
  const unsigned after = _mm_getcsr();
  _mm_setcsr(saved);
  EXPECT_EQ(after & 0xe040u, 0xe040u);
  EXPECT_EQ(product.lo(), 0);
  EXPECT_EQ(std::bit_cast<std::uint64_t>(product.hi()), 1u)
      << "a product that underflows is not certainly zero";
  EXPECT_EQ(product.sign(), Sign3::kUncertain);
}

// Exact results as Rationals, to compare bound by bound.
struct Exact {
  Rational lo, hi;
};
Interval tightest(const Exact& e) {
  return Interval::from_bounds(round_down(e.lo), round_up(e.hi));
}
Exact product(const Exact& a, const Exact& b) {
  Exact out{a.lo * b.lo, a.lo * b.lo};
  for (const Rational& v : {a.lo * b.hi, a.hi * b.lo, a.hi * b.hi}) {
    if (v < out.lo) out.lo = v;
    if (v > out.hi) out.hi = v;
  }
  return out;
}

TEST(Interval, OperationsGiveTheTightestBoundsForFiniteIntervals) {
  Random random(21);
  const auto draw = [&](int kind) {
    for (;;) {
      double v = std::bit_cast<double>(random.next());
      if (kind == 0) v = static_cast<double>(random.between(-3, 3));
      if (kind == 1)
        v = std::ldexp(2 * random.unit() - 1, static_cast<int>(random.between(-20, 20)));
      if (kind == 2) v = static_cast<double>(random.between(-9, 9)) * 0x1p-1074;
      if (is_finite(v)) return v;
    }
  };
  for (int i = 0; i < 40000; ++i) {
    double x[4];
    for (double& v : x) v = draw(i % 5);
    if (x[0] > x[1]) std::swap(x[0], x[1]);
    if (x[2] > x[3]) std::swap(x[2], x[3]);
    const Exact p{Rational::from_double(x[0]), Rational::from_double(x[1])},
        q{Rational::from_double(x[2]), Rational::from_double(x[3])};
    const Interval a = Interval::from_bounds(x[0], x[1]), b = Interval::from_bounds(x[2], x[3]);
    Interval sum, difference, times, square, negated;
    {
      const ScopedUpward upward;
      sum = a + b, difference = a - b, times = a * b, square = sqr(a), negated = -a;
    }
    const auto expect_bounds = [&](const Interval& got, const Exact& exact) {
      EXPECT_EQ(got.lo(), tightest(exact).lo()) << to_string(a) << ' ' << to_string(b);
      EXPECT_EQ(got.hi(), tightest(exact).hi()) << to_string(a) << ' ' << to_string(b);
      EXPECT_TRUE(contains(got, exact.lo) && contains(got, exact.hi));
    };
    expect_bounds(sum, {p.lo + q.lo, p.hi + q.hi});
    expect_bounds(difference, {p.lo - q.hi, p.hi - q.lo});
    expect_bounds(times, product(p, q));
    expect_bounds(negated, {-p.hi, -p.lo});
    Exact s{p.lo * p.lo, p.lo * p.lo};
    if (p.hi * p.hi > s.hi) s.hi = p.hi * p.hi;
    if (p.hi * p.hi < s.lo) s.lo = p.hi * p.hi;
    if (p.lo.sign() * p.hi.sign() != Sign::kPositive) s.lo = Rational();
    expect_bounds(square, s);
    if (HasFailure()) FAIL() << i;
  }
}

TEST(Interval, KeepsEnclosingAfterOverflow) {
  const ScopedUpward upward;
  const Interval huge(0x1.fffffffffffffp1023), over = huge * huge, zero;
  EXPECT_EQ(over.hi(), kInfinity);
  EXPECT_EQ(over.lo(), 0x1.fffffffffffffp1023);
  EXPECT_EQ((over * zero).sign(), Sign3::kZero);
  EXPECT_EQ((zero * over).sign(), Sign3::kZero);
  EXPECT_EQ((over - over).sign(), Sign3::kUncertain);
  const Interval both = Interval::from_bounds(-kInfinity, kInfinity);
  EXPECT_EQ((both * zero).sign(), Sign3::kZero);
  EXPECT_EQ((both * both).lo(), -kInfinity);
  EXPECT_EQ((both * both).hi(), kInfinity);
  EXPECT_EQ((both * over).sign(), Sign3::kUncertain);
  EXPECT_EQ(sqr(both).lo(), 0);
  EXPECT_EQ((-over).lo(), -kInfinity);
  // [0, 1] * [-infinity, 5]: 0 * infinity is 0, not NaN.
  const Interval half_line = Interval::from_bounds(-kInfinity, 5);
  EXPECT_EQ((Interval::from_bounds(0, 1) * half_line).lo(), -kInfinity);
  EXPECT_EQ((Interval::from_bounds(0, 1) * half_line).hi(), 5);
  EXPECT_TRUE(contains(both, Rational::power_of_two(3000)));
}

TEST(Interval, TellsTheSignThatAllMembersHave) {
  EXPECT_EQ(Interval::from_bounds(1, 2).sign(), Sign3::kPositive);
  EXPECT_EQ(Interval::from_bounds(-2, -1).sign(), Sign3::kNegative);
  EXPECT_EQ(Interval::from_bounds(-0.0, 0.0).sign(), Sign3::kZero);
  EXPECT_EQ(Interval::from_bounds(0, 1).sign(), Sign3::kUncertain);
  EXPECT_EQ(Interval::from_bounds(-1, 0).sign(), Sign3::kUncertain);
  EXPECT_EQ(sign_of(Interval(5.0)), Sign3::kPositive);
}

TEST(Interval, EnclosesRationalsAsTightlyAsCanBe) {
  const Rational third(Integer(1), Integer(3));
  const Interval a = enclose(third);
  EXPECT_TRUE(contains(a, third));
  EXPECT_EQ(std::nextafter(a.lo(), 1), a.hi());
  EXPECT_FALSE(contains(a, Rational(Integer(1), Integer(2))));
  EXPECT_FALSE(contains(a, Rational(0)));
  EXPECT_EQ(to_string(Interval::from_bounds(-0.5, 0.1)), "[-0.5, 0.10000000000000001]");
}

}  // namespace
}  // namespace veritope
