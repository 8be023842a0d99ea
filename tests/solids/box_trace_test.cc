// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/interval_boxes/box_trace.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "models/patch_shapes.h"
#include "models/plane_shapes.h"
#include "robust/base/random.h"
#include "solids/interval_boxes/conditions.h"

namespace veritope {
namespace {

BoundaryModel model_of(patch_shapes::Patches patches) {
  return BoundaryModel::make(make_patch_complex(std::move(patches)).value()).value();
}
BoxTrace trace_in(BoundaryModel& model, const Box3d& box) {
  return trace(model, model.to_forest(box).value());
}

// PROVES BOX-2, BOX-2.LEAF, BOX-2.CUT, BOX-2.CONNECTED
TEST(BoxTrace, KnowsDisksRingsPairsOfDisksAndWholeSpheres) {
  BoundaryModel sphere = model_of(patch_shapes::octant_sphere());
  EXPECT_TRUE(trace_in(sphere, {{0.5, 0.3, 0.1}, {1.5, 1.2, 0.9}}).is_disk());
  EXPECT_TRUE(trace_in(sphere, {{-1.5, -1.5, -1.5}, {0.75, 1.5, 1.5}}).is_disk())
      << "more than half of it";
  const BoxTrace ring = trace_in(sphere, {{-2, -2, -0.4}, {2, 2, 0.3}});
  EXPECT_EQ(ring.kind, BoxTrace::Kind::kSurface);
  EXPECT_EQ(ring.euler, 0);
  EXPECT_TRUE(ring.is_no_disk());
  const BoxTrace two = trace_in(sphere, {{-0.3, -0.2, -1.5}, {0.1, 0.2, 1.5}});
  EXPECT_EQ(two.euler, 2);
  EXPECT_FALSE(two.is_connected);
  const BoxTrace all = trace_in(sphere, {{-1.5, -1.5, -1.5}, {1.5, 1.5, 1.5}});
  EXPECT_EQ(all.euler, 2);
  EXPECT_TRUE(all.is_connected);
  EXPECT_TRUE(trace_in(sphere, {{-0.5, -0.5, -0.5}, {0.5, 0.5, 0.5}}).is_missed());
  EXPECT_TRUE(trace_in(sphere, {{0.6, 0.6, 0.6}, {2, 2, 2}}).is_missed());
}

TEST(BoxTrace, ATorusAcrossItsHoleAndACubesCorners) {
  BoundaryModel torus = model_of(patch_shapes::torus(Rational(3), Rational(1)));
  EXPECT_EQ(trace_in(torus, {{1.5, -0.6, -2}, {5, 0.5, 2}}).euler, 0) << "a tube";
  BoundaryModel cube = model_of(patch_shapes::box({0, 0, 0}, {1, 1, 1}));
  EXPECT_TRUE(trace_in(cube, {{-0.5, -0.5, -0.5}, {0.5, 0.25, 0.125}}).is_disk()) << "a corner";
  EXPECT_TRUE(trace_in(cube, {{-0.5, -0.5, 0.25}, {0.5, 0.25, 0.5}}).is_disk()) << "an edge";
}

// Near its top a torus has normals that point up, but the box meets it in two caps, and they leave the box through its floor. The line of the
// monotone-box lemma, in the middle, misses both. Reversed, the torus has its caps at the other end.
// PROVES BOX-1, BOX-1.ENDS
TEST(BoxTrace, CapsThatLeaveThroughAnEndAreTwo) {
  auto patches = patch_shapes::torus(Rational(3), Rational(1));
  for (const bool is_reversed : {false, true}) {
    if (is_reversed)
      for (Patch& p : patches) p = reversed(p);
    BoundaryModel torus = model_of(patches);
    const BoxTrace caps = trace_in(torus, {{-3.3, -0.3, 0.9}, {3.3, 0.3, 1.5}});
    EXPECT_EQ(caps.kind, BoxTrace::Kind::kSurface);
    EXPECT_EQ(caps.euler, 2);
    EXPECT_FALSE(caps.is_connected);
  }
}

// The line crosses the ball's bottom as well as its top, once up and once down: without one sign of the normals that looks like nothing.
// PROVES BOX-1.SIGNS
TEST(BoxTrace, SheetsThatFaceEachOtherAreNotMissed) {
  BoundaryModel sphere = model_of(patch_shapes::octant_sphere());
  const BoxTrace two = trace_in(sphere, {{-0.3, -0.2, -1.5}, {0.1, 0.2, 1.5}});
  EXPECT_EQ(two.kind, BoxTrace::Kind::kSurface);
  EXPECT_EQ(two.euler, 2);
}

// Two boxes that overlap: their tops, one above the other, face the same way.
// PROVES BOX-1.ONCE
TEST(BoxTrace, TwoSheetsOneAboveTheOtherAreTwoDisks) {
  BoundaryModel model = model_of(
      patch_shapes::joined({patch_shapes::box({0, 0, 0}, {1, 1, 1}),
                            patch_shapes::box({-1, -1, -1}, {2, 2, Rational(5) / Rational(4)})}));
  const BoxTrace two = trace_in(model, {{0.25, 0.25, 0.5}, {0.75, 0.75, 1.5}});
  EXPECT_EQ(two.kind, BoxTrace::Kind::kSurface);
  EXPECT_EQ(two.euler, 2);
}

// Tangent to the box, or in one of its sides: never a wrong answer.
// PROVES BOX-2.LEAF
TEST(BoxTrace, TangenciesAreUndecided) {
  BoundaryModel sphere = model_of(patch_shapes::octant_sphere());
  EXPECT_EQ(trace_in(sphere, {{1, -0.5, -0.5}, {2, 0.5, 0.5}}).kind, BoxTrace::Kind::kUndecided);
  BoundaryModel cube = model_of(patch_shapes::box({0, 0, 0}, {1, 1, 1}));
  EXPECT_EQ(trace_in(cube, {{0.25, 0.25, 1}, {0.5, 0.5, 2}}).kind, BoxTrace::Kind::kUndecided);
}

// For a box that the sphere cuts near one corner or far from all, the answer is known from distances: a disk around the
// corner nearest to the middle if that corner alone is inside.
TEST(BoxTrace, BoxesWithOneCornerInsideOfTheSphereAreDisks) {
  BoundaryModel sphere = model_of(patch_shapes::octant_sphere());
  int decided = 0, asked = 0;
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    Random random(seed);
    Box3d b;
    for (std::size_t k = 0; k < 3; ++k) {
      b.lo[k] = 0.05 + 0.9 * random.unit();
      b.hi[k] = b.lo[k] + 0.1 + random.unit();
    }
    const auto square = [](double x) { return x * x; };
    const double near = square(b.lo[0]) + square(b.lo[1]) + square(b.lo[2]);
    double next = 100;
    for (std::size_t k = 0; k < 3; ++k)
      next = std::min(next, near + square(b.hi[k]) - square(b.lo[k]));
    if (near < 0.98 && next > 1.02) {
      ++asked;
      const BoxTrace t = trace_in(sphere, b);
      decided += t.is_disk();
      ASSERT_FALSE(t.is_no_disk()) << "seed " << seed;
    } else if (near > 1.02) {
      ASSERT_TRUE(trace_in(sphere, b).is_missed()) << "seed " << seed;
    }
  }
  EXPECT_GE(asked, 30);
  EXPECT_EQ(decided, asked);
}

TEST(BoundaryModel, RefusesWhatIsNoClosedSurface) {
  auto patches = patch_shapes::box({0, 0, 0}, {1, 1, 1});
  patches.pop_back();
  const auto open = BoundaryModel::make(make_patch_complex(std::move(patches)).value());
  ASSERT_FALSE(open.has_value());
  EXPECT_NE(open.error().message.find("open-side"), std::string::npos) << open.error().message;
  auto loop = plane_shapes::circle();
  loop.pop_back();
  EXPECT_FALSE(BoundaryModel::make_planar({loop}).has_value());
  EXPECT_EQ(BoundaryModel::make_planar({}).error().code, Code::kEmpty);
}

TEST(WindingNumber, OfPointsInAndOutOfASphereInASphere) {
  BoundaryModel shell = model_of(patch_shapes::thin_shell(Rational(1) / 2));
  const auto at = [&](double x) {
    const Box3d p = shell.to_forest({{x, 0.01, 0.02}, {x, 0.01, 0.02}}).value();
    return winding_number(shell.forest(), p.lo);
  };
  EXPECT_EQ(at(0), 0);
  EXPECT_EQ(at(0.75), 1);
  EXPECT_EQ(at(-0.75), 1);
  EXPECT_EQ(at(1.5), 0);
  EXPECT_EQ(at(-1.5), 0);
}

TEST(Conditions, AreRefutedWithTheirBoxes) {
  BoundaryModel cube = model_of(patch_shapes::box({0, 0, 0}, {1, 1, 1}));
  // Two halves that abut at x = 1/2: B1, but the interiors leave a curve out; and a box far away.
  const std::vector<Box3d> boxes{
      {{-1, -1, -1}, {0.5, 2, 2}}, {{0.5, -1, -1}, {2, 2, 2}}, {{5, 5, 5}, {6, 6, 6}}};
  const auto all = decide_conditions(cube, boxes).value();
  EXPECT_EQ(all[PaperCondition::kA].answer, Answer::kFalse);
  EXPECT_EQ(all[PaperCondition::kA].offences[0].boxes, (std::vector<std::uint32_t>{0, 1}));
  EXPECT_EQ(all[PaperCondition::kB1].answer, Answer::kTrue);
  EXPECT_EQ(all[PaperCondition::kC1].answer, Answer::kFalse);
  EXPECT_EQ(all[PaperCondition::kB2].answer, Answer::kFalse);
  EXPECT_EQ(all[PaperCondition::kB2].offences[0].boxes, (std::vector<std::uint32_t>{2}));
  EXPECT_EQ(all[PaperCondition::kC2].num_false, 1u);
  EXPECT_EQ(all[PaperCondition::kC3].offences[0].why, BoxOffence::Why::kTouching);
  const auto half = decide_conditions(cube, std::vector<Box3d>{boxes[0]}).value();
  EXPECT_EQ(half[PaperCondition::kB1].answer, Answer::kFalse) << "half of the cube is uncovered";
}

TEST(Conditions, BadBoxesAreRefusedAndTheCapIsSaid) {
  BoundaryModel cube = model_of(patch_shapes::box({0, 0, 0}, {1, 1, 1}));
  EXPECT_EQ(decide_conditions(cube, {}).error().code, Code::kEmpty);
  const std::vector<Box3d> flat{{{0, 0, 0}, {1, 0, 1}}}, infinite{{{0, 0, 0}, {1, 1, 1.0 / 0.0}}};
  EXPECT_EQ(decide_conditions(cube, flat).error().code, Code::kBadArgument);
  EXPECT_EQ(decide_conditions(cube, infinite).error().code, Code::kBadArgument);
  std::vector<Box3d> many;
  for (int i = 1; i < 9; ++i)
    many.push_back({{0.5, -0.01 * i, 0.25}, {1.5, 1 + 0.02 * i, 0.5 + 0.03 * i}});
  ConditionOptions options;
  options.max_intersections = 4;
  const auto all = decide_conditions(cube, many, options).value();
  EXPECT_EQ(all[PaperCondition::kC3Star].answer, Answer::kUndecided);
  EXPECT_EQ(all[PaperCondition::kC3Star].offences[0].why, BoxOffence::Why::kTooMany);
  // With a box that the cube misses C3* is refuted, whatever the cap.
  many.push_back({{5, 5, 5}, {6, 6, 6}});
  const auto missed = decide_conditions(cube, many, options).value();
  EXPECT_EQ(missed[PaperCondition::kC3Star].answer, Answer::kFalse);
}

// Against all subsets.
TEST(DistinctIntersections, AreThoseOfAllSubsets) {
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    Random random(seed);
    std::vector<Box3d> boxes(static_cast<std::size_t>(random.between(1, 8)));
    for (Box3d& b : boxes)
      for (std::size_t k = 0; k < 3; ++k) {
        b.lo[k] = static_cast<double>(random.between(0, 3));
        b.hi[k] = b.lo[k] + static_cast<double>(random.between(1, 3));
      }
    std::set<std::array<double, 6>> expected, got;
    const auto key = [](const Box3d& b) {
      return std::array{b.lo[0], b.lo[1], b.lo[2], b.hi[0], b.hi[1], b.hi[2]};
    };
    for (unsigned set = 1; set < 1u << boxes.size(); ++set) {
      Box3d b{{-9, -9, -9}, {9, 9, 9}};
      bool is_empty = false;
      for (std::size_t i = 0; i < boxes.size(); ++i)
        for (std::size_t k = 0; k < 3 && (set >> i & 1) != 0; ++k) {
          b.lo[k] = std::max(b.lo[k], boxes[i].lo[k]), b.hi[k] = std::min(b.hi[k], boxes[i].hi[k]);
          is_empty = is_empty || b.lo[k] > b.hi[k];
        }
      if (!is_empty) expected.insert(key(b));
    }
    for (const auto& item : distinct_intersections(boxes, 1000).items) got.insert(key(item.box));
    ASSERT_EQ(got, expected) << "seed " << seed;
  }
}

}  // namespace
}  // namespace veritope
