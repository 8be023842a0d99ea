// SPDX-License-Identifier: LGPL-3.0-or-later
// The integer widths of predicates/fixed_formulas.h at their limits, beside GMP's integers.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>

#include "predicates/fixed_formulas.h"
#include "predicates/in_circle.h"
#include "predicates/in_sphere.h"
#include "predicates/orient2d.h"
#include "predicates/orient3d.h"
#include "robust/base/random.h"

namespace veritope {
namespace {

using internal::shorten;

TEST(Shorten, TakesOutTheCommonPowerOfTwoAndBoundsTheRest) {
  std::array<std::int64_t, 3> d{12, -40, 0};
  EXPECT_EQ(shorten(d), 4);
  EXPECT_EQ(d, (std::array<std::int64_t, 3>{3, -10, 0}));
  std::array<std::int64_t, 2> power{-(std::int64_t{1} << 61), 0};
  EXPECT_EQ(shorten(power), 0);
  EXPECT_EQ(power[0], -1);
  std::array<std::int64_t, 2> zero{0, 0};
  EXPECT_EQ(shorten(zero), 0);
  std::array<std::int64_t, 2> one{1, -2047};
  EXPECT_EQ(shorten(one), 11);
}

// Coordinates 0, 2^bits and their neighbours: the differences are as long as a width allows, or one
// bit longer.
double near_limit(Random& random, int bits) {
  const double limit = std::ldexp(1.0, bits);
  const double values[] = {0, 1, 3, limit, limit - 1, limit / 2, limit - 3};
  const double v = values[random.below(7)];
  return random.below(2) == 0 ? v : limit - v;
}

TEST(Widths, AgreeWithIntegersAtTheirLimits) {
  const std::uint64_t seed = 8;
  Random random(seed);
  for (const int bits : {9, 10, 11, 12, 28, 29, 30, 31, 50, 51, 52}) {
    for (int i = 0; i < 600; ++i) {
      std::array<Vec3d, 5> p;
      for (Vec3d& v : p)
        v = {near_limit(random, bits), near_limit(random, bits), near_limit(random, bits)};
      // Scaled to where the lattice is full, too.
      const double scale = std::ldexp(1.0, static_cast<int>(random.between(-60, 60)));
      for (Vec3d& v : p) v = {v.x * scale, v.y * scale, v.z * scale};
      const std::array<Vec2d, 4> q{Vec2d{p[0].x, p[0].y}, Vec2d{p[1].x, p[1].y},
                                   Vec2d{p[2].x, p[2].y}, Vec2d{p[3].x, p[3].y}};
      SCOPED_TRACE("seed " + std::to_string(seed) + " bits " + std::to_string(bits) + " number " +
                   std::to_string(i));
      ASSERT_EQ(internal::in_sphere_lattice(p[0], p[1], p[2], p[3], p[4]),
                to_sign3(internal::in_sphere_exact(p[0], p[1], p[2], p[3], p[4])));
      ASSERT_EQ(internal::orient3d_lattice(p[0], p[1], p[2], p[3]),
                to_sign3(internal::orient3d_exact(p[0], p[1], p[2], p[3])));
      ASSERT_EQ(internal::in_circle_lattice(q[0], q[1], q[2], q[3]),
                to_sign3(internal::in_circle_exact(q[0], q[1], q[2], q[3])));
      ASSERT_EQ(internal::orient2d_lattice(q[0], q[1], q[2]),
                to_sign3(internal::orient2d_exact(q[0], q[1], q[2])));
    }
  }
}

}  // namespace
}  // namespace veritope
