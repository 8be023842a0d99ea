// SPDX-License-Identifier: LGPL-3.0-or-later
#include "predicates/projection.h"

#include <gtest/gtest.h>

namespace veritope {
namespace {

TEST(AxisProjection, KeepsTheOrientationAlongEachAxis) {
  EXPECT_EQ(drop_axis({1, 2, 3}, 0), (Vec2d{2, 3}));
  EXPECT_EQ(drop_axis({1, 2, 3}, 1), (Vec2d{3, 1}));
  EXPECT_EQ(drop_axis({1, 2, 3}, 2), (Vec2d{1, 2}));
}

TEST(Vectors, AreEqualIfAllCoordinatesAre) {
  EXPECT_TRUE((Vec2d{1, 2}) == (Vec2d{1, 2}));
  EXPECT_FALSE((Vec2d{1, 2}) == (Vec2d{0, 2}));
  EXPECT_FALSE((Vec2d{1, 2}) == (Vec2d{1, 0}));
  EXPECT_TRUE((Vec3d{1, 2, 3}) == (Vec3d{1, 2, 3}));
  EXPECT_FALSE((Vec3d{1, 2, 3}) == (Vec3d{0, 2, 3}));
  EXPECT_FALSE((Vec3d{1, 2, 3}) == (Vec3d{1, 0, 3}));
  EXPECT_FALSE((Vec3d{1, 2, 3}) == (Vec3d{1, 2, 0}));
}

TEST(AxisProjection, FindsAnAxisAlongWhichATriangleIsSeen) {
  const Vec3d o{}, x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
  EXPECT_EQ(projection_of(o, x, y).axis, 2);
  EXPECT_EQ(projection_of(o, y, z).axis, 0);
  EXPECT_EQ(projection_of(o, z, x).axis, 1);
  EXPECT_EQ(projection_of(o, z, x).sign, Sign::kPositive);
  EXPECT_EQ(projection_of(o, x, z).sign, Sign::kNegative);
  // Seen by the exact tiers only.
  EXPECT_EQ(projection_of(o, {5e-324, 0, 0}, {0, 5e-324, 0}).axis, 2);
  EXPECT_EQ(projection_of(o, {0, 0, 5e-324}, {5e-324, 0, 0}).axis, 1);
}

TEST(AxisProjection, CallsThreePointsCollinearExactlyWhenTheyAre) {
  EXPECT_TRUE(collinear({0, 0, 0}, {1, 2, 3}, {2, 4, 6}));
  EXPECT_TRUE(collinear({0.1, 0.1, 0.1}, {0.1, 0.1, 0.1}, {7, 8, 9}));
  EXPECT_FALSE(collinear({0, 0, 0}, {1, 2, 3}, {2, 4, 0x1.8000000000001p2}));
  EXPECT_FALSE(collinear({0, 0, 0}, {5e-324, 0, 0}, {1e308, 5e-324, 0}));
}

}  // namespace
}  // namespace veritope
