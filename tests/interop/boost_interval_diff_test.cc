// SPDX-License-Identifier: LGPL-3.0-or-later
#include "interop/boost_interval.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <stdexcept>

#include "robust/base/random.h"
#include "robust/binary64.h"

namespace veritope {
namespace {

using BoostInterval = boost::numeric::interval<double>;

double number(Random& random) {
  for (;;) {
    double v = std::bit_cast<double>(random.next());
    if (random.below(2) == 0) v = static_cast<double>(random.between(-4, 4));
    if (random.below(4) == 0) v = 2 * random.unit() - 1;
    if (is_finite(v)) return v;
  }
}
Interval interval(Random& random) {
  const double a = number(random), b = random.below(3) == 0 ? a : number(random);
  return Interval::from_bounds(std::fmin(a, b), std::fmax(a, b));
}
void expect_same(const Interval& ours, const Interval& theirs, const Interval& a,
                 const Interval& b) {
  EXPECT_TRUE(ours.lo() == theirs.lo() && ours.hi() == theirs.hi())
      << to_string(a) << ' ' << to_string(b) << " ours " << to_string(ours) << " Boost's "
      << to_string(theirs);
}

TEST(BoostInterval, HasTheBoundsOfOursForSumsDifferencesAndProducts) {
  Random random(71);
  for (int i = 0; i < 50000; ++i) {
    const Interval a = interval(random), b = interval(random);
    Interval sum, less, product, upward_sum, upward_product;
    {
      const ScopedUpward upward;
      sum = a + b, less = a - b, product = a * b;
      const auto x = to_boost<UpwardBoostInterval>(a), y = to_boost<UpwardBoostInterval>(b);
      upward_sum = from_boost(x + y), upward_product = from_boost(x * y);
    }
    const BoostInterval x = to_boost(a), y = to_boost(b);
    expect_same(sum, from_boost(x + y), a, b);
    expect_same(less, from_boost(x - y), a, b);
    expect_same(product, from_boost(x * y), a, b);
    expect_same(sum, upward_sum, a, b);
    expect_same(product, upward_product, a, b);
    expect_same(a, from_boost(x), a, a);
    if (HasFailure()) FAIL() << i;
  }
}

TEST(BoostInterval, EmptyStaysEmptyWhereThePoliciesHaveIt) {
  EXPECT_TRUE(from_boost(UpwardBoostInterval::empty()).is_empty());
  EXPECT_TRUE(boost::numeric::empty(to_boost<UpwardBoostInterval>(Interval::empty())));
  EXPECT_THROW(to_boost(Interval::empty()), std::exception);
}

}  // namespace
}  // namespace veritope
