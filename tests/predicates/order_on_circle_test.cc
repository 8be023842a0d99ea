// SPDX-License-Identifier: LGPL-3.0-or-later
#include "predicates/order_on_circle.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "tests/predicates/rational_oracle.h"

namespace veritope {
namespace {

// Sixteen directions, counter-clockwise from (1, 0), at different distances.
std::vector<Vec2d> directions() {
  return {{3, 0},  {4, 1},   {2, 2},   {1, 5},   {0, 0.5}, {-1, 4}, {-3, 3}, {-7, 2},
          {-1, 0}, {-5, -1}, {-1, -1}, {-2, -9}, {0, -6},  {2, -7}, {4, -4}, {9, -1}};
}

TEST(OrderOnCircle, IsTheOrderOfTheAnglesFromEveryFirstRay) {
  const std::vector<Vec2d> ray = directions();
  const int n = static_cast<int>(ray.size());
  for (int p = 0; p < n; ++p) {
    for (int q = 0; q < n; ++q) {
      for (int r = 0; r < n; ++r) {
        const int turn_q = (q - p + n) % n, turn_r = (r - p + n) % n;
        const Sign expected = sign_of(turn_r - turn_q);
        EXPECT_EQ(order_on_circle({0, 0}, ray[p], ray[q], ray[r]), expected)
            << p << ' ' << q << ' ' << r;
        // Twice as far is the same ray, and the centre may be elsewhere.
        const auto moved = [](const Vec2d& v, double s) -> Vec2d {
          return {7 + s * v.x, s * v.y - 9};
        };
        EXPECT_EQ(
            order_on_circle({7, -9}, moved(ray[p], 1), moved(ray[q], 2), moved(ray[r], 0x1p20)),
            expected);
      }
    }
  }
}

TEST(OrderOnCircleLaw, SwappingNegatesAndShiftingKeeps) {
  const std::vector<Vec2d> ray = directions();
  for (std::size_t p = 0; p < ray.size(); ++p) {
    for (std::size_t q = 0; q < ray.size(); ++q) {
      for (std::size_t r = 0; r < ray.size(); ++r) {
        const Sign s = order_on_circle({}, ray[p], ray[q], ray[r]);
        EXPECT_EQ(order_on_circle({}, ray[p], ray[r], ray[q]), -s);
        if (p == q || q == r || r == p) continue;
        EXPECT_EQ(order_on_circle({}, ray[q], ray[r], ray[p]), s);
      }
    }
  }
}

TEST(OrderOnCircle, IsZeroAtTheCentre) {
  const Vec2d c{1, 2}, p{3, 4}, q{0, 7};
  EXPECT_EQ(order_on_circle(c, c, p, q), Sign::kZero);
  EXPECT_EQ(order_on_circle(c, p, c, q), Sign::kZero);
  EXPECT_EQ(order_on_circle(c, p, q, c), Sign::kZero);
  EXPECT_EQ(order_on_circle({0.0, 0}, {-0.0, 0}, p, q), Sign::kZero);
}

TEST(OrderOnCircle, IsExactForAngleDifferencesThatRoundToZero) {
  const double tiny = 5e-324, huge = 0x1.fffffffffffffp1023;
  EXPECT_EQ(order_on_circle({}, {1, 0}, {huge, tiny}, {1, tiny}), Sign::kPositive);
  EXPECT_EQ(order_on_circle({}, {1, 0}, {1, -tiny}, {huge, -tiny}), Sign::kPositive);
  EXPECT_EQ(order_on_circle({}, {1, 0}, {huge, 0}, {tiny, 0}), Sign::kZero);
  EXPECT_EQ(order_on_circle({}, {huge, huge}, {-huge, -huge}, {-huge, -0x1.ffffffffffffep1023}),
            Sign::kNegative);
}

}  // namespace
}  // namespace veritope
