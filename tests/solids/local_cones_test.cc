// SPDX-License-Identifier: LGPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>

#include "robust/base/random.h"
#include "solids/chain/local_cones_internal.h"

namespace veritope::internal {
namespace {

constexpr std::uint64_t kSeed = 20261127;

using Steps = std::array<int, 3>;

int dot_of_steps(const Steps& a, const Steps& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

struct SmallCone {
  int coefficient;
  std::vector<Steps> inner;
};

// All directions with coordinates up to 8: they meet all faces of arrangements of planes with coefficients up to 1.
int slow_regular_value(const std::vector<SmallCone>& cones) {
  int greatest = 0, least = 0;
  bool has_value = false;
  for (int x = -8; x <= 8; ++x)
    for (int y = -8; y <= 8; ++y)
      for (int z = -8; z <= 8; ++z) {
        int sum = 0;
        bool is_open = true;
        for (const SmallCone& cone : cones) {
          const bool is_in = std::all_of(cone.inner.begin(), cone.inner.end(), [&](const Steps& n) {
            return dot_of_steps(n, {x, y, z}) >= 0;
          });
          for (const Steps& n : cone.inner) is_open = is_open && dot_of_steps(n, {x, y, z}) != 0;
          sum += is_in ? cone.coefficient : 0;
        }
        greatest = std::max(greatest, sum);
        least = std::min(least, sum);
        has_value = has_value || (is_open && sum != 0);
      }
  return !has_value ? 0 : greatest > 0 ? greatest : least;
}

TEST(RegularValue, IsTheDefinitionOnRandomCones) {
  Random random(kSeed);
  int negative = 0, zero = 0;
  for (int trial = 0; trial < 300; ++trial) {
    std::vector<SmallCone> small;
    std::vector<LocalCone> cones;
    for (std::uint64_t n = 1 + random.below(4); n > 0; --n) {
      SmallCone cone{random.below(2) == 0 ? 1 : -1, {}};
      LocalCone exact{cone.coefficient, {}};
      for (std::uint64_t k = random.below(4); k > 0; --k) {
        Steps normal{};
        while (normal == Steps{})
          for (int& x : normal) x = static_cast<int>(random.below(3)) - 1;
        cone.inner.push_back(normal);
        const Rational scale = Rational(1 + random.below(5)) / Rational(7);
        exact.inner.push_back({scale * Rational(normal[0]), scale * Rational(normal[1]),
                               scale * Rational(normal[2])});
      }
      small.push_back(cone);
      cones.push_back(exact);
    }
    const int expected = slow_regular_value(small);
    EXPECT_EQ(regular_value(cones), expected) << "seed " << kSeed << " trial " << trial;
    negative += expected < 0 ? 1 : 0;
    zero += expected == 0 ? 1 : 0;
  }
  EXPECT_GT(negative, 20);
  EXPECT_GT(zero, 2);
}

TEST(RegularValue, OfManyPlanesIsNotComputed) {
  LocalCone cone{1, {}};
  for (int i = 0; i < 49; ++i) cone.inner.push_back({1, i, i * i});
  EXPECT_EQ(regular_value({cone}), std::nullopt);
  cone.inner.pop_back();
  EXPECT_EQ(regular_value({cone}), 1);
}

// A wall alone: two cones with opposite coefficients cover the space, and both contain the plane between them.
TEST(RegularValue, IsZeroWhereOnlyWallsHaveValues) {
  EXPECT_EQ(regular_value({{1, {{0, 0, 1}}}, {1, {{0, 0, -1}}}, {-1, {}}}), 0);
  EXPECT_EQ(regular_value({{1, {{0, 0, 1}}}, {1, {{0, 0, -1}}}}), 2);
  EXPECT_EQ(regular_value({}), 0);
}

}  // namespace
}  // namespace veritope::internal
