// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/micro/cage/split_cage.h"

#include <gtest/gtest.h>

#include "solids/micro/cage/box_cage.h"
#include "solids/micro/cage/radial_cage.h"
#include "splines/bspline_domain.h"
#include "tests/solids/cage_support.h"
#include "tests/support/v_cells.h"

namespace veritope {
namespace {

using namespace cage_test;
using Cells = std::vector<CellVolume>;

CellVolume block(int degree = 1, std::uint64_t spans = 1) {
  return box_cage({at(q(0), q(0), q(0)), at(q(2), q(2), q(2))},
                  {{degree, degree, degree}, {spans, spans, spans}})
      .value();
}

CageSplit crack_of(const Rational& part) {
  CageSplit split{0, 0, part, CageCrack{2, true, part, {}, {}}};
  split.crack->low = at(q(-1, 4), q(0), q(0));
  split.crack->high = at(q(1, 4), q(0), q(1, 8));
  return split;
}

TEST(SplitCage, PartsAreTheSameMapAndAreGlued) {
  const CellVolume whole = block(2, 3);
  const Cells cells = split_cage({whole}, {0, 1, q(4, 3), {}}).value();
  ASSERT_EQ(cells.size(), 2u);
  EXPECT_EQ(cells[0].axis(1).domain_end(), q(4, 3));
  EXPECT_EQ(image(cells[0], {q(1, 3), q(1, 5), q(2)}), image(whole, {q(1, 3), q(1, 5), q(2)}));
  EXPECT_EQ(image(cells[1], {q(1), q(5, 2), q(0)}), image(whole, {q(1), q(5, 2), q(0)}));
  EXPECT_EQ(model_of(cells).counts().internal, 1u);
  EXPECT_EQ(certified(cells).verdict, Verdict::kValid);
}

TEST(SplitCage, ACutGoesOnThroughGluedWalls) {
  // The second cube has its axes permuted and one reversed: still right-handed.
  const CellVolume second = reversed(swapped(v_cells::cube(1, 0, 0), 0, 1), 0);
  const Cells cells =
      split_cage({v_cells::cube(0, 0, 0), second, v_cells::cube(0, 0, 1)}, {0, 1, q(1, 4), {}})
          .value();
  ASSERT_EQ(cells.size(), 6u);
  const VModel model = model_of(cells);
  EXPECT_EQ(model.counts().internal, 3u + 4u);  // three cuts, two walls in two parts each
  EXPECT_EQ(certified(cells).verdict, Verdict::kValid);
  // The cell behind walls that the cut does not cross stays whole.
  EXPECT_EQ(split_cage({v_cells::cube(0, 0, 0), v_cells::cube(0, 1, 0)}, {0, 1, q(1, 4), {}})
                .value()
                .size(),
            3u);
}

TEST(SplitCage, ARingIsCutAcrossItsOwnWall) {
  RadialShape shape;
  shape.inner = q(1);
  shape.outer = q(2);
  shape.high = q(1);
  const Cells ring{radial_cage(shape).value().cell};
  const Cells inner_and_outer = split_cage(ring, {0, 0, q(1, 3), {}}).value();
  EXPECT_EQ(model_of(inner_and_outer).counts().internal, 3u);
  const Cells halves = split_cage(ring, {0, 1, q(5, 2), {}}).value();
  EXPECT_EQ(model_of(halves).counts().internal, 2u);
  for (const Cells& cells : {inner_and_outer, halves}) {
    const Certified answer = certified(cells);
    ASSERT_EQ(answer.verdict, Verdict::kValid);
    EXPECT_EQ(std::get<PatchFacts>(answer.facts).genus, 1u);
  }
}

TEST(SplitCage, ACrackOpensFromALineOnAndIsCertified) {
  for (const auto& [degree, spans] : {std::pair{1, 1}, {2, 2}, {3, 2}}) {
    SCOPED_TRACE(degree);
    const CellVolume whole = block(degree, static_cast<std::uint64_t>(spans));
    const Rational middle = q(spans, 2), end = q(spans), zero = q(0);
    const Cells cells = split_cage({whole}, crack_of(middle)).value();
    ASSERT_EQ(cells.size(), 4u);  // low: bottom, top; high: bottom, top
    const VModel model = model_of(cells);
    EXPECT_EQ(model.counts().internal, 3u);
    EXPECT_TRUE(model.face(0, 1).is_glued());
    EXPECT_TRUE(model.face(1, 1).is_border());
    EXPECT_TRUE(model.face(3, 0).is_border());
    // On the line nothing moves, at the face the whole way, halfway half of it; nor on the other sides.
    for (const Rational& v : {zero, q(spans, 3)}) {
      EXPECT_EQ(image(cells[1], {middle, v, middle}), image(whole, {middle, v, middle}));
      CellPoint low = image(whole, {middle, v, end}), high = low;
      low[0] -= q(1, 4);
      high[0] += q(1, 4);
      high[2] += q(1, 8);
      EXPECT_EQ(image(cells[1], {middle, v, end}), low);
      EXPECT_EQ(image(cells[3], {middle, v, end}), high);
      CellPoint half = image(whole, {middle, v, q(3 * spans, 4)});
      half[0] -= q(1, 8);
      EXPECT_EQ(image(cells[1], {middle, v, q(3 * spans, 4)}), half);
      EXPECT_EQ(image(cells[1], {zero, v, end}), image(whole, {zero, v, end}));
    }
    const Certified answer = certified(cells);
    EXPECT_EQ(answer.verdict, Verdict::kValid);
    EXPECT_EQ(std::get<PatchFacts>(answer.facts).genus, 0u);
  }
}

TEST(SplitCage, ACrackMayOpenTowardsTheBegin) {
  CageSplit split = crack_of(q(1, 2));
  split.crack->is_at_end = false;
  const Cells cells = split_cage({block()}, split).value();
  EXPECT_EQ(image(cells[0], {q(1, 2), q(0), q(0)}), at(q(3, 4), q(0), q(0)));
  EXPECT_EQ(model_of(cells).counts().internal, 3u);
  EXPECT_EQ(certified(cells).verdict, Verdict::kValid);
}

TEST(SplitCage, CopiesThatCrossOrSlideAreNotValid) {
  CageSplit split = crack_of(q(1, 2));
  std::swap(split.crack->low, split.crack->high);  // into each other
  EXPECT_EQ(certified(split_cage({block()}, split).value()).verdict, Verdict::kInvalid);
  split.crack->low = at(q(0), q(0), q(1, 8));  // along the wall
  split.crack->high = {};
  EXPECT_NE(certified(split_cage({block()}, split).value()).verdict, Verdict::kValid);
}

TEST(SplitCage, RefusesWhatIsNoCut) {
  const auto message = [](const CageSplit& split) {
    const auto cells = split_cage({block()}, split);
    return cells ? std::string() : cells.error().message;
  };
  EXPECT_EQ(message({1, 0, q(1, 2), {}}),
            "entity 1 does not exist: there is 1 cell, numbered from 0");
  EXPECT_EQ(message({0, 0, q(1), {}}),
            "at must lie inside of the domain, from 0 to 1, and it is 1");
  CageSplit split = crack_of(q(1, 2));
  split.crack->from = q(0);
  EXPECT_EQ(message(split), "from must lie inside of the domain, from 0 to 1, and it is 0");
  split = crack_of(q(1, 2));
  split.crack->axis = 0;
  EXPECT_EQ(message(split),
            "open names a face across the axis of the cut, along which no crack runs");
  split = crack_of(q(1, 2));
  split.crack->low = split.crack->high;
  EXPECT_EQ(message(split), "low and high are equal: nothing would open");
  EXPECT_FALSE(split_cage({}, {0, 0, q(1, 2), {}}));
}

}  // namespace
}  // namespace veritope
