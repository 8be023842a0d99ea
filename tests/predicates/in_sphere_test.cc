// SPDX-License-Identifier: LGPL-3.0-or-later
#include "predicates/in_sphere.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "predicates/orient3d.h"
#include "predicates/session.h"
#include "robust/base/random.h"
#include "tests/predicates/tier_test.h"

namespace veritope {
namespace {

using internal::in_sphere_exact;
using internal::in_sphere_interval;
using internal::in_sphere_lattice;

// On the unit sphere, positively oriented.
const Vec3d kA{-1, 0, 0}, kB{1, 0, 0}, kC{0, 1, 0}, kD{0, 0, 1};

TEST(InSphere, IsPositiveInsideZeroOnAndNegativeOutsideOfAPositiveTetrahedron) {
  ASSERT_EQ(orient3d(kA, kB, kC, kD), Sign::kPositive);
  EXPECT_EQ(in_sphere(kA, kB, kC, kD, {0, 0, 0}), Sign::kPositive);
  EXPECT_EQ(in_sphere(kA, kB, kC, kD, {0, 0, -1}), Sign::kZero);
  EXPECT_EQ(in_sphere(kA, kB, kC, kD, {0, 0, -2}), Sign::kNegative);
  EXPECT_EQ(in_sphere(kB, kA, kC, kD, {0, 0, 0}), Sign::kNegative);
}

TEST(InSphere, IsZeroForCoplanarPointsOnOneCircleAndForEqualPoints) {
  EXPECT_EQ(in_sphere(kA, kB, kC, {0, -1, 0}, {5, 5, 5}), Sign::kZero);
  EXPECT_EQ(in_sphere(kA, kA, kC, kD, {5, 4, 3}), Sign::kZero);
}

TEST(InSphere, SeesOneUnitInTheLastPlace) {
  const Vec3d a{-9, 0, 0}, b{9, 0, 0}, c{0, 9, 0}, d{0, 0, 9};
  EXPECT_EQ(in_sphere(a, b, c, d, {1, 4, -8}), Sign::kZero);
  EXPECT_EQ(in_sphere(a, b, c, d, {1, 4, -0x1.0000000000001p3}), Sign::kNegative);
  EXPECT_EQ(in_sphere(a, b, c, d, {1, 4, -0x1.fffffffffffffp2}), Sign::kPositive);
}

TEST(InSphere, IsExactWhereProductsUnderflowAndOverflow) {
  for (const double r : {5e-324, 0x1p-300, 0x1p400, 0x1.fffffffffffffp1023}) {
    const Vec3d a{-r, 0, 0}, b{r, 0, 0}, c{0, r, 0}, d{0, 0, r};
    EXPECT_EQ(in_sphere(a, b, c, d, {0, 0, 0}), Sign::kPositive);
    EXPECT_EQ(in_sphere(a, b, c, d, {0, 0, -r}), Sign::kZero);
    EXPECT_EQ(in_sphere(a, b, c, d, {0, 5e-324, -r}), Sign::kNegative);
  }
}

TEST(InSphere, IsNotMisledByAMinorThatUnderflowsAndIsThenMadeLarge) {
  // The points of in_circle's test in the plane z = 0, and one above it: the minors are multiplied
  // by its z = 1.
  const Vec3d a{0.6, 0x1.43d136248490fp500, 0}, b{0.4, 0x1p500, 0}, c{0, 5e-324, 0}, d{0, 0, 1},
      e{0, 0, 0};
  EXPECT_EQ(in_sphere_filter(a, b, c, d, e), Sign3::kUncertain);
  EXPECT_EQ(in_sphere(a, b, c, d, e), Sign::kPositive);
  const double r = 0x1p-195;
  EXPECT_EQ(in_sphere_filter({-r, 0, 0}, {r, 0, 0}, {0, r, 0}, {0, 0, r}, e), Sign3::kUncertain);
}

// The parts of the determinant overflow although the product of the largest differences does not.
TEST(InSphere, IsExactWhereOnlyPartsOfTheDeterminantOverflow) {
  const Vec3d a{-0x1.6p+204, -0x1.cp+203, 0x1.cp+203}, b{0x1.4p+204, -0x1.4p+204, 0x1.4p+203},
      c{-0x1p+203, -0x1p+203, -0x1.8p+204}, d{-0x1.cp+203, -0x1.4p+204, -0x1p+204}, e{0, 0, 0};
  EXPECT_EQ(in_sphere_filter(a, b, c, d, e), Sign3::kUncertain);
  EXPECT_EQ(in_sphere(a, b, c, d, e), Sign::kNegative);
  EXPECT_EQ(in_sphere(b, a, c, d, e), Sign::kPositive);
  const Vec3d p[] = {{0x1.5931634c3b21dp+204, 0x1.5d6cc55285a14p+204, 0x1.39b2fd5897cacp+201},
                     {0x1.36c7f5a279f2cp+204, 0x1.49a1f3afad5a7p+204, 0x1.3ccee0c837195p+204},
                     {0x1.893f0948581a5p+200, 0x1.3c980c1245b69p+204, 0x1.32657cb49e28ep+204},
                     {0x1.6c09ad7408b73p+204, 0x1.2a82b52fd86bfp+200, 0x1.3b012e8842838p+204},
                     {0, 0, 0}};
  EXPECT_EQ(Session3d::around(p, 5).in_sphere(p[0], p[1], p[2], p[3], p[4]), Sign::kPositive);
}

TEST(InSphere, IsExactForRandomPointsWhereTheDeterminantOverflows) {
  const std::uint64_t seed = 204;
  Random random(seed);
  for (int i = 0; i < 20000; ++i) {
    std::array<Vec3d, 5> p{};
    for (int k = 0; k < 4; ++k) {
      const auto draw = [&] { return std::ldexp(2 * random.unit() - 1, 205); };
      p[k] = {draw(), draw(), draw()};
    }
    const Sign expected = in_sphere_exact(p[0], p[1], p[2], p[3], p[4]);
    SCOPED_TRACE("seed " + std::to_string(seed) + " number " + std::to_string(i));
    ASSERT_EQ(in_sphere(p[0], p[1], p[2], p[3], p[4]), expected);
    const Session3d session = Session3d::around(p.data(), p.size());
    ASSERT_EQ(session.in_sphere(p[0], p[1], p[2], p[3], p[4]), expected);
  }
}

TEST(InSphere, AsksEachTierOnlyAfterTheOneBefore) {
  const auto decide = [](double r, Vec3d e) {
    return [=](TierCounts* tally) {
      return in_sphere({-r, 0, 0}, {r, 0, 0}, {0, r, 0}, {0, 0, r}, e, tally);
    };
  };
  expect_decided_by(Tier::kFilter, Sign::kPositive, decide(1, {0, 0, 0}));
  expect_decided_by(Tier::kLattice, Sign::kZero, decide(1, {0, 0, -1}));
  expect_decided_by(Tier::kInterval, Sign::kPositive, decide(0x1p-182, {0x1p-330, 0, 0}));
  expect_decided_by(Tier::kLattice, Sign::kNegative, decide(1, {0x1p-70, 0, -1}));
  expect_decided_by(Tier::kExact, Sign::kNegative, decide(1, {0x1p-700, 0, -1}));
}

TEST(InSphere, TiersSayUncertainRatherThanGuess) {
  EXPECT_EQ(in_sphere_filter(kA, kB, kC, kD, {0, 0, -1}), Sign3::kUncertain);
  const double huge = 0x1p260;
  EXPECT_EQ(in_sphere_filter({-huge, 0, 0}, {huge, 0, 0}, {0, huge, 0}, {0, 0, huge}, {0, 0, 0}),
            Sign3::kUncertain);
  EXPECT_EQ(in_sphere_lattice(kA, kB, kC, kD, {0x1p-125, 0, 0}), Sign3::kUncertain);
  EXPECT_EQ(in_sphere_interval({0.1, 0.2, 0.3}, {-0.1, 0.2, 0.3}, {0.1, -0.2, 0.3},
                               {0.1, 0.2, -0.3}, {-0.1, -0.2, -0.3}),
            Sign3::kUncertain);
}

TEST(InSphere, IsZeroForCornersOfABoxAndForEqualPointsWhateverTheirExponents) {
  const double x[] = {0x1p-900, 0.1}, y[] = {1e300, 0.7}, z[] = {5e-324, -3};
  for (int i = 0; i < 8 * 8 * 8; ++i) {
    const auto corner = [&](int k) { return Vec3d{x[k & 1], y[k >> 1 & 1], z[k >> 2 & 1]}; };
    const Vec3d a = corner(i), b = corner(i >> 3), c = corner(i >> 6), d = corner(5), e = corner(2);
    ASSERT_EQ(in_sphere_lattice(a, b, c, d, e), Sign3::kZero);
    ASSERT_EQ(in_sphere_exact(a, b, c, d, e), Sign::kZero);
  }
  const Vec3d far{0.3, 1e-300, 7};
  EXPECT_EQ(in_sphere_lattice(kA, far, kC, far, kD), Sign3::kZero);
  // A third value on one axis: no box.
  EXPECT_EQ(in_sphere({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 0.5}), Sign::kPositive);
  EXPECT_EQ(in_sphere({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}), Sign::kZero);
}

TEST(InSphere, WideLatticeAndIntegersAgree) {
  EXPECT_EQ(in_sphere_exact(kA, kB, kC, kD, {0x1p-70, 0, 0}), Sign::kPositive);
  EXPECT_EQ(in_sphere_exact(kA, kB, kC, kD, {0x1p-700, 0, -1}), Sign::kNegative);
}

}  // namespace
}  // namespace veritope
