// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/collar/octree_root.h"

#include <gtest/gtest.h>

#include <cmath>

#include "robust/base/random.h"
#include "robust/rational.h"

namespace veritope {
namespace {

Box3d cube(const Point3d& low, double edge) {
  return {low, {low[0] + edge, low[1] + edge, low[2] + edge}};
}

TEST(OctreeRoot, HoldsTheModelWithRoomAndHasExactPlanes) {
  Random random(3);
  for (int trial = 0; trial < 2000; ++trial) {
    Box3d inner;
    const double size = std::exp2(static_cast<int>(random.below(20)) - 18);
    for (std::size_t k = 0; k < 3; ++k) {
      inner.lo[k] = 2 * random.unit() - 1;
      inner.hi[k] = inner.lo[k] + size * random.unit();
    }
    if (!(extent(inner) > 0)) continue;
    const Result<OctreeRoot> root = root_around(inner);
    ASSERT_TRUE(root) << "trial " << trial;
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_LT(root->box().lo[k], inner.lo[k]) << "trial " << trial;
      EXPECT_GT(root->box().hi[k], inner.hi[k]) << "trial " << trial;
      const std::uint32_t grid = static_cast<std::uint32_t>(random.below(OctreeKey::kGrid + 1));
      EXPECT_EQ(Rational::from_double(root->plane(k, grid)),
                Rational::from_double(root->corner[k]) +
                    Rational(static_cast<std::int64_t>(grid)) * Rational::from_double(root->unit));
    }
    EXPECT_LE(root->edge(), 2.3 * extent(inner)) << "trial " << trial;
  }
}

TEST(OctreeRoot, KeepsWallsAwayFromCoordinatesOfFewBits) {
  for (const double low : {0.0, -1.0, 0.5, 0.375}) {
    const OctreeRoot root = root_around(cube({low, low, low}, 1)).value();
    for (unsigned level = 3; level <= 12; ++level) {
      const double cell = std::ldexp(root.edge(), -static_cast<int>(level));
      double residue[3];
      for (std::size_t k = 0; k < 3; ++k) {
        const double halves = root.corner[k] / (0.5 * cell);
        EXPECT_GE(std::abs(halves - std::round(halves)), 0.18) << level;  // in halves of a cell
        residue[k] = root.corner[k] / cell;
      }
      for (std::size_t k = 0; k < 3; ++k) {
        const double d = residue[k] - residue[(k + 1) % 3];
        EXPECT_GE(std::abs(d - std::round(d)), 0.06) << level;
      }
    }
  }
}

TEST(OctreeRoot, RefusesWhatDoublesCannotHold) {
  EXPECT_EQ(root_around(cube({1, 1, 1}, std::exp2(-40))).error().code, Code::kOverLimit);
  EXPECT_EQ(root_around(cube({0, 0, 0}, 0)).error().code, Code::kOverLimit);
  EXPECT_EQ(root_around(cube({0, 0, 0}, HUGE_VAL)).error().code, Code::kOverLimit);
  EXPECT_EQ(root_around(cube({0, 0, 0}, std::exp2(-1000))).error().code, Code::kOverLimit);
  EXPECT_TRUE(root_around(cube({0, 0, 0}, std::exp2(-900))));
}

TEST(OctreeRoot, BoxesOfCellsNestAsTheirKeysDo) {
  const OctreeRoot root = root_around(cube({0, 0, 0}, 1)).value();
  const OctreeKey parent = OctreeKey::make({3, 1, 5, 7}).value();
  for (unsigned octant = 0; octant < 8; ++octant)
    EXPECT_TRUE(is_inside(root.box(parent.child(octant)), root.box(parent)));
  EXPECT_TRUE(is_inside(root.box(parent), root.box()));
}

}  // namespace
}  // namespace veritope
