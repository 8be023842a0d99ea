// SPDX-License-Identifier: LGPL-3.0-or-later
#include "interval/nearest_interval.h"

#include <gtest/gtest.h>

#include <limits>

#include "interval/numeric.h"
#include "tests/interval/draw.h"
#include "tests/predicates/test_scale.h"

namespace veritope {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

TEST(NearestInterval, ContainsTheTightestResultOfEveryOperation) {
  Random random(41);
  for (long i = 0; i < scaled(60000); ++i) {
    const Interval a = draw_interval(random), b = draw_interval(random);
    Interval tight[6];
    {
      const ScopedUpward upward;
      tight[0] = a + b, tight[1] = a - b, tight[2] = a * b, tight[3] = a / b, tight[4] = sqr(a),
      tight[5] = sqrt(a);
    }
    const NearestInterval x(a), y(b);
    const NearestInterval wide[6] = {x + y, x - y, x * y, x / y, sqr(x), sqrt(x)};
    for (int k = 0; k < 6; ++k)
      ASSERT_TRUE(is_subset(tight[k], wide[k].interval()) &&
                  tight[k].is_empty() == wide[k].is_empty())
          << i << ' ' << k << ' ' << to_string(a) << ' ' << to_string(b) << " tight "
          << to_string(tight[k]) << " nearest " << to_string(wide[k].interval());
  }
}

TEST(NearestInterval, IsWiderByAtMostTwoUnitsInTheLastPlace) {
  Random random(42);
  for (long i = 0; i < scaled(20000); ++i) {
    const double p = 1 + random.unit(), q = 1 + random.unit();
    const NearestInterval sum = NearestInterval(p) + NearestInterval(q),
                          product = NearestInterval(p) * NearestInterval(q);
    ASSERT_LE(wid(sum.interval()), 4 * 0x1p-51) << p << ' ' << q;
    ASSERT_LE(wid(product.interval()), 4 * 0x1p-51) << p << ' ' << q;
  }
}

TEST(NearestInterval, AfterOverflowTheLargestNumberIsTheInnerBound) {
  const NearestInterval huge(0x1p1023), product = huge * huge, difference = -product;
  EXPECT_EQ(product.hi(), kInfinity);
  EXPECT_GT(product.lo(), 0x1p1023);
  EXPECT_LT(product.lo(), kInfinity);
  EXPECT_EQ(difference.lo(), -kInfinity);
  EXPECT_EQ((huge * NearestInterval(Interval::entire())).interval(), Interval::entire());
}

TEST(NearestInterval, KnowsSignsAndRootsAndEmptiness) {
  EXPECT_EQ((NearestInterval(3.0) * NearestInterval(-2.0)).sign(), Sign3::kNegative);
  EXPECT_EQ(sign_of(NearestInterval(0.0) * NearestInterval(1.0)), Sign3::kUncertain);
  EXPECT_EQ(NearestInterval(0.0).sign(), Sign3::kZero);
  EXPECT_GE(sqr(NearestInterval(0.0)).lo(), 0);
  EXPECT_TRUE(sqrt(NearestInterval(-1.0)).is_empty());
  EXPECT_TRUE((NearestInterval(1.0) / NearestInterval(0.0)).is_empty());
  EXPECT_TRUE((NearestInterval(Interval::empty()) + NearestInterval(1.0)).is_empty());
}

}  // namespace
}  // namespace veritope
