// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/polyhedron/normal_along.h"

#include <gtest/gtest.h>

#include "tests/predicates/point_generators.h"
#include "tests/predicates/test_scale.h"
#include "tests/support/exact_geometry.h"

namespace veritope {
namespace {

using Direction = std::array<std::int32_t, 3>;

Sign exact_sign(const Vec3d& a, const Vec3d& b, const Vec3d& c, const Direction& d) {
  const oracle::RTriangle t{oracle::rational(a), oracle::rational(b), oracle::rational(c)};
  return oracle::dot(oracle::normal_of(t), {Rational(d[0]), Rational(d[1]), Rational(d[2])}).sign();
}

std::string text(const Vec3d& a, const Vec3d& b, const Vec3d& c, const Direction& d) {
  return generate::text({a, b, c, {}, {}}) + "{" + std::to_string(d[0]) + ", " + std::to_string(d[1]) + ", " +
         std::to_string(d[2]) + "}";
}

TEST(NormalAlong, NeverContradictsTheExactSign) {
  constexpr std::int32_t kMost = 2147483647;
  std::array<long, generate::kNumKinds> certain{};
  const long loops = scaled(1500);
  for (int kind = 0; kind < generate::kNumKinds; ++kind)
    for (long i = 0; i < loops; ++i) {
      Random random(static_cast<std::uint64_t>(i) * generate::kNumKinds + static_cast<std::uint64_t>(kind));
      const auto p = generate::points(static_cast<generate::Kind>(kind), random);
      const auto component = [&]() -> std::int32_t {
        switch (random.below(4)) {
          case 0: return static_cast<std::int32_t>(random.between(-1, 1));
          case 1: return static_cast<std::int32_t>(random.between(-1023, 1023));
          case 2: return random.below(2) == 0 ? kMost : -kMost;
          default: return static_cast<std::int32_t>(random.between(-kMost, kMost));
        }
      };
      const std::int32_t x = component(), y = component(), z = component();
      const Direction d{x, y, z};
      const Sign3 got = FacetNormal(p[0], p[1], p[2]).sign_along(d);
      if (!is_certain(got)) continue;
      ++certain[static_cast<std::size_t>(kind)];
      ASSERT_EQ(to_sign(got), exact_sign(p[0], p[1], p[2], d)) << generate::kKindNames[kind] << ": " << text(p[0], p[1], p[2], d);
    }
  EXPECT_GT(certain[0], loops * 9 / 10) << "generic facets should be decided";
}

TEST(NormalAlong, NearlyPerpendicularDirectionsAreNotGuessed) {
  // n is nearly perpendicular to d: the last bits decide.
  long certain = 0;
  for (std::uint64_t seed = 1; seed <= static_cast<std::uint64_t>(scaled(3000)); ++seed) {
    Random random(seed);
    const Direction d{static_cast<std::int32_t>(random.between(-1023, 1023)),
                      static_cast<std::int32_t>(random.between(-1023, 1023)), 1023};
    const auto along = [&] {  // a point of the plane d.x = 0, rounded
      const double x = random.unit(), y = random.unit();
      return Vec3d{x, y, generate::nudged(-(d[0] * x + d[1] * y) / d[2], random)};
    };
    const Vec3d a = along(), b = along(), m = {d[0] + 0.0, d[1] + 0.0, 1023.0};
    const double t = random.unit();
    const double off = std::ldexp(static_cast<double>(random.between(-8, 8)), -static_cast<int>(random.between(20, 50)));
    const Vec3d c{a.x + t * m.x + off, a.y + t * m.y, a.z + t * m.z};  // the facet nearly contains d
    const Sign3 got = FacetNormal(a, b, c).sign_along(d);
    if (!is_certain(got)) continue;
    ++certain;
    ASSERT_EQ(to_sign(got), exact_sign(a, b, c, d)) << "seed " << seed << ": " << text(a, b, c, d);
  }
  EXPECT_GT(certain, scaled(300));
  EXPECT_LT(certain, scaled(2700));
}

TEST(NormalAlong, OverflowAndUnderflowAreUncertain) {
  constexpr double kHuge = 0x1.fffffffffffffp1023, kTiny = 0x1p-1074;
  EXPECT_EQ(FacetNormal({-kHuge, 0, 0}, {kHuge, 0, 0}, {0, kHuge, 0}).sign_along({0, 0, 1}), Sign3::kUncertain);
  EXPECT_EQ(FacetNormal({0, 0, 0}, {0x1p600, 0, 0}, {0, 0x1p600, 0}).sign_along({0, 0, 1}), Sign3::kUncertain);
  EXPECT_EQ(FacetNormal({0, 0, 0}, {kTiny, 0, 0}, {0, kTiny, 0}).sign_along({0, 0, 1}), Sign3::kUncertain);
  EXPECT_EQ(FacetNormal({0, 0, 0}, {0x1p-490, 0, 0}, {0, 0x1p-490, 0}).sign_along({0, 0, 1}), Sign3::kUncertain);
  EXPECT_EQ(FacetNormal({0, 0, 0}, {1, 0, 0}, {2, 0, 0}).sign_along({1, 1, 1}), Sign3::kUncertain);
  EXPECT_EQ(FacetNormal({0, 0, 0}, {1, 0, 0}, {0, 1, 0}).sign_along({0, 0, 0}), Sign3::kUncertain);
}

TEST(NormalAlong, TurnsRoundWithTheFacetAndWithTheDirection) {
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    Random random(seed);
    const auto p = generate::points(generate::Kind::kGeneric, random);
    const Direction d{static_cast<std::int32_t>(random.between(-9, 9)), static_cast<std::int32_t>(random.between(-9, 9)), 1};
    const Sign3 s = FacetNormal(p[0], p[1], p[2]).sign_along(d);
    const Sign3 back = FacetNormal(p[0], p[2], p[1]).sign_along(d), away = FacetNormal(p[0], p[1], p[2]).sign_along({-d[0], -d[1], -d[2]});
    const Sign3 minus = is_certain(s) ? to_sign3(-to_sign(s)) : s;
    EXPECT_EQ(back, minus) << text(p[0], p[1], p[2], d);
    EXPECT_EQ(away, minus) << text(p[0], p[1], p[2], d);
  }
}

}  // namespace
}  // namespace veritope
