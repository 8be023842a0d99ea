// SPDX-License-Identifier: LGPL-3.0-or-later
// tests/solids/dms_similarity_test.cc: coordinates of approximately 1, and back.
#include "solids/dms/dms_similarity.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/support/random_dms.h"

namespace veritope {
namespace {

TEST(DmsSimilarity, BringsPointsNearTheOriginAndBack) {
  for (std::uint64_t seed = 0; seed < 500; ++seed) {
    Random random(seed);
    const Rational size = Rational::power_of_two(random.between(-1200, 1200)),
                   far = size * Rational::power_of_two(random.between(-4, 80));
    std::vector<DmsPoint> points(static_cast<std::size_t>(random.between(1, 5)));
    for (DmsPoint& p : points)
      for (Rational& x : p)
        x = far * Rational(random.between(-1, 1)) +
            size * Rational(random.between(-99, 99)) / Rational(7);
    const DmsSimilarity units = similarity_of(points);
    Rational longest;
    for (std::size_t c = 0; c < 3; ++c) {
      Rational low = units.to_unit(points[0])[c], high = low;
      for (const DmsPoint& p : points) {
        const DmsPoint u = units.to_unit(p);
        ASSERT_EQ(units.from_unit(u), p) << seed;
        low = std::min(low, u[c]), high = std::max(high, u[c]);
      }
      longest = std::max(longest, high - low);
      if (units.is_identity()) continue;
      EXPECT_LE(abs(low), Rational(4)) << seed;
      EXPECT_LE(abs(high), Rational(4)) << seed;
    }
    if (units.is_identity()) continue;
    EXPECT_GT(longest, Rational(1)) << seed;
    EXPECT_LT(longest, Rational(4)) << seed;
    const DmsPlane plane{{Rational(random.between(1, 5)), 2, -1}, Rational(random.between(-9, 9))};
    const DmsPlane moved = units.to_unit(plane);
    for (const DmsPoint& p : points)
      EXPECT_EQ((dot_product(plane.vector, p) - plane.number).sign(),
                (dot_product(moved.vector, units.to_unit(p)) - moved.number).sign())
          << seed;
  }
}

TEST(DmsSimilarity, LeavesModerateCoordinatesAlone) {
  EXPECT_TRUE(similarity_of(std::vector<DmsPoint>{{0, 0, 0}, {1, 2, 3}}).is_identity());
  EXPECT_TRUE(similarity_of(std::vector<DmsPoint>{{-900, 0, 0}, {1000, 2, 3}}).is_identity());
  EXPECT_TRUE(similarity_of(std::vector<DmsPoint>{{7, 7, 7}}).is_identity());
  EXPECT_FALSE(similarity_of(std::vector<DmsPoint>{{100, 0, 0}, {101, 1, 1}}).is_identity());
}

TEST(DmsSimilarity, RoundsUp) {
  EXPECT_EQ(scaled_up(3, 5), 96);
  EXPECT_EQ(scaled_up(0, -5000), 0);
  EXPECT_EQ(scaled_up(1, -5000), std::numeric_limits<double>::denorm_min());
  EXPECT_EQ(scaled_up(1, 5000), HUGE_VAL);
  EXPECT_EQ(scaled_up(0x1.8p-1074 * 2, -1), std::numeric_limits<double>::denorm_min() * 2);
  EXPECT_EQ(scaled_up(0x1p-1000, 900), 0x1p-100);
}

TEST(DmsSimilarity, ExponentsEncloseNumbers) {
  for (std::uint64_t seed = 0; seed < 500; ++seed) {
    Random random(seed);
    const Rational x = Rational(random.between(1, 999)) / Rational(random.between(1, 999)) *
                       Rational::power_of_two(random.between(-90, 90));
    const std::int64_t e = exponent_of(-x);
    EXPECT_LT(Rational::power_of_two(e), x) << seed;
    EXPECT_LT(x, Rational::power_of_two(e + 2)) << seed;
  }
}

}  // namespace
}  // namespace veritope
