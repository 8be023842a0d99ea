// SPDX-License-Identifier: LGPL-3.0-or-later
#include "predicates/session.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/predicates/point_generators.h"
#include "tests/predicates/test_scale.h"
#include "tests/predicates/tier_test.h"

namespace veritope {
namespace {

using generate::Kind;
using generate::xy;

TEST(Session, DecidesAsThePredicatesDo) {
  const Session3d space({-1, -1, -1}, {1, 1, 1});
  const Vec3d o{0, 0, 0}, x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1}, c{0.25, 0.25, 0.25};
  expect_decided_by(Tier::kFilter, Sign::kPositive,
                    [&](TierCounts* t) { return space.orient3d(o, x, y, z, t); });
  expect_decided_by(Tier::kLattice, Sign::kZero, [&](TierCounts* t) {
    return space.orient3d(o, x, y, {0.5, 0.5, 0}, t);
  });
  expect_decided_by(Tier::kFilter, Sign::kPositive,
                    [&](TierCounts* t) { return space.in_sphere(o, x, y, z, c, t); });
  expect_decided_by(Tier::kLattice, Sign::kZero, [&](TierCounts* t) {
    return space.in_sphere(o, x, y, z, {1, 1, 1}, t);
  });
  const Session2d plane({-1, -1}, {1, 1});
  expect_decided_by(Tier::kFilter, Sign::kPositive, [&](TierCounts* t) {
    return plane.orient2d({0, 0}, {1, 0}, {0, 1}, t);
  });
  expect_decided_by(Tier::kLattice, Sign::kZero, [&](TierCounts* t) {
    return plane.orient2d({0, 0}, {1, 0}, {0.5, 0}, t);
  });
  expect_decided_by(Tier::kFilter, Sign::kPositive, [&](TierCounts* t) {
    return plane.in_circle({0, 0}, {1, 0}, {0, 1}, {0.5, 0.5}, t);
  });
  expect_decided_by(Tier::kLattice, Sign::kZero, [&](TierCounts* t) {
    return plane.in_circle({0, 0}, {1, 0}, {0, 1}, {1, 1}, t);
  });
}

TEST(Session, SignsAreThoseOfThePredicatesForEveryKindOfPoints) {
  const std::uint64_t seed = 20261121;
  Random random(seed);
  for (int kind = 0; kind < generate::kNumKinds; ++kind) {
    for (int i = 0; i < 400; ++i) {
      const generate::Points p = generate::points(static_cast<Kind>(kind), random);
      const std::array<Vec2d, 5> q{xy(p[0]), xy(p[1]), xy(p[2]), xy(p[3]), xy(p[4])};
      const Session3d space = Session3d::around(p.data(), p.size());
      const Session2d plane = Session2d::around(q.data(), q.size());
      SCOPED_TRACE(std::string(generate::kKindNames[kind]) + " seed " + std::to_string(seed) +
                   " number " + std::to_string(i));
      for (const Vec3d& v : p) ASSERT_TRUE(space.contains(v));
      for (const Vec2d& v : q) ASSERT_TRUE(plane.contains(v));
      ASSERT_EQ(space.orient3d(p[0], p[1], p[2], p[3]), orient3d(p[0], p[1], p[2], p[3]));
      ASSERT_EQ(space.in_sphere(p[0], p[1], p[2], p[3], p[4]),
                in_sphere(p[0], p[1], p[2], p[3], p[4]));
      ASSERT_EQ(plane.orient2d(q[0], q[1], q[2]), orient2d(q[0], q[1], q[2]));
      ASSERT_EQ(plane.in_circle(q[0], q[1], q[2], q[3]), in_circle(q[0], q[1], q[2], q[3]));
    }
  }
}

// What session.cc rests on: no error grows when differences shrink, rounding included.
TEST(Session, ErrorsGrowWithTheDifferences) {
  Random random(7);
  const auto large = [&] {
    return std::ldexp(random.unit(), static_cast<int>(random.between(-1070, 500)));
  };
  for (int i = 0; i < 20000; ++i) {
    const double x = large(), y = large(), z = large();
    std::array<double, 12> d;
    for (int k = 0; k < 12; ++k) {
      const double limit = k % 3 == 0 ? x : (k % 3 == 1 ? y : z);
      d[k] = std::min(limit, limit * random.unit()) * (random.below(2) == 0 ? 1 : -1);
      if (random.below(4) == 0) d[k] = limit;
    }
    constexpr double kFloor = kFilterFloor;
    EXPECT_LE(internal::orient2d_error(formulas::Orient2d<FilterReal>(0, 0, d[0], d[1], d[3], d[4]),
                                       kFloor),
              internal::orient2d_error(formulas::Orient2d<FilterReal>(0, 0, x, y, x, y), kFloor));
    EXPECT_LE(
        internal::in_circle_error(
            formulas::InCircle<FilterReal>(d[0], d[1], d[3], d[4], d[6], d[7], 0, 0), kFloor),
        internal::in_circle_error(formulas::InCircle<FilterReal>(x, y, x, y, x, y, 0, 0), kFloor));
    const formulas::Plane3<FilterReal> plane(0, 0, 0, d[0], d[1], d[2], d[3], d[4], d[5]),
        most(0, 0, 0, x, y, z, x, y, z);
    EXPECT_LE(internal::orient3d_error(plane, d[6], d[7], d[8], kFloor),
              internal::orient3d_error(most, x, y, z, kFloor));
    const double sphere =
        internal::in_sphere_error(std::abs(d[0]), std::abs(d[1]), std::abs(d[2]), kFloor);
    EXPECT_FALSE(sphere >
                 internal::in_sphere_error(x, y, z, kFloor));  // both may be NaN after overflow
  }
}

TEST(Session, ItsBoxIsClosed) {
  const Session3d space({-1, -2, -3}, {1, 2, 3});
  const Session2d plane({-1, -2}, {1, 2});
  for (const double s : {-1.0, 1.0}) {
    EXPECT_TRUE(space.contains({s, 2 * s, 3 * s}));
    EXPECT_TRUE(plane.contains({s, 2 * s}));
    EXPECT_FALSE(space.contains({1.5 * s, 0, 0}));
    EXPECT_FALSE(space.contains({0, 2.5 * s, 0}));
    EXPECT_FALSE(space.contains({0, 0, 3.5 * s}));
    EXPECT_FALSE(plane.contains({1.5 * s, 0}));
    EXPECT_FALSE(plane.contains({0, 2.5 * s}));
  }
}

TEST(Session, ABoxUpsideDownIsRefused) {
  EXPECT_THROW(Session2d({0, 1}, {1, 0}), InternalError);
  EXPECT_THROW(Session3d({0, 0, 1}, {1, 1, 0}), InternalError);
  EXPECT_THROW(Session3d({0, 0, 0}, {1, std::numeric_limits<double>::quiet_NaN(), 1}),
               InternalError);
}

TEST(Session, OfNoPointsIsThatOfTheOrigin) {
  EXPECT_TRUE(Session2d::around(nullptr, 0).contains({0, 0}));
  EXPECT_FALSE(Session3d::around(nullptr, 0).contains({0, 0, 1}));
}

#if defined(VERITOPE_SLOW_CHECKS) || !defined(NDEBUG)
TEST(Session, PointsOutsideOfTheBoxAreNoticedBySlowChecks) {
  const Session3d space({0, 0, 0}, {1, 1, 1});
  EXPECT_THROW(space.orient3d({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 2}), InternalError);
  EXPECT_THROW(Session2d({0, 0}, {1, 1}).orient2d({0, 0}, {1, 0}, {0, -1}), InternalError);
}
#endif

}  // namespace
}  // namespace veritope
