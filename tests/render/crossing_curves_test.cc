// SPDX-License-Identifier: LGPL-3.0-or-later
#include "render/crossing_curves.h"

#include <gtest/gtest.h>

#include <cmath>

namespace veritope {
namespace {

// A square of n x n cells with the corner `at` and the sides u and v.
SceneSurface square(const Point3d& at, const Point3d& u, const Point3d& v, std::uint32_t n) {
  SceneSurface out;
  for (std::uint32_t i = 0; i <= n; ++i)
    for (std::uint32_t j = 0; j <= n; ++j) {
      Point3d p = at;
      for (std::size_t k = 0; k < 3; ++k) p[k] += (i * u[k] + j * v[k]) / n;
      out.points.push_back(p);
    }
  for (std::uint32_t i = 0; i < n; ++i)
    for (std::uint32_t j = 0; j < n; ++j) {
      const std::uint32_t a = i * (n + 1) + j, b = a + n + 1;
      out.triangles.push_back({a, b, b + 1});
      out.triangles.push_back({a, b + 1, a + 1});
    }
  return out;
}

double length(const CrossingCurves& curves) {
  double sum = 0;
  for (const auto& [p, q] : curves.segments)
    sum += std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
  return sum;
}

const Point3d kX = {1, 0, 0}, kY = {0, 1, 0}, kZ = {0, 0, 1};

// Two upright squares cross the level one in the lines x = 0.3 and x = 0.71, and each other nowhere.
std::vector<SceneSurface> comb() {
  return {square({0, 0, 0}, kX, kY, 7), square({0.3, 0, -0.5}, kY, kZ, 5),
          square({0.71, 0, -0.5}, kY, kZ, 5)};
}

TEST(CrossingCurves, AreThoseOfAllPairs) {
  const CrossingCurves curves = approx_crossings(comb());
  EXPECT_EQ(curves.num_pairs, 2u);
  EXPECT_FALSE(curves.is_cut);
  EXPECT_NEAR(length(curves), 2, 1e-9);
  for (const auto& segment : curves.segments)
    for (const Point3d& p : segment) {
      EXPECT_NEAR(p[2], 0, 1e-12);
      EXPECT_LT(std::min(std::abs(p[0] - 0.3), std::abs(p[0] - 0.71)), 1e-12);
    }
}

TEST(CrossingCurves, ASurfaceMayCrossItself) {
  SceneSurface both = square({0, 0, 0}, kX, kY, 7);
  const SceneSurface upright = square({0.3, 0.2, -0.5}, kY, kZ, 5);
  const auto shift = static_cast<std::uint32_t>(both.points.size());
  both.points.insert(both.points.end(), upright.points.begin(), upright.points.end());
  for (const auto& [a, b, c] : upright.triangles)
    both.triangles.push_back({a + shift, b + shift, c + shift});
  const CrossingCurves curves = approx_crossings({&both, 1});
  EXPECT_EQ(curves.num_pairs, 1u);
  EXPECT_GT(length(curves), 0.5);
  EXPECT_LT(length(curves), 0.8 + 1e-9);
}

TEST(CrossingCurves, NeighboursHaveNoneAlongTheirCommonSide) {
  // The side x = 1 of both is cut differently, and one of the two is not straight there: the tessellations cross.
  std::vector<SceneSurface> roof = {square({0, 0, 0}, kX, kY, 6),
                                    square({1, 0, 0}, {1, 0, -1}, kY, 7)};
  for (std::size_t i = 1; i + 1 < 8; ++i) roof[1].points[i][0] -= 1e-3 * static_cast<double>(i % 2);
  EXPECT_TRUE(approx_crossings(roof).segments.empty());
  // Beyond their borders neighbours may cross.
  const std::vector<SceneSurface> fold = {square({0, 0, 0}, kX, kY, 8),
                                          square({0, 0, 0}, {0.8, 0, 0.8}, {0, 0.9, -0.4}, 8)};
  const CrossingCurves curves = approx_crossings(fold);
  EXPECT_EQ(curves.num_pairs, 1u);
  EXPECT_GT(length(curves), 0.3);
}

TEST(CrossingCurves, TheWorkIsBoundedAndTheChosenPairComesFirst) {
  const CrossingCurves cut = approx_crossings(comb(), {{2, 0}}, 1000);
  EXPECT_TRUE(cut.is_cut);
  EXPECT_EQ(cut.num_pairs, 1u);
  EXPECT_NEAR(length(cut), 1, 1e-9);
  for (const auto& segment : cut.segments) EXPECT_NEAR(segment[0][0], 0.71, 1e-12);
  const CrossingCurves none = approx_crossings(comb(), {}, 0);
  EXPECT_TRUE(none.is_cut);
  EXPECT_TRUE(none.segments.empty());
}

}  // namespace
}  // namespace veritope
