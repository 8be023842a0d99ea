// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/base/box_hierarchy.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "robust/base/random.h"

namespace veritope {
namespace {

TEST(PieceBoxes, BoxesThatTouchMeetAndABoxLiesInItself) {
  const Box3d unit{{0, 0, 0}, {1, 1, 1}};
  for (std::size_t k = 0; k < 3; ++k) {
    Box3d next = unit, apart = unit, larger = unit;
    next.lo[k] = 1, next.hi[k] = 2;
    apart.lo[k] = 1.5, apart.hi[k] = 2;
    EXPECT_TRUE(meets(unit, next) && meets(next, unit));
    EXPECT_FALSE(meets(unit, apart) || meets(apart, unit));
    larger.hi[k] = 2;
    EXPECT_TRUE(is_inside(unit, larger) && !is_inside(larger, unit));
    larger.hi[k] = 1, larger.lo[k] = -1;
    EXPECT_TRUE(is_inside(unit, larger) && !is_inside(larger, unit));
    EXPECT_EQ(extent(larger), 2);
    EXPECT_EQ(hull(unit, apart).hi[k], 2);
    EXPECT_EQ(hull(larger, apart).lo[k], -1);
    EXPECT_EQ(hull(apart, larger).lo[k], -1);
  }
  EXPECT_TRUE(is_inside(unit, unit));
}

// Certificates list boxes in this order.
TEST(PieceBoxes, TheOrderGathersNeighboursAndKeepsFourBoxesAsTheyAre) {
  const auto order_along_x = [](const std::vector<double>& places) {
    std::vector<Box3d> boxes;
    for (const double x : places) boxes.push_back({{x, 0, 0}, {x + 1, 1, 1}});
    return BoxHierarchy(boxes).order();
  };
  EXPECT_EQ(order_along_x({30, 20, 10, 0}), (std::vector<std::uint32_t>{0, 1, 2, 3}));
  std::vector<std::uint32_t> order = order_along_x({10, 80, 20, 70, 30, 60, 40, 50});
  std::sort(order.begin(), order.begin() + 4);
  EXPECT_EQ(std::vector(order.begin(), order.begin() + 4),
            (std::vector<std::uint32_t>{0, 2, 4, 6}));
}

TEST(PieceBoxes, TheTreeFindsWhatALoopFinds) {
  Random random(3);
  const auto draw = [&](double size) {
    Box3d b;
    for (std::size_t k = 0; k < 3; ++k)
      b.lo[k] = random.unit(), b.hi[k] = b.lo[k] + size * random.unit();
    return b;
  };
  for (const std::size_t n : {0, 1, 4, 5, 60}) {
    std::vector<Box3d> boxes;
    for (std::size_t i = 0; i < n; ++i) boxes.push_back(draw(0.2));
    const BoxHierarchy tree(boxes);
    EXPECT_EQ(tree.order().size(), n);
    for (int trial = 0; trial < 20; ++trial) {
      const Box3d asked = draw(0.3);
      std::vector<std::uint32_t> found, expected;
      tree.visit([&](const Box3d& b) { return meets(b, asked); },
                 [&](std::uint32_t i) { found.push_back(i); });
      for (std::uint32_t i = 0; i < n; ++i)
        if (meets(boxes[i], asked)) expected.push_back(i);
      std::sort(found.begin(), found.end());
      EXPECT_EQ(found, expected);
    }
  }
}

}  // namespace
}  // namespace veritope
