// SPDX-License-Identifier: LGPL-3.0-or-later
// Every predicate and every tier against homogeneous determinants over GMP's rationals.
#include <gtest/gtest.h>

#include "predicates/compare_along.h"
#include "predicates/in_circle.h"
#include "predicates/in_sphere.h"
#include "predicates/orient2d.h"
#include "predicates/orient3d.h"
#include "predicates/side_of_plane.h"
#include "tests/predicates/point_generators.h"
#include "tests/predicates/rational_oracle.h"
#include "tests/predicates/test_scale.h"

namespace veritope {
namespace {

using generate::Points;
using generate::xy;

// Runs `check(points)` on every kind of points; check returns the oracle's sign, so that zeros can
// be counted.
template <typename Check>
void on_all_kinds(long loops, Check check) {
  long zeros = 0, total = 0;
  for (int kind = 0; kind < generate::kNumKinds; ++kind) {
    Random random(1000u + static_cast<unsigned>(kind));
    for (long i = 0; i < scaled(loops); ++i) {
      const Points p = generate::points(static_cast<generate::Kind>(kind), random);
      zeros += check(p) == Sign::kZero ? 1 : 0;
      ++total;
      ASSERT_FALSE(testing::Test::HasFailure())
          << generate::kKindNames[kind] << ", seed " << 1000 + kind << ", case " << i << ": "
          << generate::text(p);
    }
  }
  EXPECT_GT(zeros, total / 10);
  EXPECT_LT(zeros, total * 9 / 10);
}

void expect_agrees(Sign3 tier, Sign oracle) {
  EXPECT_TRUE(!is_certain(tier) || to_sign(tier) == oracle) << to_int(oracle);
}

TEST(RationalDifferential, Orient2dAndItsTiersAgreeWithTheOracle) {
  on_all_kinds(15000, [](const Points& p) {
    const Vec2d a = xy(p[0]), b = xy(p[1]), c = xy(p[2]);
    const Sign s = oracle::orient2d(a, b, c);
    EXPECT_EQ(orient2d(a, b, c), s);
    expect_agrees(orient2d_filter(a, b, c), s);
    expect_agrees(internal::orient2d_zero_line(a, b, c), s);
    expect_agrees(internal::orient2d_lattice(a, b, c), s);
    expect_agrees(internal::orient2d_interval(a, b, c), s);
    EXPECT_EQ(internal::orient2d_exact(a, b, c), s);
    return s;
  });
}

TEST(RationalDifferential, Orient3dAndItsTiersAgreeWithTheOracle) {
  on_all_kinds(5000, [](const Points& p) {
    const Sign s = oracle::orient3d(p[0], p[1], p[2], p[3]);
    EXPECT_EQ(orient3d(p[0], p[1], p[2], p[3]), s);
    expect_agrees(orient3d_filter(p[0], p[1], p[2], p[3]), s);
    expect_agrees(internal::orient3d_lattice(p[0], p[1], p[2], p[3]), s);
    expect_agrees(internal::orient3d_interval(p[0], p[1], p[2], p[3]), s);
    EXPECT_EQ(internal::orient3d_exact(p[0], p[1], p[2], p[3]), s);
    return s;
  });
}

TEST(RationalDifferential, InCircleAndItsTiersAgreeWithTheOracle) {
  on_all_kinds(5000, [](const Points& p) {
    const Vec2d a = xy(p[0]), b = xy(p[1]), c = xy(p[2]), d = xy(p[3]);
    const Sign s = oracle::in_circle(a, b, c, d);
    EXPECT_EQ(in_circle(a, b, c, d), s);
    expect_agrees(in_circle_filter(a, b, c, d), s);
    expect_agrees(internal::in_circle_lattice(a, b, c, d), s);
    expect_agrees(internal::in_circle_interval(a, b, c, d), s);
    EXPECT_EQ(internal::in_circle_exact(a, b, c, d), s);
    return s;
  });
}

TEST(RationalDifferential, InSphereAndItsTiersAgreeWithTheOracle) {
  on_all_kinds(5000, [](const Points& p) {
    const Sign s = oracle::in_sphere(p[0], p[1], p[2], p[3], p[4]);
    EXPECT_EQ(in_sphere(p[0], p[1], p[2], p[3], p[4]), s);
    expect_agrees(in_sphere_filter(p[0], p[1], p[2], p[3], p[4]), s);
    expect_agrees(internal::in_sphere_lattice(p[0], p[1], p[2], p[3], p[4]), s);
    expect_agrees(internal::in_sphere_interval(p[0], p[1], p[2], p[3], p[4]), s);
    EXPECT_EQ(internal::in_sphere_exact(p[0], p[1], p[2], p[3], p[4]), s);
    return s;
  });
}

TEST(RationalDifferential, SideOfPlaneAndItsTiersAgreeWithTheOracle) {
  long turn = 0;
  on_all_kinds(15000, [&](const Points& p) {
    // Half of the offsets put the point on the plane, as nearly as doubles can.
    PlaneCoefficients f{p[0], p[2].x};
    const double value = -(p[0].x * p[1].x + p[0].y * p[1].y + p[0].z * p[1].z);
    if (++turn % 2 == 0 && std::isfinite(value)) f.offset = value;
    const Sign s = oracle::side_of_plane(f, p[1]);
    EXPECT_EQ(side_of_plane(f, p[1]), s);
    expect_agrees(side_of_plane_filter(f, p[1]), s);
    expect_agrees(internal::side_of_plane_lattice(f, p[1]), s);
    expect_agrees(internal::side_of_plane_interval(f, p[1]), s);
    EXPECT_EQ(internal::side_of_plane_exact(f, p[1]), s);
    return s;
  });
}

TEST(RationalDifferential, CompareAlongAndItsTiersAgreeWithTheOracle) {
  long turn = 0;
  on_all_kinds(15000, [&](const Points& p) {
    // Half of the directions are built to be at right angles with p - q.
    const Vec3d e{p[1].x - p[2].x, p[1].y - p[2].y, p[1].z - p[2].z};
    Vec3d d = p[0];
    if (++turn % 2 == 0 && std::isfinite(e.x) && std::isfinite(e.y)) d = {e.y, -e.x, 0};
    const Sign s = oracle::compare_along(d, p[1], p[2]);
    EXPECT_EQ(compare_along(d, p[1], p[2]), s);
    expect_agrees(compare_along_filter(d, p[1], p[2]), s);
    expect_agrees(internal::compare_along_lattice(d, p[1], p[2]), s);
    expect_agrees(internal::compare_along_interval(d, p[1], p[2]), s);
    EXPECT_EQ(internal::compare_along_exact(d, p[1], p[2]), s);
    return s;
  });
}

}  // namespace
}  // namespace veritope
