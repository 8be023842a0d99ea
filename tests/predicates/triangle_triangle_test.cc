// SPDX-License-Identifier: LGPL-3.0-or-later
#include "predicates/triangle_triangle.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "robust/base/random.h"
#include "tests/predicates/grid_pairs.h"
#include "tests/predicates/test_scale.h"

namespace veritope {
namespace {

using Contact = TriangleContact;

TEST(TriangleTriangle, AgreesWithClippingOnEveryPairOfTheUnitCube) {
  oracle::compare_on_grid(2, 2, 2, 1);
}
TEST(TriangleTriangle, AgreesWithClippingOnEveryPlanarPairOfTheGrid) {
  oracle::compare_on_grid(4, 3, 1, 1);
}
TEST(TriangleTriangle, AgreesWithClippingOnASampleOfTheCubeOf27Points) {
  oracle::compare_on_grid(3, 3, 3, 41);
}

IndexedTriangle triangle(Vec3d a, Vec3d b, Vec3d c, std::uint32_t i, std::uint32_t j,
                         std::uint32_t k) {
  return {{a, b, c}, {i, j, k}};
}
const IndexedTriangle kFloor = triangle({0, 0, 0}, {4, 0, 0}, {0, 4, 0}, 0, 1, 2);

TEST(TriangleTriangle, TellsStrangersThatTouchFromStrangersThatDoNot) {
  EXPECT_EQ(triangle_triangle(kFloor, triangle({1, 1, 0}, {1, 1, 3}, {2, 1, 3}, 3, 4, 5)),
            Contact::kImproper);
  EXPECT_EQ(triangle_triangle(kFloor, triangle({1, 1, 5e-324}, {1, 1, 3}, {2, 1, 3}, 3, 4, 5)),
            Contact::kDisjoint);
  EXPECT_EQ(triangle_triangle(kFloor, triangle({4, 4, 0}, {5, 5, 0}, {4, 5, 0}, 3, 4, 5)),
            Contact::kDisjoint);
  EXPECT_EQ(triangle_triangle(kFloor, triangle({2, 2, 0}, {5, 5, 0}, {4, 5, 0}, 3, 4, 5)),
            Contact::kCoplanarOverlap);
}

TEST(TriangleTriangle, JudgesAnEqualPlaceWithAnotherIdAsAStranger) {
  EXPECT_EQ(triangle_triangle(kFloor, triangle({0, 0, 0}, {-1, 0, 1}, {0, -1, 1}, 0, 4, 5)),
            Contact::kSharedVertex);
  EXPECT_EQ(triangle_triangle(kFloor, triangle({0, 0, 0}, {-1, 0, 1}, {0, -1, 1}, 3, 4, 5)),
            Contact::kImproper);
  EXPECT_EQ(triangle_triangle(kFloor, triangle({0, 0, 0}, {4, 0, 0}, {0, -1, 1}, 0, 1, 5)),
            Contact::kSharedEdge);
  EXPECT_EQ(triangle_triangle(kFloor, triangle({0, 0, 0}, {4, 0, 0}, {0, -1, 1}, 0, 4, 5)),
            Contact::kImproper);
  EXPECT_EQ(triangle_triangle(kFloor, triangle({0, 0, 0}, {4, 0, 0}, {0, 4, 0}, 0, 1, 5)),
            Contact::kCoplanarOverlap);
}

TEST(TriangleTriangle, FindsAFoldOntoTheNeighbour) {
  EXPECT_EQ(triangle_triangle(kFloor, triangle({4, 0, 0}, {0, 0, 0}, {1, 1, 0}, 1, 0, 5)),
            Contact::kCoplanarOverlap);
  EXPECT_EQ(triangle_triangle(kFloor, triangle({4, 0, 0}, {0, 0, 0}, {1, -1, 0}, 1, 0, 5)),
            Contact::kSharedEdge);
  EXPECT_EQ(triangle_triangle(kFloor, triangle({2, 0, 4}, {4, 0, 0}, {0, 0, 0}, 5, 1, 0)),
            Contact::kSharedEdge);
}

TEST(TriangleTriangle, CallsTheSameThreeVerticesIdenticalInAnyOrder) {
  EXPECT_EQ(triangle_triangle(kFloor, triangle({0, 4, 0}, {4, 0, 0}, {0, 0, 0}, 2, 1, 0)),
            Contact::kIdentical);
}

TEST(TriangleTriangle, KnowsWhichContactsAMeshMayHave) {
  EXPECT_TRUE(is_proper(Contact::kDisjoint) && is_proper(Contact::kSharedVertex) &&
              is_proper(Contact::kSharedEdge));
  EXPECT_FALSE(is_proper(Contact::kImproper) || is_proper(Contact::kCoplanarOverlap) ||
               is_proper(Contact::kIdentical));
}

TEST(TriangleTriangle, DoesNotDependOnTheOrderOfCornersOrTrianglesNorOnAPowerOfTwoOrAnExactShift) {
  Random random(7);
  for (long i = 0; i < scaled(20000); ++i) {
    // Few coordinates, so that every contact occurs; then stretched axes.
    std::array<IndexedTriangle, 2> pair;
    std::array<Vec3d, 5> pool;
    for (Vec3d& p : pool) {
      p = {static_cast<double>(random.between(0, 3)), static_cast<double>(random.between(0, 3)),
           static_cast<double>(random.between(0, 2))};
    }
    bool usable = true;
    for (IndexedTriangle& t : pair) {
      std::array<std::uint32_t, 5> ids{0, 1, 2, 3, 4};
      std::shuffle(ids.begin(), ids.end(), random);
      for (int k = 0; k < 3; ++k) t.id[k] = ids[k], t.point[k] = pool[ids[k]];
      oracle::ITriangle integer;
      for (int k = 0; k < 3; ++k) {
        integer[k] = {static_cast<std::int64_t>(t.point[k].x),
                      static_cast<std::int64_t>(t.point[k].y),
                      static_cast<std::int64_t>(t.point[k].z)};
      }
      usable = usable && !oracle::degenerate(integer);
    }
    if (!usable) continue;
    const Contact c = triangle_triangle(pair[0], pair[1]);
    EXPECT_EQ(triangle_triangle(pair[1], pair[0]), c);
    std::array<IndexedTriangle, 2> other = pair;
    const double sx = random.below(2) == 0 ? 0x1p-700 : 0x1p300, sy = 0x1p-1070, sz = 0x1p1000;
    const double shift = static_cast<double>(random.between(-8, 8));
    for (IndexedTriangle& t : other) {
      std::rotate(t.point.begin(), t.point.begin() + i % 3, t.point.end());
      std::rotate(t.id.begin(), t.id.begin() + i % 3, t.id.end());
      if (random.below(2) == 0) std::swap(t.point[0], t.point[1]), std::swap(t.id[0], t.id[1]);
      for (Vec3d& p : t.point) p = {(p.x + shift) * sx, (p.y - shift) * sy, (p.z + shift) * sz};
    }
    EXPECT_EQ(triangle_triangle(other[0], other[1]), c) << i;
    EXPECT_EQ(triangle_triangle(other[1], other[0]), c) << i;
    if (HasFailure()) break;
  }
}

TEST(TriangleTriangle, DecidesGenericPairsWithTheFilterAlone) {
  TierCounts tally;
  EXPECT_EQ(triangle_triangle(kFloor, triangle({1, 1, 1}, {1, 1, 3}, {2, 1, 3}, 3, 4, 5), &tally),
            Contact::kDisjoint);
  EXPECT_EQ(tally[Tier::kFilter], 3u);
  EXPECT_EQ(tally[Tier::kLattice] + tally[Tier::kInterval] + tally[Tier::kExact], 0u);
  EXPECT_EQ(triangle_triangle(kFloor, triangle({0, 0, 0}, {-1, 0, 1}, {0, -1, 1}, 0, 4, 5), &tally),
            Contact::kSharedVertex);
  EXPECT_EQ(tally[Tier::kFilter], 5u);
  EXPECT_EQ(triangle_triangle(kFloor, triangle({0, 0, 0}, {4, 0, 0}, {0, -1, 1}, 0, 1, 5), &tally),
            Contact::kSharedEdge);
  EXPECT_EQ(tally[Tier::kFilter], 6u);
}

TEST(TriangleTriangle, CountsTheDearerTiersOfCoplanarPairs) {
  TierCounts tally;
  const IndexedTriangle t = triangle({1, 0, 0}, {0, 1, 0}, {0, 0, 1}, 0, 1, 2);
  EXPECT_EQ(triangle_triangle(t, triangle({3, -1, -1}, {4, -2, -1}, {3, -2, 0}, 3, 4, 5), &tally),
            Contact::kDisjoint);
  EXPECT_GE(tally[Tier::kLattice], 3u);  // the three signs over the plane, and some in it
  EXPECT_EQ(tally[Tier::kInterval] + tally[Tier::kExact], 0u);
}

}  // namespace
}  // namespace veritope
