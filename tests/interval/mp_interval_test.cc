// SPDX-License-Identifier: LGPL-3.0-or-later
#include "interval/mp_interval.h"

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace veritope
