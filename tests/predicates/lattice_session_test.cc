// SPDX-License-Identifier: LGPL-3.0-or-later
#include "predicates/lattice_session.h"

#include <gtest/gtest.h>

#include <cfenv>
#include <cmath>
#include <limits>
#include <string>

#include "predicates/in_circle.h"
#include "predicates/in_sphere.h"
#include "predicates/orient2d.h"
#include "predicates/orient3d.h"
#include "robust/base/check.h"
#include "robust/base/fp_guard.h"
#include "robust/base/random.h"
#include "tests/predicates/rational_oracle.h"
#include "tests/predicates/test_scale.h"
#include "tests/predicates/tier_test.h"

namespace veritope {
namespace {

using Space = std::vector<Vec3d>;
using Plane = std::vector<Vec2d>;

Plane xy(const Space& space) {
  Plane plane;
  for (const Vec3d& p : space) plane.push_back({p.x, p.y});
  return plane;
}

std::string text(const Space& points) {
  std::string out;
  for (const Vec3d& p : points) {
    char buffer[128];
    std::snprintf(buffer, sizeof buffer, "{%a, %a, %a}, ", p.x, p.y, p.z);
    out += buffer;
  }
  return out;
}

// Integers of up to `bits` bits, their axes times 2^scale[k]. Few values, so that many tuples are
// degenerate: each is one of `values` random ones; every other zero is -0.
Space grid(Random& random, int bits, std::array<int, 3> scale, int values) {
  const std::int64_t most = (std::int64_t{1} << bits) - 1;
  std::vector<std::int64_t> pool{0};
  while (pool.size() < static_cast<std::size_t>(values)) {
    pool.push_back(random.between(-most, most));
    pool.push_back(-pool.back());
  }
  const auto coordinate = [&](int k) {
    const std::int64_t m = pool[random.below(pool.size())];
    if (m == 0 && random.below(2) == 0) return -0.0;
    return std::ldexp(static_cast<double>(m), scale[k]);
  };
  Space space(9);
  for (Vec3d& p : space) p = {coordinate(0), coordinate(1), coordinate(2)};
  return space;
}

// All that the sessions of a model say, on random vertices, is what the predicates say.
void expect_the_signs_of_the_predicates(const Space& space, Random& random, bool lifted = true) {
  const Plane plane = xy(space);
  const auto s = LatticeSession3d::of(space.data(), space.size());
  const auto t = LatticeSession2d::of(plane.data(), plane.size());
  ASSERT_TRUE(s && t) << text(space);
  ASSERT_EQ(s->size(), space.size());
  ASSERT_EQ(t->size(), plane.size());
  for (int i = 0; i < 30; ++i) {
    std::array<std::size_t, 5> v;
    for (auto& index : v) index = random.below(space.size());
    const auto [a, b, c, d, e] = v;
    SCOPED_TRACE(text({space[a], space[b], space[c], space[d], space[e]}));
    ASSERT_EQ(s->orient3d(a, b, c, d), orient3d(space[a], space[b], space[c], space[d]));
    ASSERT_EQ(t->orient2d(a, b, c), orient2d(plane[a], plane[b], plane[c]));
    if (!lifted) continue;
    ASSERT_TRUE(s->has_spheres() && t->has_circles());
    ASSERT_EQ(s->in_sphere(a, b, c, d, e),
              in_sphere(space[a], space[b], space[c], space[d], space[e]));
    ASSERT_EQ(t->in_circle(a, b, c, d), in_circle(plane[a], plane[b], plane[c], plane[d]));
  }
}

TEST(LatticeSession, SignsAreThoseOfThePredicatesOnGridsOfEveryWidthAndScale) {
  const std::uint64_t seed = 20261121;
  Random random(seed);
  for (const int bits : {1, 2, 10, 26, 29, 30, 50, 53}) {
    for (const int scale : {0, -3, 40, 600, 960, -700, -1074}) {
      for (int i = 0; i < scaled(12); ++i) {
        SCOPED_TRACE("seed " + std::to_string(seed) + " bits " + std::to_string(bits) + " scale " +
                     std::to_string(scale) + " number " + std::to_string(i));
        expect_the_signs_of_the_predicates(
            grid(random, bits, {scale, scale, scale}, i % 2 == 0 ? 3 : 20), random);
      }
    }
  }
}

TEST(LatticeSession, EachAxisHasAScaleOfItsOwnForOrientations) {
  const std::uint64_t seed = 7;
  Random random(seed);
  for (const int bits : {2, 10, 26, 50}) {
    for (const auto& scale : {std::array{0, 900, -1000}, std::array{5, -5, 3}}) {
      for (int i = 0; i < scaled(10); ++i) {
        SCOPED_TRACE("seed " + std::to_string(seed) + " bits " + std::to_string(bits));
        const bool lifted = scale[0] == 5 && bits <= 50;
        expect_the_signs_of_the_predicates(grid(random, bits, scale, 9), random, lifted);
      }
    }
  }
}

// The oracle shares no line with the lattice.
TEST(LatticeSession, SignsAreThoseOfRationalDeterminants) {
  const std::uint64_t seed = 99;
  Random random(seed);
  for (int i = 0; i < scaled(200); ++i) {
    const Space p = grid(random, i % 3 == 0 ? 10 : (i % 3 == 1 ? 28 : 50), {-4, -4, -4}, 4);
    const Plane q = xy(p);
    const auto s = LatticeSession3d::of(p.data(), p.size());
    const auto t = LatticeSession2d::of(q.data(), q.size());
    ASSERT_TRUE(s && t);
    SCOPED_TRACE("seed " + std::to_string(seed) + " " + text(p));
    EXPECT_EQ(s->orient3d(0, 1, 2, 3), oracle::orient3d(p[0], p[1], p[2], p[3]));
    EXPECT_EQ(s->in_sphere(0, 1, 2, 3, 4), oracle::in_sphere(p[0], p[1], p[2], p[3], p[4]));
    EXPECT_EQ(t->orient2d(0, 1, 2), oracle::orient2d(q[0], q[1], q[2]));
    EXPECT_EQ(t->in_circle(0, 1, 2, 3), oracle::in_circle(q[0], q[1], q[2], q[3]));
  }
}

// Corners of boxes whose edges are the largest differences of each width, and near ones: what the
// static_asserts of fixed_formulas.h promise.
TEST(LatticeSession, DifferencesMayReachTheLimitOfTheirWidth) {
  const std::uint64_t seed = 3;
  Random random(seed);
  for (const int bits : {11, 30, 61}) {
    const double edge = std::ldexp(1, bits), step = bits == 61 ? 0x1p10 : 1;
    for (int i = 0; i < scaled(100); ++i) {
      Space space{{0, 0, 0}, {1, 1, 1}, {edge, edge, edge}, {0, 0, edge}};
      const auto corner = [&] {
        const double near = step * static_cast<double>(random.below(3));
        return random.below(2) == 0 ? near : edge - near;
      };
      while (space.size() < 9) space.push_back({corner(), corner(), corner()});
      SCOPED_TRACE("seed " + std::to_string(seed) + " bits " + std::to_string(bits));
      expect_the_signs_of_the_predicates(space, random);
    }
  }
}

TEST(LatticeSession, IsEmptyIffADifferenceExceedsTheLimitOfSomeAxis) {
  const auto fits = [](const Plane& plane) {
    Space space;
    for (const Vec2d& p : plane) space.push_back({0, p.x, p.y});
    const bool result = LatticeSession2d::of(plane.data(), plane.size()).has_value();
    EXPECT_EQ(LatticeSession3d::of(space.data(), space.size()).has_value(), result);
    return result;
  };
  constexpr double kLimit = 0x1p61;
  EXPECT_TRUE(fits({{0, 0}, {1, 0}, {kLimit, 0}}));
  EXPECT_FALSE(fits({{0, 0}, {1, 0}, {kLimit + 0x1p9, 0}}));
  EXPECT_TRUE(fits({{-0x1p60, 0}, {1, 0}, {0x1p60, 0}}));
  EXPECT_FALSE(fits({{-0x1p60, 0}, {1, 0}, {0x1p60 + 0x1p8, 0}}));
  EXPECT_TRUE(fits({{0, 1 + 0x1p-52}, {0, 0x1p8}}));
  EXPECT_FALSE(fits({{0, 1 + 0x1p-52}, {0, 0x1p20 + 0x1p-32}}));  // 53 bits, and 2^20 as large
  EXPECT_FALSE(fits({{0, 0x1p-1074}, {0, 1}}));
  // What counts is the unit of the differences, not of the coordinates.
  EXPECT_TRUE(fits({{1, 0}, {1 + 0x1p40, 0}, {1 + 0x1p30, 0}}));
  EXPECT_FALSE(fits({{0x1p1023, 0}, {-0x1p1023, 0}, {1, 0}}));
  EXPECT_TRUE(fits({{0x1p1023, 0}, {-0x1p1023, 0}, {0, 0}}));
  for (const double bad :
       {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()}) {
    EXPECT_FALSE(fits({{bad, 0}}));
    EXPECT_FALSE(fits({{0, 0}, {0, -bad}}));
  }
}

TEST(LatticeSession, OfOneOrNoPointDecidesThatAllIsZero) {
  EXPECT_EQ(LatticeSession2d::of(nullptr, 0)->size(), 0u);
  EXPECT_EQ(LatticeSession3d::of(nullptr, 0)->size(), 0u);
  const Vec2d p{-0x1.8p-1000, 0x1.fffffffffffffp1023};
  const Vec3d q{p.x, p.y, -0.0};
  const auto t = LatticeSession2d::of(&p, 1);
  const auto s = LatticeSession3d::of(&q, 1);
  ASSERT_TRUE(t && s);
  EXPECT_EQ(t->orient2d(0, 0, 0), Sign::kZero);
  EXPECT_EQ(t->in_circle(0, 0, 0, 0), Sign::kZero);
  EXPECT_EQ(s->orient3d(0, 0, 0, 0), Sign::kZero);
  EXPECT_EQ(s->in_sphere(0, 0, 0, 0, 0), Sign::kZero);
}

TEST(LatticeSession, WithoutALatticeInCommonThereAreNoCirclesAndSpheres) {
  const Space p{{0, 0, 0}, {1, 0, 0}, {0, 0x1p-61, 0}, {0, 0, 1}, {1, 0x1p-61, 1}};
  const Plane q = xy(p);
  const auto s = LatticeSession3d::of(p.data(), p.size());
  const auto t = LatticeSession2d::of(q.data(), q.size());
  ASSERT_TRUE(s && t);
  EXPECT_TRUE(s->has_spheres() && t->has_circles());
  EXPECT_EQ(s->in_sphere(0, 1, 2, 3, 4), Sign::kZero);  // corners of a box
  EXPECT_EQ(t->in_circle(0, 1, 2, 4), Sign::kZero);
  Space thin = p;
  for (Vec3d& v : thin) v.y /= 2;
  const Plane flat = xy(thin);
  const auto s2 = LatticeSession3d::of(thin.data(), thin.size());
  const auto t2 = LatticeSession2d::of(flat.data(), flat.size());
  ASSERT_TRUE(s2 && t2);
  EXPECT_FALSE(s2->has_spheres() || t2->has_circles());
  EXPECT_EQ(s2->orient3d(0, 1, 2, 3), Sign::kPositive);
  EXPECT_EQ(t2->orient2d(0, 1, 2), Sign::kPositive);
  EXPECT_THROW(s2->in_sphere(0, 1, 2, 3, 4), InternalError);
  EXPECT_THROW(t2->in_circle(0, 1, 2, 4), InternalError);
  // An axis on which nothing differs has no unit.
  const Space level{{0, 0, 0x1p-70}, {1, 0, 0x1p-70}, {0, 1, 0x1p-70}, {1, 1, 0x1p-70}};
  const auto s3 = LatticeSession3d::of(level.data(), level.size());
  ASSERT_TRUE(s3 && s3->has_spheres());
  EXPECT_EQ(s3->in_sphere(0, 1, 2, 3, 0), Sign::kZero);
}

// The tiers of orient2d, in_circle, orient3d, in_sphere on clear cases; degenerate ones leave the filter.
TEST(LatticeSession, AsksTheFilterWhereIntegersAreDear) {
  struct Case {
    double size;
    std::array<Tier, 4> tier;
  };
  constexpr Tier kFilter = Tier::kFilter, kLattice = Tier::kLattice;
  for (const auto& [size, tier] : {Case{0x1p11, {kLattice, kLattice, kLattice, kLattice}},
                                   Case{0x1p11 + 1, {kLattice, kLattice, kLattice, kFilter}},
                                   Case{0x1p30, {kLattice, kLattice, kLattice, kFilter}},
                                   Case{0x1p30 + 1, {kFilter, kFilter, kFilter, kFilter}}}) {
    SCOPED_TRACE(size);
    // The fifth point keeps the unit at 1, the last is a corner of the cube of the first four.
    const Space p{{0, 0, 0}, {size, 0, 0}, {0, size, 0}, {0, 0, size}, {1, 1, 1}, {size, size, 0}};
    const Plane q = xy(p);
    const auto s = LatticeSession3d::of(p.data(), p.size());
    const auto t = LatticeSession2d::of(q.data(), q.size());
    ASSERT_TRUE(s && t);
    expect_decided_by(tier[0], Sign::kPositive,
                      [&](TierCounts* tally) { return t->orient2d(0, 1, 2, tally); });
    expect_decided_by(tier[1], Sign::kPositive,
                      [&](TierCounts* tally) { return t->in_circle(0, 1, 2, 4, tally); });
    expect_decided_by(tier[2], Sign::kPositive,
                      [&](TierCounts* tally) { return s->orient3d(0, 1, 2, 3, tally); });
    expect_decided_by(tier[3], Sign::kPositive,
                      [&](TierCounts* tally) { return s->in_sphere(0, 1, 2, 3, 4, tally); });
    expect_decided_by(kLattice, Sign::kZero,
                      [&](TierCounts* tally) { return t->orient2d(0, 4, 5, tally); });
    expect_decided_by(kLattice, Sign::kZero,
                      [&](TierCounts* tally) { return t->in_circle(0, 1, 2, 5, tally); });
    expect_decided_by(kLattice, Sign::kZero,
                      [&](TierCounts* tally) { return s->orient3d(0, 1, 2, 5, tally); });
    expect_decided_by(kLattice, Sign::kZero,
                      [&](TierCounts* tally) { return s->in_sphere(0, 1, 2, 3, 5, tally); });
  }
}

TEST(LatticeSession, SwapsNegateAndMovedOrScaledModelsHaveTheSameSigns) {
  const std::uint64_t seed = 11;
  Random random(seed);
  for (int i = 0; i < scaled(150); ++i) {
    const Space p = grid(random, i % 3 == 0 ? 9 : (i % 3 == 1 ? 26 : 48), {0, 0, 0}, 5);
    Space moved = p;
    const Vec3d by{static_cast<double>(random.between(-1 << 20, 1 << 20)),
                   static_cast<double>(random.between(-1 << 20, 1 << 20)), 0x1p47};
    const double scale = std::ldexp(1, static_cast<int>(random.between(-800, 800)));
    for (Vec3d& v : moved) v = {(v.x + by.x) * scale, (v.y + by.y) * scale, (v.z + by.z) * scale};
    const auto s = LatticeSession3d::of(p.data(), p.size());
    const auto m = LatticeSession3d::of(moved.data(), moved.size());
    const Plane q = xy(p), moved_q = xy(moved);
    const auto t = LatticeSession2d::of(q.data(), q.size());
    const auto n = LatticeSession2d::of(moved_q.data(), moved_q.size());
    ASSERT_TRUE(s && m && t && n);
    SCOPED_TRACE("seed " + std::to_string(seed) + " " + text(p));
    EXPECT_EQ(s->orient3d(0, 1, 2, 3), -s->orient3d(1, 0, 2, 3));
    EXPECT_EQ(s->in_sphere(0, 1, 2, 3, 4), -s->in_sphere(0, 2, 1, 3, 4));
    EXPECT_EQ(t->orient2d(0, 1, 2), -t->orient2d(0, 2, 1));
    EXPECT_EQ(t->in_circle(0, 1, 2, 3), -t->in_circle(1, 0, 2, 3));
    EXPECT_EQ(s->orient3d(0, 1, 2, 3), m->orient3d(0, 1, 2, 3));
    EXPECT_EQ(s->in_sphere(0, 1, 2, 3, 4), m->in_sphere(0, 1, 2, 3, 4));
    EXPECT_EQ(t->orient2d(0, 1, 2), n->orient2d(0, 1, 2));
    EXPECT_EQ(t->in_circle(0, 1, 2, 3), n->in_circle(0, 1, 2, 3));
  }
}

// The coordinates are subnormal, and the rounding direction is another: the bits of the coordinates decide.
TEST(LatticeSession, IsMadeAndAskedInAnyFloatingPointEnvironment) {
  constexpr double kUnit = std::numeric_limits<double>::denorm_min(), kFar = 0x1.8p40 * kUnit;
  const Space p{{0, 0, 0}, {kFar, 0, 0}, {0, kFar, 0}, {0, 0, kFar}, {kUnit, kUnit, kUnit}};
  const int before = std::fegetround();
  for (const int direction : {FE_TONEAREST, FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO}) {
    ASSERT_EQ(std::fesetround(direction), 0);
    refresh_fp();
    const auto s = LatticeSession3d::of(p.data(), p.size());
    const bool has = s.has_value();
    const Sign orient = has ? s->orient3d(0, 1, 2, 4) : Sign::kZero;
    const Sign sphere = has ? s->in_sphere(0, 1, 2, 3, 4) : Sign::kZero;
    std::fesetround(before);
    refresh_fp();
    ASSERT_TRUE(has);
    EXPECT_EQ(orient, Sign::kPositive) << direction;
    EXPECT_EQ(sphere, Sign::kPositive) << direction;
  }
}

#if defined(VERITOPE_SLOW_CHECKS) || !defined(NDEBUG)
TEST(LatticeSession, IndicesThatDoNotExistAreNoticedBySlowChecks) {
  const Plane q{{0, 0}, {1, 0}, {0, 1}};
  EXPECT_THROW(LatticeSession2d::of(q.data(), q.size())->orient2d(0, 1, 3), InternalError);
}
#endif

}  // namespace
}  // namespace veritope
