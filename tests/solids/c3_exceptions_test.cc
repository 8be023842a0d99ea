// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/interval_boxes/c3_exceptions.h"

#include <gtest/gtest.h>

#include <cmath>

#include "models/patch_shapes.h"
#include "models/plane_shapes.h"

namespace veritope {
namespace {

Box3d rectangle(double x0, double x1, double y0, double y1) { return {{x0, y0, 0}, {x1, y1, 0}}; }

struct Case {
  BoundaryModel model;
  std::vector<Box3d> boxes;
  PaperConditions conditions() { return decide_conditions(model, boxes).value(); }
  std::vector<C3Failure> failures() {
    return explain_c3(model, boxes, conditions()[PaperCondition::kC3]);
  }
};
Case circle_with(std::vector<Box3d> boxes) {
  return {BoundaryModel::make_planar({plane_shapes::circle()}).value(), std::move(boxes)};
}

// Figure 6: two boxes overlap below the circle's top, and the box between them mends it; without it nothing does.
TEST(C3Exceptions, ABoxBetweenMendsASmallFeature) {
  const Box3d left = rectangle(-0.8, 0.02, 0.5, 0.97), right = rectangle(-0.02, 0.8, 0.5, 0.97);
  Case with = circle_with({left, right, rectangle(-0.4, 0.4, 0.45, 1.2)});
  auto failures = with.failures();
  ASSERT_EQ(failures.size(), 1u);
  EXPECT_EQ(failures[0].exception, C3Exception::kSmallFeature);
  EXPECT_EQ(failures[0].sub_collection, std::vector<std::uint32_t>{2});
  Case without = circle_with({left, right});
  failures = without.failures();
  ASSERT_EQ(failures.size(), 1u);
  EXPECT_TRUE(failures[0].sub_collection.empty());
}

// Two boxes, together a ball, where no single box does: V misses what the first has in common with box 1, and the second does not meet b_01.
TEST(C3Exceptions, TwoBoxesMendWhereOneDoesNot) {
  Case c = circle_with({rectangle(-0.8, 0.02, 0.5, 0.97), rectangle(-0.02, 0.8, 0.5, 0.97),
                        rectangle(-0.5, 0.1, 0.6, 1.2), rectangle(0.05, 0.5, 0.6, 1.2)});
  for (const C3Failure& f : c.failures()) {
    if (f.i != 0 || f.j != 1) continue;
    EXPECT_EQ(f.sub_collection, (std::vector<std::uint32_t>{2, 3}));
    return;
  }
  FAIL() << "C3 fails at boxes 0 and 1";
}

// Figure 5(a): the large box reaches over the small one to the next.
TEST(C3Exceptions, ALargeBoxNextToASmallOneIsVaryingSize) {
  Case c = circle_with({rectangle(-0.9, 0.06, 0.3, 0.97), rectangle(0.04, 0.3, 0.9, 0.99)});
  const auto failures = c.failures();
  ASSERT_EQ(failures.size(), 1u);
  EXPECT_EQ(failures[0].exception, C3Exception::kVaryingSize);
}

// The walls of a notch, bridged.
TEST(C3Exceptions, TwoPartsOfTheCurveAreSelfDistance) {
  const auto notch =
      plane_shapes::polygon({{-4, -6}, {8, -6}, {8, -2}, {0, 0}, {8, 2}, {8, 6}, {-4, 6}});
  Case c{BoundaryModel::make_planar({notch}).value(),
         {rectangle(2, 3.25, -0.0625, 1), rectangle(2, 3.25, -1, 0.0625)}};
  const auto failures = c.failures();
  ASSERT_EQ(failures.size(), 1u);
  EXPECT_EQ(failures[0].exception, C3Exception::kSelfDistance);
  EXPECT_TRUE(failures[0].sub_collection.empty());
}

// Exception 4: a dyadic step, C2 and all other relations kept.
TEST(C3Exceptions, AContactIsEliminatedByADyadicStep) {
  const auto square = plane_shapes::polygon({{-2, -2}, {2, -2}, {2, 2}, {-2, 2}});
  Case c{BoundaryModel::make_planar({square}).value(),
         {rectangle(-1.5, 0, 1.5, 2.5), rectangle(0, 1.5, 1.5, 2.5)}};
  EXPECT_EQ(c.conditions()[PaperCondition::kA].answer, Answer::kFalse);
  const auto failures = c.failures();
  ASSERT_EQ(failures.size(), 1u);
  EXPECT_EQ(failures[0].exception, C3Exception::kContact);
  ASSERT_TRUE(failures[0].resized.has_value());
  int exponent = 0;
  EXPECT_EQ(std::abs(std::frexp(failures[0].resized->step, &exponent)), 0.5) << "a power of two";
  c.boxes[failures[0].i] = failures[0].resized->box;
  const auto after = c.conditions();
  EXPECT_EQ(after[PaperCondition::kA].answer, Answer::kTrue);
  EXPECT_EQ(after[PaperCondition::kC2].answer, Answer::kTrue);
  EXPECT_EQ(after[PaperCondition::kC3].answer, Answer::kTrue);
}

// Box 1 touches box 0 off the curve: only a smaller box 0 mends that, and the first step would make box 2 touch it.
TEST(C3Exceptions, AStepThatMakesAnotherContactIsNotTaken) {
  const auto square = plane_shapes::polygon({{-2, -2}, {2, -2}, {2, 2}, {-2, 2}});
  Case c{BoundaryModel::make_planar({square}).value(),
         {rectangle(-1.5, 0, 1.5, 2.5), rectangle(0, 1.5, 2.125, 2.5),
          rectangle(-0.25, 1, 2.25, 2.625), rectangle(-0.75, 2.5, 1.75, 2.0625),
          rectangle(-2.5, -1.25, -2.5, 2.5), rectangle(-2.5, 2.5, -2.5, -1.5),
          rectangle(1.5, 2.5, -2.5, 2.0625)}};
  ASSERT_EQ(c.conditions()[PaperCondition::kC1].answer, Answer::kTrue);
  for (const C3Failure& f : c.failures()) {
    if (f.exception != C3Exception::kContact || f.i != 0) continue;
    ASSERT_TRUE(f.resized.has_value());
    EXPECT_EQ(f.resized->step, -0.125);
    return;
  }
  FAIL() << "boxes 0 and 1 touch";
}

TEST(SelfDistance, OfACubeIsItsSideAndBoundsTheBoxes) {
  BoundaryModel model =
      BoundaryModel::make(make_patch_complex(patch_shapes::box({0, 0, 0}, {1, 1, 1})).value())
          .value();
  const auto d = self_distance(model);
  ASSERT_TRUE(d.has_value());
  EXPECT_TRUE(d->is_as_asked);
  EXPECT_LE(d->lo, 1);
  EXPECT_GE(d->hi, 1);
  EXPECT_LE(d->box_bound(), 1 / std::sqrt(3.0));
  EXPECT_GE(d->box_bound(), 0.97 / std::sqrt(3.0));
}

TEST(SelfDistance, OfAThinShellIsItsWall) {
  BoundaryModel model =
      BoundaryModel::make(make_patch_complex(patch_shapes::thin_shell(Rational(1) / 8)).value())
          .value();
  const auto d = self_distance(model, 30'000).value();
  EXPECT_FALSE(d.is_as_asked) << "the same distance everywhere: the budget ends the search";
  EXPECT_GT(d.lo, 0);
  EXPECT_LE(d.lo, 0.125);
  EXPECT_GE(d.hi, 0.125);
}

TEST(BallWithC2, TwoBoxesOverADiskAndNotTheCounterexample) {
  BoundaryModel model =
      BoundaryModel::make(make_patch_complex(patch_shapes::octant_sphere()).value()).value();
  std::vector<Box3d> pair;
  for (const Box3d& b :
       {Box3d{{0.5, -0.4, -0.3}, {1.3, 0.1, 0.3}}, Box3d{{0.5, -0.1, -0.3}, {1.3, 0.4, 0.3}}})
    pair.push_back(model.to_forest(b).value());
  EXPECT_TRUE(is_ball_with_c2(model, pair));
  pair[1].lo[0] = -2;
  EXPECT_FALSE(is_ball_with_c2(model, pair));
}

}  // namespace
}  // namespace veritope
