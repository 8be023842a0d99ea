// SPDX-License-Identifier: LGPL-3.0-or-later
#include "interval/mp_interval.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "interval/functions.h"
#include "interval/relations.h"
#include "robust/base/check.h"
#include "tests/interval/draw.h"
#include "tests/predicates/test_scale.h"

namespace veritope {
namespace {

TEST(MpInterval, WithManyBitsComputesExactlyWhatRationalsCompute) {
  Random random(51);
  for (long i = 0; i < scaled(3000); ++i) {
    const Rational x(Integer(random.between(-1000, 1000)), Integer(1)),
        y(Integer(random.between(-1000, 1000)), Integer(power_of_two(random.below(40))));
    const MpInterval a(x, 200), b(y, 100);
    EXPECT_EQ((a + b).precision(), 200);
    EXPECT_EQ((a + b).lo(), x + y);
    EXPECT_EQ((a - b).hi(), x - y);
    EXPECT_EQ((a * b).lo(), x * y);
    EXPECT_EQ(sqr(b).hi(), y * y);
    EXPECT_EQ(pown(a, 3).lo(), x * x * x);
    EXPECT_EQ((a * b).sign(), to_sign3(x.sign() * y.sign()));
    EXPECT_EQ(compare(a, b), x < y ? Sign3::kNegative : (y < x ? Sign3::kPositive : Sign3::kZero));
    if (y.sign() != Sign::kZero) {
      const MpInterval q = a / b;
      EXPECT_TRUE(contains(q, x / y));
      EXPECT_EQ(q.lo() == x / y, q.hi() == x / y);
    }
    if (HasFailure()) FAIL() << i << ' ' << x.to_string() << ' ' << y.to_string();
  }
}

TEST(MpInterval, With53BitsAgreesWithIntervalWhereNothingUnderflows) {
  Random random(52);
  const auto ordinary = [&] {
    const double a = 2 * random.unit() - 1, b = 2 * random.unit() - 1;
    return a < b ? Interval::from_bounds(a, b) : Interval::from_bounds(b, a);
  };
  for (long i = 0; i < scaled(4000); ++i) {
    const Interval a = ordinary(), b = ordinary();
    const MpInterval x(a, 53), y(b, 53);
    Interval want[6];
    {
      const ScopedUpward upward;
      want[0] = a + b, want[1] = a - b, want[2] = a * b, want[3] = a / b, want[4] = sqr(a),
      want[5] = sqrt(a);
    }
    const MpInterval got[6] = {x + y, x - y, x * y, x / y, sqr(x), sqrt(x)};
    for (int k = 0; k < 6; ++k)
      ASSERT_EQ(got[k].to_interval(), want[k]) << k << to_string(a) << to_string(b);
    for (int n : {2, 3, 5, 8}) ASSERT_EQ(pown(x, n).to_interval(), pown(a, n)) << n << to_string(a);
  }
}

TEST(MpInterval, NestsAsThePrecisionGrowsOnIntervalsOfAllKinds) {
  Random random(53);
  for (long i = 0; i < scaled(3000); ++i) {
    const Interval a = draw_interval(random), b = draw_interval(random);
    const MpInterval x(a, 60), y(b, 60), u(a, 140), v(b, 140);
    EXPECT_EQ(x.to_interval(), a);
    EXPECT_TRUE(is_subset(u + v, x + y) && is_subset(u - v, x - y) && is_subset(u * v, x * y) &&
                is_subset(u / v, x / y) && is_subset(sqr(u), sqr(x)) &&
                is_subset(sqrt(u), sqrt(x)) && is_subset(pown(u, -3), pown(x, -3)));
    Interval sum, product, quotient;
    {
      const ScopedUpward upward;
      sum = a + b, product = a * b, quotient = a / b;
    }
    EXPECT_TRUE(is_subset((u + v).to_interval(), sum) &&
                is_subset((u * v).to_interval(), product) &&
                is_subset((u / v).to_interval(), quotient));
    EXPECT_EQ(intersection(x, y).to_interval(), intersection(a, b));
    EXPECT_EQ(hull(x, y).to_interval(), hull(a, b));
    EXPECT_EQ(compare(x, y), compare(a, b));
    EXPECT_EQ((-x).to_interval(), -a);
    EXPECT_EQ(x.sign(), a.sign());
    if (HasFailure()) FAIL() << i << ' ' << to_string(a) << ' ' << to_string(b);
  }
}

TEST(MpInterval, EnclosesRationalsTightlyAndKnowsEmpty) {
  const Rational third(Integer(1), Integer(3));
  const MpInterval a(third, 10);
  EXPECT_TRUE(contains(a, third));
  EXPECT_EQ(a.hi() - a.lo(), Rational::power_of_two(-11));
  const MpInterval none = MpInterval::empty(10), zero(10);
  EXPECT_TRUE(none.is_empty() && (none + a).is_empty() && (none * a).is_empty() &&
              (a / none).is_empty());
  EXPECT_TRUE((a / zero).is_empty() && sqrt(-a).is_empty() && intersection(a, -a).is_empty());
  EXPECT_TRUE(pown(none, 2).is_empty() && none.to_interval().is_empty());
  EXPECT_EQ(none.sign(), Sign3::kUncertain);
  EXPECT_EQ(hull(none, a), a);
  EXPECT_FALSE(contains(none, third));
  EXPECT_FALSE(none.has_lo());
  EXPECT_THROW(none.lo(), InternalError);
  EXPECT_THROW(MpInterval(1), InternalError);
  MpInterval copy = a;
  copy = none;
  EXPECT_EQ(copy, none);
  copy = MpInterval(Interval::entire(), 10);
  EXPECT_FALSE(copy.has_lo() || copy.has_hi());
  EXPECT_EQ(zero.sign(), Sign3::kZero);
}

struct FunctionOfBoth {
  MpInterval (*first)(const MpInterval&);
  Interval (*second)(const Interval&);
};
const FunctionOfBoth kFunctions[] = {
    {[](const MpInterval& x) { return sin(x); }, [](const Interval& x) { return sin(x); }},
    {[](const MpInterval& x) { return cos(x); }, [](const Interval& x) { return cos(x); }},
    {[](const MpInterval& x) { return exp(x); }, [](const Interval& x) { return exp(x); }},
    {[](const MpInterval& x) { return abs(x); }, [](const Interval& x) { return abs(x); }},
};

TEST(MpInterval, With53BitsElementaryFunctionsAreThoseOfInterval) {
  Random random(54);
  const auto drawn = [&] {
    const double size = std::ldexp(1.0, static_cast<int>(random.between(-20, 6)));
    const double a = size * (2 * random.unit() - 1), b = size * (2 * random.unit() - 1);
    return random.below(4) == 0 ? Interval(a)
                                : Interval::from_bounds(std::min(a, b), std::max(a, b));
  };
  for (long i = 0; i < scaled(4000); ++i) {
    const Interval a = drawn(), b = drawn();
    const MpInterval x(a, 53), y(b, 53);
    for (const auto& f : kFunctions) {
      EXPECT_EQ(f.first(x).to_interval(), f.second(a));
      EXPECT_TRUE(is_subset(f.first(MpInterval(a, 200)), f.first(x)));
    }
    EXPECT_EQ(min(x, y).to_interval(), min(a, b));
    EXPECT_EQ(max(x, y).to_interval(), max(a, b));
    EXPECT_EQ(pow(x, y).to_interval(), pow(a, b));
    EXPECT_EQ(pow(x, y).is_empty(), pow(a, b).is_empty());
    if (HasFailure()) FAIL() << i << ' ' << to_string(a) << ' ' << to_string(b);
  }
}

TEST(MpInterval, ElementaryFunctionsEncloseOnIntervalsOfAllKinds) {
  Random random(55);
  for (long i = 0; i < scaled(1000); ++i) {
    const Interval a = draw_interval(random), b = draw_interval(random);
    const MpInterval x(a, 60), y(b, 60);
    for (const auto& f : kFunctions) EXPECT_TRUE(is_subset(f.first(x).to_interval(), f.second(a)));
    EXPECT_TRUE(is_subset(pow(x, y).to_interval(), pow(a, b)));
    EXPECT_EQ(min(x, y).to_interval(), min(a, b));
    EXPECT_EQ(max(x, y).to_interval(), max(a, b));
    if (HasFailure()) FAIL() << i << ' ' << to_string(a) << ' ' << to_string(b);
  }
  const MpInterval none = MpInterval::empty(30), one(Rational(1), 30);
  for (const auto& f : kFunctions) EXPECT_TRUE(f.first(none).is_empty());
  EXPECT_TRUE(min(none, one).is_empty() && max(one, none).is_empty() && pow(none, one).is_empty());
  EXPECT_TRUE(pow(-one, one).is_empty() && pow(MpInterval(30), -one).is_empty());
}

TEST(MpInterval, PiIsBetweenItsBoundsAndItsSineNear0) {
  const MpInterval pi = MpInterval::pi(300);
  EXPECT_TRUE(is_subset(pi, MpInterval::pi(60)));
  EXPECT_EQ(MpInterval::pi(53).to_interval(),
            Interval::from_bounds(0x1.921fb54442d18p+1, 0x1.921fb54442d19p+1));
  EXPECT_TRUE(contains(sin(pi), Rational(0)) && contains(cos(pi), Rational(-1)));
  EXPECT_LT(sin(pi).hi() - sin(pi).lo(), Rational::power_of_two(-290));
  // A turning point belongs to the range, and all of them belong to that of a whole turn.
  EXPECT_EQ(sin(hull(MpInterval(Rational(1), 60), MpInterval(Rational(2), 60))).hi(), Rational(1));
  const MpInterval turn = sin(hull(MpInterval(Rational(100), 60), MpInterval(Rational(107), 60)));
  EXPECT_TRUE(turn.lo() == Rational(-1) && turn.hi() == Rational(1));
}

TEST(MpInterval, NearestMultiplesAreThoseOfAllMembersWithTiesToEven) {
  const auto between = [](int a, int b, int halves) {
    return hull(MpInterval(Rational(Integer(a), Integer(halves)), 90),
                MpInterval(Rational(Integer(b), Integer(halves)), 90));
  };
  EXPECT_EQ(nearest_multiple(between(5, 5, 2), 0), 2);
  EXPECT_EQ(nearest_multiple(between(7, 7, 2), 0), 4);
  EXPECT_EQ(nearest_multiple(between(-5, -5, 2), 0), -2);
  EXPECT_EQ(nearest_multiple(between(3, 5, 2), 0), 2);  // 1.5 and 2.5 are ties
  EXPECT_EQ(nearest_multiple(between(5, 6, 2), 0), std::nullopt);
  EXPECT_EQ(nearest_multiple(between(5, 5, 2), -1), 5);
  EXPECT_EQ(nearest_multiple(between(5, 5, 1), 1), 2);
  EXPECT_EQ(nearest_multiple(MpInterval::empty(30), 0), std::nullopt);
  EXPECT_EQ(nearest_multiple(MpInterval(Interval::entire(), 30), 0), std::nullopt);
  const MpInterval large(Rational::power_of_two(62), 3);
  EXPECT_EQ(nearest_multiple(large, 0), std::int64_t{1} << 62);
  EXPECT_EQ(nearest_multiple(large, -1), std::nullopt);
}

}  // namespace
}  // namespace veritope
