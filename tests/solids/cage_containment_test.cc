// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/micro/cage/cage_containment.h"

#include <gtest/gtest.h>

#include <random>

#include "solids/micro/cage/box_cage.h"
#include "solids/micro/cage/radial_cage.h"
#include "tests/solids/cage_support.h"
#include "tests/support/v_cells.h"

namespace veritope {
namespace {

using namespace cage_test;

constexpr std::uint64_t kSeed = 2212;

VModel unit_cage() {
  return model_of({box_cage({at(q(0), q(0), q(0)), at(q(1), q(1), q(1))}, {}).value()});
}

TEST(CageContainment, WhatLiesInsideIsProvedAndWhatTouchesOrLeavesIsNot) {
  const VModel cage = unit_cage();
  EXPECT_FALSE(find_gap(cage, content_of(box_mesh({0.125, 0.25, 0.125}, {0.75, 0.5, 0.875}))));
  EXPECT_FALSE(
      find_gap(cage, content_of(box_mesh({0x1p-30, 0x1p-30, 0x1p-30}, {0.5, 0.5, 1 - 0x1p-30}))));
  const auto touches = find_gap(cage, content_of(box_mesh({0.125, 0, 0.125}, {0.5, 0.5, 0.5})));
  ASSERT_TRUE(touches);
  EXPECT_EQ(touches->face, 2u);
  const auto leaves = find_gap(cage, content_of(box_mesh({0.5, 0.5, 0.5}, {0.75, 0.75, 1.5})));
  ASSERT_TRUE(leaves);
  EXPECT_EQ(leaves->face, 5u);
  EXPECT_TRUE(find_gap(cage, content_of(box_mesh({2, 2, 2}, {3, 3, 3}))));
  // One that is outside is noticed beside one that is inside.
  const TriangleMesh in = box_mesh({0.25, 0.25, 0.25}, {0.5, 0.5, 0.5});
  const auto second = find_gap(cage, content_of(together(in, box_mesh({2, 2, 2}, {3, 3, 3}))));
  ASSERT_TRUE(second);
  EXPECT_GE(second->part, 12u);
  // A cage in the content is not around it.
  EXPECT_TRUE(find_gap(cage, content_of(box_mesh({-1, -1, -1}, {2, 2, 2}))));
}

TEST(CageContainment, AHoleOfTheCageIsOutside) {
  RadialShape shape;
  shape.inner = q(1);
  shape.outer = q(3);
  shape.high = q(1);
  const VModel ring = model_of({radial_cage(shape).value().cell});
  EXPECT_FALSE(find_gap(ring, content_of(box_mesh({1.25, -0.5, 0.25}, {2, 0.5, 0.75}))));
  EXPECT_TRUE(find_gap(ring, content_of(box_mesh({-0.5, -0.5, 0.25}, {0.5, 0.5, 0.75}))));
  // The border of the ring does not meet triangles around the hole, only those across it.
  EXPECT_TRUE(find_gap(ring, content_of(box_mesh({-2, -0.5, 0.25}, {2, 0.5, 0.75}))));
  shape.inner = q(0);
  const VModel disc = model_of({radial_cage(shape).value().cell});
  EXPECT_FALSE(find_gap(disc, content_of(box_mesh({-2, -0.5, 0.25}, {2, 0.5, 0.75}))));
}

TEST(CageContainment, GluedWallsAreNoBorder) {
  const VModel two = model_of({v_cells::cube(0, 0, 0), v_cells::cube(1, 0, 0)});
  EXPECT_FALSE(find_gap(two, content_of(box_mesh({0.5, 0.25, 0.25}, {1.5, 0.75, 0.75}))));
}

// Boxes: the truth is known exactly.
TEST(CageContainment, AgreesWithCoordinatesInBoxes) {
  const VModel cage = unit_cage();
  std::mt19937_64 random(kSeed);
  int num_inside = 0;
  for (int loop = 0; loop < 100; ++loop) {
    std::vector<CellPoint> points;
    bool is_inside = true;
    for (int i = 0; i < 4; ++i) {
      CellPoint p;
      for (Rational& x : p) {
        x = q(static_cast<std::int64_t>(random() % 1000) - 20, 960);
        is_inside = is_inside && q(0) < x && x < q(1);
      }
      points.push_back(p);
    }
    SCOPED_TRACE("seed " + std::to_string(kSeed) + ", loop " + std::to_string(loop));
    EXPECT_EQ(!find_gap(cage, hull_of(points)).has_value(), is_inside);
    num_inside += is_inside ? 1 : 0;
  }
  EXPECT_GT(num_inside, 10);
  EXPECT_LT(num_inside, 90);
}

// (u, v, w) -> (u, v, w + u^2 - v^2): a point is inside iff 0 < x, y, z - x^2 + y^2 < 1.
TEST(CageContainment, NeverContradictsTheTruthInACurvedCage) {
  const auto height = [](std::size_t i, std::size_t j, std::size_t k) {
    return Rational(static_cast<int>(k)) + (i == 2 ? q(1) : q(0)) - (j == 2 ? q(1) : q(0));
  };
  const VModel cage = model_of({v_cells::polynomial({2, 2, 1}, [&](auto i, auto j, auto k) {
    return v_cells::Point{q(static_cast<int>(i), 2), q(static_cast<int>(j), 2), height(i, j, k)};
  })});
  const auto is_in = [](const CellPoint& p) {
    const Rational w = p[2] - p[0] * p[0] + p[1] * p[1];
    return q(0) < p[0] && p[0] < q(1) && q(0) < p[1] && p[1] < q(1) && q(0) < w && w < q(1);
  };
  std::mt19937_64 random(kSeed + 1);
  int num_proved = 0, num_wholly_in = 0;
  for (int loop = 0; loop < 100; ++loop) {
    const auto place = [&](std::int64_t lo, std::int64_t hi) {
      return q(lo + static_cast<std::int64_t>(random() % static_cast<std::uint64_t>(hi - lo)),
               1024);
    };
    const CellPoint middle = at(place(0, 1024), place(0, 1024), place(-1024, 2048));
    std::vector<CellPoint> points;
    for (int i = 0; i < 3; ++i) {
      CellPoint p = middle;
      for (Rational& x : p) x += place(-200, 200);
      points.push_back(p);
    }
    bool are_in = true;
    for (int i = 0; i <= 8; ++i)
      for (int j = 0; i + j <= 8; ++j) {
        CellPoint p;
        for (std::size_t k = 0; k < 3; ++k)
          p[k] = (q(i) * points[0][k] + q(j) * points[1][k] + q(8 - i - j) * points[2][k]) / q(8);
        are_in = are_in && is_in(p);
      }
    SCOPED_TRACE("seed " + std::to_string(kSeed + 1) + ", loop " + std::to_string(loop));
    const bool is_proved = !find_gap(cage, hull_of(points)).has_value();
    EXPECT_TRUE(are_in || !is_proved);
    num_proved += is_proved ? 1 : 0;
    num_wholly_in += are_in ? 1 : 0;
  }
  EXPECT_GT(num_proved, 10);
  EXPECT_GE(num_proved, num_wholly_in - 5);  // triangles that nearly touch may stay open
}

}  // namespace
}  // namespace veritope
