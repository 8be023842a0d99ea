// SPDX-License-Identifier: LGPL-3.0-or-later
// The search for points deep in half-spaces, on programs whose best point is known by construction.
#include "verify/certify/centre_search.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

#include "robust/base/random.h"
#include "tests/predicates/test_scale.h"

namespace veritope {
namespace {

using HalfSpaces = std::vector<HalfSpace>;

constexpr double kTolerance = 1e-9;
constexpr Box3d kBox{{-2, -1, -3}, {1, 4, 2}};

double between(Random& random, double lo, double hi) { return lo + (hi - lo) * random.unit(); }

Point3d random_normal(Random& random) {
  for (;;) {
    const Point3d a{between(random, -1, 1), between(random, -1, 1), between(random, -1, 1)};
    const double length = std::hypot(a[0], a[1], a[2]);
    if (length > 0.1 && length < 1) return {a[0] / length, a[1] / length, a[2] / length};
  }
}
Point3d random_point(Random& random) {
  Point3d out;
  for (std::size_t k = 0; k < 3; ++k) out[k] = between(random, kBox.lo[k] + 0.5, kBox.hi[k] - 0.5);
  return out;
}
// The point lies `depth` deep in it.
HalfSpace half_space(const Point3d& a, const Point3d& point, double depth) {
  return {a, depth - (a[0] * point[0] + a[1] * point[1] + a[2] * point[2])};
}
// No point is deeper than this one: the normals of four half-spaces add up to zero.
HalfSpaces tetrahedron_around(const Point3d& point, double depth) {
  const double s = 1 / std::sqrt(3.0);
  HalfSpaces out;
  for (const Point3d& a : {Point3d{s, s, s}, {s, -s, -s}, {-s, s, -s}, {-s, -s, s}})
    out.push_back(half_space(a, point, depth));
  return out;
}
bool is_in_box(const Point3d& p) {
  for (std::size_t k = 0; k < 3; ++k)
    if (!(kBox.lo[k] - kTolerance <= p[k] && p[k] <= kBox.hi[k] + kTolerance)) return false;
  return true;
}

TEST(LeastDepth, IsThatOfTheNearestBorder) {
  const Point3d at{0.25, 1, -1};
  EXPECT_EQ(least_depth({}, at), std::numeric_limits<double>::infinity());
  EXPECT_EQ(least_depth({half_space({1, 0, 0}, at, 0.5), half_space({0, -1, 0}, at, -0.25)}, at),
            -0.25);
}

TEST(DeepestPoint, IsNearlyAsDeepAsTheBestOne) {
  for (long seed = 0; seed < scaled(300); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(static_cast<std::uint64_t>(seed));
    const Point3d best = random_point(random);
    const double depth = between(random, 0.01, 0.3);
    HalfSpaces all = tetrahedron_around(best, depth);
    for (std::uint64_t n = random.below(60); n > 0; --n)
      all.push_back(half_space(random_normal(random), best, depth + between(random, 0, 0.2)));
    double bound = 0;
    const auto found = deepest_point(all, kBox, 0.5 * depth, &bound);
    ASSERT_TRUE(found);
    EXPECT_TRUE(is_in_box(found->point));
    EXPECT_NEAR(least_depth(all, found->point), found->depth, kTolerance);
    EXPECT_GT(found->depth, 0.9 * depth - kTolerance);
    EXPECT_LT(found->depth, depth + kTolerance);
    EXPECT_GT(bound, depth - kTolerance);
    EXPECT_FALSE(deepest_point(all, kBox, 1.001 * depth));
  }
}

TEST(DeepestPoint, StaysInTheBox) {
  const auto found = deepest_point({half_space({1, 0, 0}, {0, 0, 0}, 0)}, kBox, 0.5);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->point[0], kBox.hi[0], kTolerance);
  EXPECT_FALSE(deepest_point({half_space({1, 0, 0}, {0, 0, 0}, 0)}, kBox, 1.5));
}

TEST(DeepestPoint, IsNotFoundInHalfSpacesThatExcludeEachOther) {
  const HalfSpaces all{half_space({1, 0, 0}, {0.25, 0, 0}, 0),
                       half_space({-1, 0, 0}, {0, 0, 0}, 0)};
  double bound = 0;
  EXPECT_FALSE(deepest_point(all, kBox, 0, &bound));
  EXPECT_NEAR(bound, -0.125, kTolerance);
}

// A search that trusts it with the first half-spaces of many loses nothing.
TEST(IsSurelyShallow, IsNeverSaidWhereAPointIsDeepEnough) {
  for (long seed = 0; seed < scaled(300); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(static_cast<std::uint64_t>(seed));
    const Point3d best = random_point(random);
    const double depth = between(random, 1e-3, 0.3);
    HalfSpaces all;
    for (int n = 0; n < 40; n += 8) {
      for (int k = 0; k < 8; ++k) all.push_back(half_space(random_normal(random), best, depth));
      EXPECT_FALSE(is_surely_shallow(all, kBox, depth)) << n;
    }
  }
}

TEST(IsSurelyShallow, IsSaidWhereNoPointIsNearlyDeepEnough) {
  for (long seed = 0; seed < scaled(100); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(static_cast<std::uint64_t>(seed));
    const double depth = between(random, -0.5, 0.3);
    HalfSpaces all = tetrahedron_around(random_point(random), depth);
    EXPECT_TRUE(is_surely_shallow(all, kBox, std::max(1e-3, depth + 1e-4)));
    EXPECT_EQ(deepest_point(all, kBox, std::max(1e-3, depth + 1e-4)), std::nullopt);
  }
}

TEST(DeepestPointOrZeros, MeetsTwoOppositeHalfSpacesAtTheirCommonBorder) {
  const HalfSpaces all{half_space({0, 0, 1}, {0, 0, 0.5}, 0),
                       half_space({0, 0, -1}, {0, 0, 0.5}, 0),
                       half_space({1, 0, 0}, {-1, 0, 0}, 0)};
  EXPECT_FALSE(deepest_point(all, kBox, 1e-3));
  const auto found = deepest_point_or_zeros(all, kBox, 1e-3);
  ASSERT_TRUE(found);
  EXPECT_TRUE(found->has_zeros);
  EXPECT_NEAR(found->point[2], 0.5, 10 * kBorderDepth);
  EXPECT_GT(found->point[0], -1 + 1e-3);
  const auto without = deepest_point_or_zeros({all[0], all[2]}, kBox, 1e-3);
  ASSERT_TRUE(without);
  EXPECT_FALSE(without->has_zeros);
}

TEST(DeepestPointOrZeros, IsNotFoundInHalfSpacesThatExcludeEachOther) {
  const HalfSpaces all{half_space({0, 0, 1}, {0, 0, 0.5}, 0),
                       half_space({0, 0, -1}, {0, 0, 0.5 - 1e-6}, 0)};
  EXPECT_FALSE(deepest_point_or_zeros(all, kBox, 1e-3));
}

}  // namespace
}  // namespace veritope
