// SPDX-License-Identifier: LGPL-3.0-or-later
// tests/solids/nearest_of_hull_test.cc: directions that have positive products with many vectors.
#include "solids/dms/nearest_of_hull.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "robust/base/random.h"

namespace veritope {
namespace {

using internal::PlainVector;

double least_product(const std::vector<PlainVector>& vectors, const PlainVector& w) {
  double least = HUGE_VAL;
  for (const PlainVector& v : vectors) least = std::min(least, internal::dot_product(v, w));
  return least / std::sqrt(internal::dot_product(w, w));
}
std::optional<PlainVector> nearest(const std::vector<PlainVector>& vectors) {
  return internal::nearest_of_hull([&](const PlainVector& w) {
    return *std::min_element(vectors.begin(), vectors.end(),
                             [&](const PlainVector& a, const PlainVector& b) {
                               return internal::dot_product(a, w) < internal::dot_product(b, w);
                             });
  });
}
PlainVector draw(Random& random) {
  return {random.between(-1000, 1000) / 1e3, random.between(-1000, 1000) / 1e3,
          random.between(-1000, 1000) / 1e3};
}

TEST(NearestOfHull, IsAboutTheBestDirection) {
  for (std::uint64_t seed = 0; seed < 2000; ++seed) {
    Random random(seed);
    PlainVector axis = draw(random);
    const double length = std::sqrt(internal::dot_product(axis, axis));
    if (length < 0.1) continue;
    for (double& x : axis) x /= length;
    // All on one side of a plane at a distance from the origin, far away along it or not.
    const double distance = std::ldexp(1.0, -static_cast<int>(random.below(12)));
    std::vector<PlainVector> vectors;
    for (std::size_t i = 0, n = 1 + random.below(60); i < n; ++i) {
      PlainVector v = draw(random);
      const double excess = distance * (1 + (random.below(3) == 0 ? 0 : random.below(8))) -
                            internal::dot_product(v, axis);
      for (std::size_t c = 0; c < 3; ++c) v[c] += excess * axis[c];
      vectors.push_back(v);
    }
    const auto found = nearest(vectors);
    ASSERT_TRUE(found) << "seed " << seed;
    EXPECT_GE(least_product(vectors, *found), 0.99 * distance) << "seed " << seed;
  }
}

TEST(NearestOfHull, FindsNothingAroundTheOrigin) {
  for (std::uint64_t seed = 0; seed < 500; ++seed) {
    Random random(seed);
    std::vector<PlainVector> vectors;
    PlainVector sum{};
    for (std::size_t i = 0, n = 3 + random.below(20); i < n; ++i) {
      vectors.push_back(draw(random));
      for (std::size_t c = 0; c < 3; ++c) sum[c] -= vectors.back()[c];
    }
    vectors.push_back(sum);  // the mean of all is 0
    const auto found = nearest(vectors);
    EXPECT_TRUE(!found || least_product(vectors, *found) < 1e-9) << "seed " << seed;
  }
}

TEST(NearestOfHull, OfFewVectors) {
  EXPECT_EQ(nearest({{0, 0, 2}}), (PlainVector{0, 0, 2}));
  EXPECT_FALSE(nearest({{0, 0, 0}}));
  EXPECT_FALSE(nearest({{1, 0, 0}, {-1, 0, 0}}));
  const auto found = nearest({{1, 1, 0}, {1, -1, 0}, {1, 0, 1}, {1, 0, -1}, {5, 0, 0}});
  ASSERT_TRUE(found);
  EXPECT_NEAR((*found)[0], 1, 1e-9);
  EXPECT_NEAR((*found)[1], 0, 1e-9);
  EXPECT_NEAR((*found)[2], 0, 1e-9);
}

}  // namespace
}  // namespace veritope
