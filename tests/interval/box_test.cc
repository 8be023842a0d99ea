// SPDX-License-Identifier: LGPL-3.0-or-later
#include "interval/box.h"

#include <gtest/gtest.h>

#include <limits>

#include "tests/interval/draw.h"
#include "tests/predicates/test_scale.h"

namespace veritope {
namespace {

Interval span_of(double lo, double hi) { return Interval::from_bounds(lo, hi); }

TEST(Box, HullContainsBothAndIntersectionIsInBoth) {
  Random random(61);
  for (long i = 0; i < scaled(5000); ++i) {
    Box3 a, b;
    for (std::size_t k = 0; k < 3; ++k) a[k] = draw_interval(random), b[k] = draw_interval(random);
    const Box3 both = intersection(a, b), around = hull(a, b);
    ASSERT_TRUE(is_subset(a, around) && is_subset(b, around)) << i;
    ASSERT_TRUE(is_subset(both, a) && is_subset(both, b)) << i;
    ASSERT_EQ(both.is_empty(), is_disjoint(a, b)) << i;
    ASSERT_TRUE(contains(a, mid(a))) << i;
    ASSERT_EQ(hull(a, Box3::empty()), a);
    const auto [left, right] = split(a, static_cast<std::size_t>(i) % 3);
    ASSERT_EQ(hull(left, right), a) << i;
    ASSERT_EQ(left[(static_cast<std::size_t>(i) + 1) % 3],
              a[(static_cast<std::size_t>(i) + 1) % 3]);
  }
}

TEST(Box, ArithmeticIsThatOfVectors) {
  const Box2 a(span_of(0, 1), 2.0), b(1.0, span_of(-1, 3));
  const ScopedUpward upward;
  EXPECT_EQ(a + b, Box2(span_of(1, 2), span_of(1, 5)));
  EXPECT_EQ(a - b, Box2(span_of(-1, 0), span_of(-1, 3)));
  EXPECT_EQ(Interval(-2.0) * a, Box2(span_of(-2, 0), -4.0));
}

TEST(Box, KnowsWidthsAndInteriorsAndEmptiness) {
  const Box2 a(span_of(0, 4), span_of(1, 2)), inner(span_of(1, 2), span_of(1.25, 1.5));
  EXPECT_EQ(widest_side(a), 0u);
  EXPECT_EQ(width(a), 4);
  EXPECT_TRUE(is_interior(inner, a));
  EXPECT_FALSE(is_interior(a, a));
  EXPECT_TRUE(is_interior(Box2::entire(), Box2::entire()));
  EXPECT_FALSE(contains(a, {5, 1.5}));
  Box2 none = a;
  none[1] = Interval::empty();
  EXPECT_TRUE(none.is_empty());
  EXPECT_EQ(none, Box2::empty());
  EXPECT_TRUE(is_subset(none, inner) && is_disjoint(none, a) && is_interior(none, inner));
  EXPECT_FALSE(none == a);
  EXPECT_THROW(mid(none), InternalError);
  EXPECT_THROW(split(a, 2), InternalError);
  EXPECT_EQ(Box2::dimension(), 2u);
}

TEST(Box, ASideThatCannotBeCutIsLeftWhole) {
  const double next = 1 + std::numeric_limits<double>::epsilon();
  const Box2 thin(span_of(1, next), span_of(0, 1));
  EXPECT_EQ(split(thin, 0).first, thin);
  EXPECT_EQ(split(thin, 0).second, thin);
  EXPECT_EQ(split(thin, 1).first, Box2(span_of(1, next), span_of(0, 0.5)));
  const Box2 half_line(span_of(0, std::numeric_limits<double>::infinity()), 0.0);
  EXPECT_TRUE(is_common(split(half_line, 0).first[0]));
}

}  // namespace
}  // namespace veritope
