// SPDX-License-Identifier: LGPL-3.0-or-later
// The numbered laws of orient2d, orient3d, in_circle and in_sphere, as properties (RapidCheck) of
// points from all generators.
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <string>

#include "predicates/in_circle.h"
#include "predicates/in_sphere.h"
#include "predicates/orient2d.h"
#include "predicates/orient3d.h"
#include "tests/predicates/point_generators.h"

namespace veritope {
namespace {

using generate::Points;
using generate::xy;

// The seeds are fixed; set RC_PARAMS to try others.
[[maybe_unused]] const int kFixedSeed = setenv("RC_PARAMS", "seed=20240229 max_success=400", 0);

// RapidCheck chooses and shrinks the kind and the seed; the points follow from them.
Points drawn(int kind, std::uint32_t seed) {
  Random random(seed);
  return generate::points(static_cast<generate::Kind>(kind), random);
}
auto any_kind() { return rc::gen::inRange(0, generate::kNumKinds); }

bool holds(const std::string& law, std::function<void(const Points&, std::uint32_t)> check) {
  return rc::check(law, [&] {
    const int kind = *any_kind();
    const auto seed = *rc::gen::arbitrary<std::uint32_t>();
    const Points p = drawn(kind, seed);
    RC_LOG() << generate::kKindNames[kind] << ": " << generate::text(p);
    check(p, seed);
  });
}

// Moves all coordinates of an axis by one integer and scales them by a power of two; coordinates
// are small integers, so both are exact.
Points moved(const Points& grid, std::uint32_t seed, bool one_scale) {
  Random random(seed);
  std::array<double, 3> shift, scale;
  for (int i = 0; i < 3; ++i) {
    shift[i] = static_cast<double>(random.between(-(1 << 20), 1 << 20));
    scale[i] = std::ldexp(1, static_cast<int>(random.between(-1000, 900)));
    if (one_scale) scale[i] = scale[0];
  }
  Points out = grid;
  for (Vec3d& p : out) {
    p = {(p.x + shift[0]) * scale[0], (p.y + shift[1]) * scale[1], (p.z + shift[2]) * scale[2]};
  }
  return out;
}
Points small_grid(std::uint32_t seed) {
  return drawn(static_cast<int>(generate::Kind::kSmallGrid), seed);
}

TEST(OrientationLaws, PointsOnALineAlongAnAxisAreZeroAndOneStepOffItIsNot) {
  EXPECT_TRUE(holds("orient2d", [](const Points& p, std::uint32_t) {
    const Vec2d a = xy(p[0]), b = xy(p[1]), c = xy(p[2]);
    const Vec2d b_x{a.x, b.y}, c_x{a.x, c.y}, b_y{b.x, a.y}, c_y{c.x, a.y};
    RC_ASSERT(orient2d(a, b_x, c_x) == Sign::kZero);
    RC_ASSERT(orient2d(a, b_y, c_y) == Sign::kZero);
    RC_ASSERT(orient2d(a, a, c) == Sign::kZero && orient2d(c, a, a) == Sign::kZero);
    const double right = std::nextafter(a.x, HUGE_VAL), up = std::nextafter(a.y, HUGE_VAL);
    const Sign along_x = sign_of((b.x > a.x) - (b.x < a.x));
    const Sign along_y = sign_of((b.y > a.y) - (b.y < a.y));
    if (std::isfinite(up)) RC_ASSERT(orient2d(a, b_y, {c.x, up}) == along_x);
    if (std::isfinite(right)) RC_ASSERT(orient2d(a, b_x, {right, c.y}) == -along_y);
  }));
}

TEST(OrientationLaws, SwappingTwoPointsNegates) {
  EXPECT_TRUE(holds("orient2d", [](const Points& p, std::uint32_t) {
    const Vec2d a = xy(p[0]), b = xy(p[1]), c = xy(p[2]);
    const Sign s = orient2d(a, b, c);
    RC_ASSERT(orient2d(b, a, c) == -s);
    RC_ASSERT(orient2d(a, c, b) == -s);
    RC_ASSERT(orient2d(c, b, a) == -s);
    RC_ASSERT(orient2d(b, c, a) == s);
  }));
  EXPECT_TRUE(holds("orient3d", [](const Points& p, std::uint32_t) {
    const Sign s = orient3d(p[0], p[1], p[2], p[3]);
    for (int i = 0; i < 4; ++i) {
      for (int j = 0; j < i; ++j) {
        Points q = p;
        std::swap(q[i], q[j]);
        RC_ASSERT(orient3d(q[0], q[1], q[2], q[3]) == -s);
      }
    }
  }));
  EXPECT_TRUE(holds("in_circle", [](const Points& p, std::uint32_t) {
    const Sign s = in_circle(xy(p[0]), xy(p[1]), xy(p[2]), xy(p[3]));
    for (int i = 0; i < 4; ++i) {
      for (int j = 0; j < i; ++j) {
        Points q = p;
        std::swap(q[i], q[j]);
        RC_ASSERT(in_circle(xy(q[0]), xy(q[1]), xy(q[2]), xy(q[3])) == -s);
      }
    }
  }));
  EXPECT_TRUE(holds("in_sphere", [](const Points& p, std::uint32_t) {
    const Sign s = in_sphere(p[0], p[1], p[2], p[3], p[4]);
    for (int i = 0; i < 5; ++i) {
      for (int j = 0; j < i; ++j) {
        Points q = p;
        std::swap(q[i], q[j]);
        RC_ASSERT(in_sphere(q[0], q[1], q[2], q[3], q[4]) == -s);
      }
    }
  }));
}

TEST(OrientationLaws, MovingAllPointsExactlyAndScalingByPowersOfTwoKeepsTheSign) {
  EXPECT_TRUE(rc::check("orientations, each axis on its own scale", [] {
    const auto seed = *rc::gen::arbitrary<std::uint32_t>();
    const Points p = small_grid(seed), q = moved(p, seed + 1, false);
    RC_ASSERT(orient2d(xy(p[0]), xy(p[1]), xy(p[2])) == orient2d(xy(q[0]), xy(q[1]), xy(q[2])));
    RC_ASSERT(orient3d(p[0], p[1], p[2], p[3]) == orient3d(q[0], q[1], q[2], q[3]));
  }));
  EXPECT_TRUE(rc::check("circles and spheres, one scale", [] {
    const auto seed = *rc::gen::arbitrary<std::uint32_t>();
    const Points p = small_grid(seed), q = moved(p, seed + 1, true);
    RC_ASSERT(in_circle(xy(p[0]), xy(p[1]), xy(p[2]), xy(p[3])) ==
              in_circle(xy(q[0]), xy(q[1]), xy(q[2]), xy(q[3])));
    RC_ASSERT(in_sphere(p[0], p[1], p[2], p[3], p[4]) == in_sphere(q[0], q[1], q[2], q[3], q[4]));
  }));
}

TEST(OrientationLaws, TurningAndMirroringTheAxesActsAsADeterminant) {
  EXPECT_TRUE(holds("axes", [](const Points& p, std::uint32_t) {
    Points turned = p, mirrored = p;
    for (int i = 0; i < 5; ++i) turned[i] = {p[i].y, p[i].z, p[i].x}, mirrored[i].x = -p[i].x;
    RC_ASSERT(orient3d(turned[0], turned[1], turned[2], turned[3]) ==
              orient3d(p[0], p[1], p[2], p[3]));
    RC_ASSERT(orient3d(mirrored[0], mirrored[1], mirrored[2], mirrored[3]) ==
              -orient3d(p[0], p[1], p[2], p[3]));
    RC_ASSERT(in_sphere(mirrored[0], mirrored[1], mirrored[2], mirrored[3], mirrored[4]) ==
              -in_sphere(p[0], p[1], p[2], p[3], p[4]));
    RC_ASSERT(orient2d(xy(mirrored[0]), xy(mirrored[1]), xy(mirrored[2])) ==
              -orient2d(xy(p[0]), xy(p[1]), xy(p[2])));
  }));
}

TEST(OrientationLaws, ASphereSeenInAPlaneThroughTheOriginIsACircle) {
  // With d straight above the circle of a, b, c and on a sphere symmetric in z, in_sphere at z = 0
  // is in_circle.
  EXPECT_TRUE(rc::check("in_sphere extends in_circle", [] {
    const auto seed = *rc::gen::arbitrary<std::uint32_t>();
    const Points p = small_grid(seed);
    const Vec2d a = xy(p[0]), b = xy(p[1]), c = xy(p[2]), e = xy(p[3]);
    const Sign turn = orient2d(a, b, c);
    RC_PRE(turn != Sign::kZero);
    // (a, z = 1), (b, 1), (c, 1), (c, -1) lie on a sphere centred in z = 0; its circle in the plane
    // z = 1 is that of a, b, c.
    const Vec3d a1{a.x, a.y, 1}, b1{b.x, b.y, 1}, c1{c.x, c.y, 1}, d{c.x, c.y, -1}, e1{e.x, e.y, 1};
    RC_ASSERT(in_sphere(a1, b1, c1, d, e1) * orient3d(a1, b1, c1, d) ==
              in_circle(a, b, c, e) * turn);
  }));
}

}  // namespace
}  // namespace veritope
