// SPDX-License-Identifier: LGPL-3.0-or-later
#include "splines/bezier_lowering.h"

#include <gtest/gtest.h>

#include "splines/bezier_degree.h"
#include "tests/splines/draw.h"

namespace veritope {
namespace {

TEST(BezierLowering, UndoesElevation) {
  for_all_dimensions(70, 40, [](Random& random, auto n) {
    const auto map = draw_bezier<n>(random, 4, 3, random.below(2) == 0);
    SCOPED_TRACE(text_of(map));
    const std::size_t axis = random.below(n);
    const auto raised = elevate(map, axis, 1);
    const auto back = lower(raised, axis);
    ASSERT_TRUE(back.has_value());
    EXPECT_EQ(*back, map);
  });
}

TEST(BezierLowering, FindsTheSameDegreesHoweverFarTheMapIsElevated) {
  for_all_dimensions(80, 30, [](Random& random, auto n) {
    auto map = draw_bezier<n>(random, 3, 2);
    for (std::size_t a = 0; a < n; ++a)
      if (map.degree(a) == 0) map = elevate(map, a, 1);
    SCOPED_TRACE(text_of(map));
    auto raised = map;
    for (std::size_t a = n; a-- > 0;) raised = elevate(raised, a, draw_int(random, 0, 3));
    EXPECT_EQ(lowered(raised), lowered(map));
    const auto least = lowered(map);
    EXPECT_EQ(elevate_to(least, map.degrees()), map);
    for (std::size_t a = 0; a < n; ++a)
      EXPECT_TRUE(least.degree(a) == 1 || !lower(least, a).has_value());
  });
}

TEST(BezierLowering, LeavesAMapThatNeedsItsDegree) {
  const BezierCurve<Rational> parabola({2}, 1, false, {Rational(0), Rational(0), Rational(1)});
  EXPECT_FALSE(lower(parabola, 0).has_value());
  EXPECT_EQ(lowered(parabola), parabola);
  const BezierCurve<Rational> line({2}, 1, false, {Rational(0), Rational(1), Rational(2)});
  EXPECT_EQ(lowered(line), BezierCurve<Rational>({1}, 1, false, {Rational(0), Rational(2)}));
}

TEST(BezierLowering, KeepsTheDegreeOneOfAConstant) {
  const BezierCurve<Rational> constant({3}, 1, false, std::vector<Rational>(4, Rational(5)));
  EXPECT_EQ(lowered(constant).degree(0), 1);
}

}  // namespace
}  // namespace veritope
