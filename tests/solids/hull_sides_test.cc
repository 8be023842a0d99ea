// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/micro/cage/hull_sides_internal.h"

#include <gtest/gtest.h>

#include <random>

#include "interval/upward.h"
#include "solids/micro/cage/content_search_internal.h"
#include "tests/solids/cage_support.h"

namespace veritope {
namespace {

using namespace cage_test;
using internal::HullPoint;
using internal::HullSides;

constexpr std::uint64_t kSeed = 2213;

class HullSidesOfRandomHulls : public testing::Test {
 protected:
  CellPoint draw() {
    CellPoint p;
    for (Rational& x : p) x = q(static_cast<std::int64_t>(random_() % 2001) - 1000, 7);
    return p;
  }
  std::vector<CellPoint> draw_points(std::size_t n) {
    std::vector<CellPoint> out;
    for (std::size_t i = 0; i < n; ++i) out.push_back(draw());
    return out;
  }
  // A convex combination.
  CellPoint mean(const std::vector<CellPoint>& points) {
    CellPoint sum{};
    Rational total;
    for (const CellPoint& p : points) {
      const Rational weight(static_cast<int>(random_() % 5));
      for (std::size_t k = 0; k < 3; ++k) sum[k] += weight * p[k];
      total += weight;
    }
    if (total.sign() == Sign::kZero) return points.front();
    for (Rational& x : sum) x /= total;
    return sum;
  }
  static std::vector<HullPoint> hull(const std::vector<CellPoint>& points) {
    std::vector<HullPoint> out;
    for (const CellPoint& p : points) out.push_back(internal::hull_point(p));
    return out;
  }
  std::mt19937_64 random_{kSeed};
};

TEST_F(HullSidesOfRandomHulls, HullsWithACommonPointAreNeverApart) {
  for (int loop = 0; loop < 2000; ++loop) {
    SCOPED_TRACE("seed " + std::to_string(kSeed) + ", loop " + std::to_string(loop));
    const auto a = draw_points(1 + loop % 5);
    auto b = draw_points(1 + loop % 3);
    // Moved so that a point of b is a point of a.
    const CellPoint in_a = mean(a), in_b = mean(b);
    for (CellPoint& p : b)
      for (std::size_t k = 0; k < 3; ++k) p[k] += in_a[k] - in_b[k];
    const auto hull_a = hull(a), hull_b = hull(b);
    const ScopedUpward upward;
    EXPECT_FALSE(HullSides(hull_a).is_apart_from(hull_b));
  }
}

TEST_F(HullSidesOfRandomHulls, HullsOnDifferentSidesOfAPlaneAreApart) {
  for (int loop = 0; loop < 1000; ++loop) {
    SCOPED_TRACE("seed " + std::to_string(kSeed) + ", loop " + std::to_string(loop));
    auto a = draw_points(4), b = draw_points(3);
    const CellPoint d = draw();
    const auto along = [&](const CellPoint& p) { return d[0] * p[0] + d[1] * p[1] + d[2] * p[2]; };
    const Rational square = along(d);
    if (square.sign() == Sign::kZero) continue;
    Rational most = along(a[0]), least = along(b[0]);
    for (const CellPoint& p : a) most = std::max(most, along(p));
    for (const CellPoint& p : b) least = std::min(least, along(p));
    const Rational by = (most - least) / square + q(1, 4);
    for (CellPoint& p : b)
      for (std::size_t k = 0; k < 3; ++k) p[k] += by * d[k];
    const auto hull_a = hull(a), hull_b = hull(b);
    const ScopedUpward upward;
    HullSides sides(hull_a);
    EXPECT_TRUE(sides.is_apart_from(hull_b));
    EXPECT_TRUE(sides.is_apart_from(hull_b));  // by the direction that is known now
  }
}

TEST(ContentSearch, HalvesPatchesWhoseHullsMeetWhatTheyMiss) {
  // The saddle z = u v on the unit square, and a triangle above its middle that is inside of its hull.
  const BezierSurface<Rational> saddle(
      {1, 1}, 3, false, {q(0), q(0), q(1), q(1), q(0), q(1), q(0), q(1), q(0), q(0), q(0), q(1)});
  const auto enclosed = internal::enclosed(saddle);
  const auto content = [](const Rational& z) {
    return hull_of({at(q(1, 2), q(1, 2), z), at(q(9, 16), q(1, 2), z), at(q(1, 2), q(9, 16), z)});
  };
  const internal::ContentSearch near(content(q(3, 8)));
  EXPECT_EQ(near.met_by(enclosed, 0), 0u);
  EXPECT_FALSE(near.met_by(enclosed, 8));
  const internal::ContentSearch touching(content(q(1, 4)));
  EXPECT_EQ(touching.met_by(enclosed, 12), 0u);
  const internal::ContentSearch above(content(q(2)));
  EXPECT_FALSE(above.met_by(enclosed, 0));
}

TEST(ContentSearch, FindsTheNearestPlaceOfTriangles) {
  const internal::ContentSearch cube(content_of(box_mesh({0, 0, 0}, {1, 1, 1})));
  const auto place = [&](Point3d p) { return cube.approx_nearest(p); };
  EXPECT_EQ(place({2, 0.25, 0.75}), (Point3d{1, 0.25, 0.75}));
  EXPECT_EQ(place({2, 3, 0.5}), (Point3d{1, 1, 0.5}));
  EXPECT_EQ(place({-1, -2, -3}), (Point3d{0, 0, 0}));
  EXPECT_EQ(place({0.5, 0.5, 0.875}), (Point3d{0.5, 0.5, 1}));
}

}  // namespace
}  // namespace veritope
