// SPDX-License-Identifier: LGPL-3.0-or-later
// tests/solids/convex_polygon_test.cc: triangles of convex polygons with angles of 180 degrees.
#include "solids/dms/domain/convex_polygon.h"

#include <gtest/gtest.h>

#include <numeric>

namespace veritope {
namespace {

TEST(ConvexPolygon, IsTriangulatedWithoutFlatTriangles) {
  // Every side of a triangle has inner corners, so that no corner sees all.
  const std::vector<Vec3d> corners{{0, 0, 1}, {1, 0, 1}, {2, 0, 1}, {4, 0, 1}, {3, 1, 1},
                                   {2, 2, 1}, {0, 4, 1}, {0, 3, 1}, {0, 1, 1}};
  std::vector<AnyPoint3> points(corners.begin(), corners.end());
  std::vector<std::uint32_t> ranks(corners.size());
  std::iota(ranks.begin(), ranks.end(), 0u);
  const auto triangles = triangulate_convex(points, ranks);
  EXPECT_EQ(triangles.size(), corners.size() - 2);
  double area = 0;
  for (const auto& t : triangles) {
    const Vec3d &a = corners[t[0]], &b = corners[t[1]], &c = corners[t[2]];
    const double twice = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
    EXPECT_GT(twice, 0);
    area += twice;
  }
  EXPECT_EQ(area, 16);
}

TEST(ConvexPolygon, IsAFanFromTheCornerOfLeastRankThatSeesAll) {
  const std::vector<Vec3d> corners{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}};
  const std::vector<AnyPoint3> points(corners.begin(), corners.end());
  // Corner 0 and corner 2 are on a line with two others; corner 1 is on a side, and its ends are corners.
  for (const auto& t : triangulate_convex(points, std::vector<std::uint32_t>{0, 4, 1, 3, 2}))
    EXPECT_EQ(t[0], 4u);
  for (const auto& t : triangulate_convex(points, std::vector<std::uint32_t>{0, 2, 1, 3, 4}))
    EXPECT_EQ(t[0], 1u);
}

}  // namespace
}  // namespace veritope
