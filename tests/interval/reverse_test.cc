// SPDX-License-Identifier: LGPL-3.0-or-later
// Laws of reverse operations: no point of `in` that f maps into c is lost, and nothing outside of `in`
// is invented. ITF1788 checks the bounds of many cases.
#include "interval/reverse.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "interval/functions.h"
#include "interval/text.h"
#include "robust/base/check.h"
#include "tests/interval/draw.h"
#include "tests/predicates/test_scale.h"

namespace veritope {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

Interval ordinary(Random& random, double scale) {
  const double a = scale * (2 * random.unit() - 1), b = scale * (2 * random.unit() - 1);
  return random.below(5) == 0 ? Interval(a) : Interval::from_bounds(std::min(a, b), std::max(a, b));
}

TEST(Reverse, LosesNoPointThatIsMappedIntoTheSet) {
  using Forward = Interval (*)(const Interval&);
  using Backward = Interval (*)(const Interval&, const Interval&);
  const struct {
    const char* name;
    Forward forward;
    Backward backward;
  } functions[] = {
      {"sqr", [](const Interval& x) { return pown(x, 2); }, sqr_rev},
      {"abs", abs, abs_rev},
      {"cosh", cosh, cosh_rev},
      {"sin", sin, sin_rev},
      {"cos", cos, cos_rev},
      {"tan", tan, tan_rev},
      {"cube", [](const Interval& x) { return pown(x, 3); },
       [](const Interval& c, const Interval& in) { return pown_rev(c, 3, in); }},
      {"1/x^2", [](const Interval& x) { return pown(x, -2); },
       [](const Interval& c, const Interval& in) { return pown_rev(c, -2, in); }},
      {"1/x^3", [](const Interval& x) { return pown(x, -3); },
       [](const Interval& c, const Interval& in) { return pown_rev(c, -3, in); }},
  };
  Random random(101);
  for (long i = 0; i < scaled(4000); ++i) {
    const Interval in = i % 4 == 0 ? draw_interval(random) : ordinary(random, i % 3 == 0 ? 300 : 4);
    for (const auto& f : functions) {
      // Whatever of `in` the values of a point t of `in` come from: t comes back.
      const double t = i % 2 == 0 ? mid(in) : (internal::is_infinite(in.lo()) ? mid(in) : in.lo());
      const Interval values = f.forward(Interval(t));
      if (values.is_empty()) continue;
      const Interval back = f.backward(values, in);
      ASSERT_TRUE(is_member(t, back))
          << i << f.name << exact_text(in) << exact_text(values) << exact_text(back);
      ASSERT_TRUE(is_subset(back, in));
      // Without a restriction the answer is no narrower.
      ASSERT_TRUE(is_subset(back, f.backward(values, Interval::entire()))) << f.name;
      // c wider, answer wider.
      const Interval wider = hull(values, ordinary(random, 2));
      ASSERT_TRUE(is_subset(back, f.backward(wider, in))) << f.name;
      // The part of `in` before the answer has no value in c, apart from what rounding hides.
      if (!is_common(in) || !internal::less(in.lo(), back.lo())) continue;
      const Interval before = Interval(in.lo());
      ASSERT_FALSE(is_subset(f.forward(before), values) && !f.forward(before).is_empty())
          << i << f.name << exact_text(in);
    }
  }
}

TEST(Reverse, PowersComeBack) {
  Random random(102);
  for (long i = 0; i < scaled(4000); ++i) {
    const double x = i % 9 == 0 ? 0 : 4 * random.unit(), y = 8 * random.unit() - 4;
    const Interval z = pow(Interval(x), Interval(y));
    if (z.is_empty()) continue;
    const Interval ys = hull(Interval(y), ordinary(random, 3)),
                   xs = hull(Interval(x), abs(ordinary(random, 3)));
    ASSERT_TRUE(is_member(x, pow_rev1(ys, z))) << x << ' ' << y;
    ASSERT_TRUE(is_member(x, pow_rev1(ys, z, xs))) << x << ' ' << y;
    ASSERT_TRUE(is_member(y, pow_rev2(xs, z))) << x << ' ' << y;
    ASSERT_TRUE(is_subset(pow_rev2(xs, z, ys), ys)) << x << ' ' << y;
    // For sets of one point the answer is as narrow as the rounding of z allows.
    if (x > 0.1 && std::abs(y) > 0.1) {
      ASSERT_LT(wid(pow_rev1(Interval(y), z)), x * 0x1p-45) << x << ' ' << y;
    }
  }
  EXPECT_EQ(pow_rev1(Interval(2.0), Interval(9.0)), Interval(3.0));
  EXPECT_EQ(pow_rev1(Interval(-0.5), Interval(4.0)), Interval(0.0625));
  EXPECT_EQ(pow_rev2(Interval(3.0), Interval(81.0)), Interval(4.0));
  EXPECT_EQ(pow_rev2(Interval(0.0), Interval(0.0)), Interval::from_bounds(0, kInfinity));
  EXPECT_TRUE(pow_rev2(Interval(0.0), Interval(0.0), Interval(0.0)).is_empty());
}

TEST(Reverse, ProductsComeBackInAtMostTwoPieces) {
  Random random(103);
  for (long i = 0; i < scaled(20000); ++i) {
    const Interval b = ordinary(random, 2), x = ordinary(random, 2);
    Interval c;
    {
      const ScopedUpward upward;
      c = b * x;
    }
    const auto [first, second] = mul_rev_to_pair(b, c);
    const double t = mid(x);
    ASSERT_TRUE(is_member(t, first) || is_member(t, second)) << to_string(b) << to_string(x);
    ASSERT_TRUE(second.is_empty() || strictly_precedes(first, second))
        << to_string(b) << to_string(c);
    ASSERT_TRUE(is_member(t, mul_rev(b, c, x)));
  }
  const auto [left, right] = mul_rev_to_pair(Interval::from_bounds(-1, 2), Interval(4.0));
  EXPECT_EQ(left, Interval::from_bounds(-kInfinity, -4));
  EXPECT_EQ(right, Interval::from_bounds(2, kInfinity));
}

TEST(Reverse, SetsWithoutAnOriginalGiveNothing) {
  EXPECT_TRUE(sqr_rev(Interval(-1.0)).is_empty());
  EXPECT_TRUE(abs_rev(Interval(-1.0)).is_empty());
  EXPECT_TRUE(cosh_rev(Interval(0.5)).is_empty());
  EXPECT_TRUE(sin_rev(Interval(2.0)).is_empty());
  EXPECT_TRUE(cos_rev(Interval(1.0), Interval::from_bounds(0.5, 6)).is_empty());
  EXPECT_TRUE(tan_rev(Interval(0.0), Interval::from_bounds(0.5, 3)).is_empty());
  EXPECT_TRUE(pown_rev(Interval(2.0), 0).is_empty());
  EXPECT_THROW(pown_rev(Interval(2.0), std::int64_t{1} << 31), InternalError);
}

}  // namespace
}  // namespace veritope
