// SPDX-License-Identifier: LGPL-3.0-or-later
#include "robust/base/random.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>

namespace veritope {
namespace {

TEST(Random, GivesTheSameNumbersForTheSameSeedEverywhere) {
  Random a(1), b(1), c(2);
  EXPECT_EQ(a.next(), b.next());
  EXPECT_NE(a.next(), c.next());
  // From the reference implementations of splitmix64 and xoshiro256**, seed 0.
  static_assert(Random(0).next() == 0x99ec5f36cb75f2b4u);
}

TEST(Random, StaysInRangeAndReachesTheEnds) {
  Random random(5);
  std::array<int, 7> seen{};
  for (int i = 0; i < 1000; ++i) {
    ++seen[random.below(7)];
    const std::int64_t v = random.between(-2, 2);
    EXPECT_TRUE(v >= -2 && v <= 2);
    const double u = random.unit();
    EXPECT_TRUE(u >= 0 && u < 1);
  }
  for (const int n : seen) EXPECT_GT(n, 80);
  EXPECT_EQ(random.between(5, 5), 5);
  random.between(INT64_MIN, INT64_MAX);  // the whole range does not overflow
}

}  // namespace
}  // namespace veritope
