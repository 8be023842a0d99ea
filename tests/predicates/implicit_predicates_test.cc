// SPDX-License-Identifier: LGPL-3.0-or-later
#include "predicates/implicit_predicates.h"

#include <gtest/gtest.h>

#include <map>

#include "predicates/in_circle.h"
#include "predicates/in_sphere.h"
#include "predicates/orient2d.h"
#include "predicates/orient3d.h"
#include "robust/base/check.h"
#include "tests/predicates/implicit_judge.h"
#include "tests/predicates/test_scale.h"
#include "tests/predicates/tier_test.h"

namespace veritope {
namespace {

const Vec3d kO{0, 0, 0}, kX{1, 0, 0}, kY{0, 1, 0}, kZ{0, 0, 1};

// ---- By hand -----------------------------------------------------------------------------------

TEST(WeightedPoints, LieWhereTheirWeightsSay) {
  const SegmentPoint third({0, 0, 0}, {1, 2, 3}, 1, 3);
  EXPECT_EQ(side_of_plane({{3, 0, 0}, -1}, third), Sign::kZero);
  EXPECT_EQ(side_of_plane({{0, 3, 0}, -2}, third), Sign::kZero);
  EXPECT_EQ(compare_z(third, Vec3d{9, 9, 1}), Sign::kZero);
  EXPECT_EQ(compare_x(third, Vec3d{0x1.5555555555555p-2, 0, 0}), Sign::kPositive);
  EXPECT_EQ(compare_x(third, Vec3d{0x1.5555555555556p-2, 0, 0}), Sign::kNegative);
  const TrianglePoint centre(kX, kY, kZ, 1, 1, 3);
  EXPECT_EQ(side_of_plane({{1, 1, 1}, -1}, centre), Sign::kZero);
  EXPECT_EQ(compare_x(centre, third), Sign::kZero);
  EXPECT_EQ(compare_lexicographic(centre, third), Sign::kNegative);
  EXPECT_TRUE(coincide(centre, TrianglePoint(kZ, kX, kY, -2, -2, -6)));
}

TEST(WeightedPoints, AreUndefinedForADenominatorOfZeroAndOnlyThen) {
  EXPECT_FALSE(SegmentPoint(kO, kX, 1, 0).is_defined());
  EXPECT_FALSE(SegmentPoint(kO, kX, 1, -0.0).is_defined());
  EXPECT_TRUE(SegmentPoint(kO, kX, 0, -0x1p-1074).is_defined());
  EXPECT_FALSE(TrianglePoint(kO, kX, kY, 1, 1, 0).is_defined());
  EXPECT_FALSE(SegmentPoint2d({0, 0}, {1, 0}, 1, 0).is_defined());
  EXPECT_FALSE(SegmentSegmentPoint2d({0, 0}, {1, 1}, {2, 0}, {3, 1}).is_defined());
  EXPECT_THROW(compare_x(SegmentPoint(kO, kX, 1, 0), kO), InternalError);
  EXPECT_THROW(compare_x(TrianglePoint(kO, kX, kY, 1, 1, 0), kO), InternalError);
  EXPECT_THROW(compare_x(LinePlanePoint(kO, kX, kO, kX, kY), kO), InternalError);
  EXPECT_THROW(compare_x(SegmentSegmentPoint2d({0, 0}, {1, 1}, {2, 0}, {3, 1}), Vec2d{0, 0}),
               InternalError);
  EXPECT_THROW(compare_axis(kO, kX, 3), InternalError);
  EXPECT_THROW(compare_axis(Vec2d{0, 0}, Vec2d{0, 0}, 2), InternalError);
  EXPECT_THROW(orient2d_projected(kO, kX, kY, -1), InternalError);
}

TEST(SegmentSegmentPoint2d, LiesWhereTheLinesMeet) {
  const SegmentSegmentPoint2d p({0, 0}, {1, 1}, {0, 1}, {1, 0}), q({0, 0}, {3, 1}, {1, 5}, {1, -7});
  EXPECT_TRUE(coincide(p, Vec2d{0.5, 0.5}));
  EXPECT_TRUE(coincide(q, SegmentPoint2d({1, 0}, {1, 1}, 1, 3)));
  EXPECT_EQ(p.denominator_sign(), Sign::kNegative);
  EXPECT_EQ(orient2d(p, q, Vec2d{0.75, 0.41}), orient2d({0.5, 0.5}, {1, 1 / 3.0}, {0.75, 0.41}));
  EXPECT_EQ(orient2d(p, SegmentPoint2d({0.5, 0.5}, {1, 1}, 1, 3), Vec2d{7, 7}), Sign::kZero);
  // The unit circle through (3/5, 4/5), which no doubles hold.
  const SegmentPoint2d r({0, 0}, {3, 4}, 1, 5);
  EXPECT_EQ(in_circle(Vec2d{1, 0}, Vec2d{0, 1}, Vec2d{-1, 0}, r), Sign::kZero);
  EXPECT_EQ(in_circle(Vec2d{1, 0}, Vec2d{0, 1}, r, Vec2d{0, 0}),
            Sign::kPositive * orient2d(Vec2d{1, 0}, Vec2d{0, 1}, r));
}

TEST(ImplicitInSphere, PointsOfASphereThatNoDoublesHold) {
  const SegmentPoint a(kO, {3, 4, 0}, 1, 5), b(kO, {0, -5, 12}, 1, 13);  // on the unit sphere
  const LinePlanePoint c({3, 0, -1}, {3, 0, 1}, kO, kX, kY);             // (3, 0, 0)
  EXPECT_EQ(in_sphere(kX, kY, a, b, Vec3d{0, 0, -1}), Sign::kZero);
  const Sign turn = orient3d(kX, kY, a, b);
  EXPECT_NE(turn, Sign::kZero);
  EXPECT_EQ(in_sphere(kX, kY, a, b, kO), turn);
  EXPECT_EQ(in_sphere(kX, kY, a, b, c), -turn);
}

TEST(ImplicitPredicates, TiersInTurn) {
  const LinePlanePoint near_x({0, 0, -1}, {0, 0, 1}, {-1, -1, 0}, {1, -1, 0},
                              {0, 1, 0});  // the origin
  const SegmentPoint half({-1, 0, 0}, {1, 0, 0}, 1, 2);
  expect_decided_by(Tier::kInterval, Sign::kNegative,
                    [&](TierCounts* t) { return compare_axis(near_x, kX, 0, t); });
  expect_decided_by(Tier::kExact, Sign::kZero, [&](TierCounts* t) {
    return orient3d(near_x, SegmentPoint({0.1, 0, 0}, {0.2, 0.3, 0.1}, 0.1, 0.7), half, kX, t);
  });
  expect_decided_by(Tier::kFilter, Sign::kPositive,
                    [&](TierCounts* t) { return orient3d(kO, kX, kY, kZ, t); });
  expect_decided_by(Tier::kFilter, orient3d(kX, kY, kZ, kO),
                    [&](TierCounts* t) { return orient3d(AnyPoint3(kX), kY, kZ, near_x, t); });
}

// ---- Laws ----------------------------------------------------------------------------------------

TEST(ImplicitPredicates, SwappingTwoPointsNegatesWhateverTheirKinds) {
  Random random(7);
  for (int i = 0; i < 60; ++i) {
    const auto definitions = generate::implicit_case(random, 3);
    std::vector<generate::Point3> p;
    bool exist = true;
    for (const auto& d : definitions) {
      p.push_back(generate::make3(d, i % 2 == 0));
      exist =
          exist && std::visit([](const auto& v) { return oracle::point(v).has_value(); }, p.back());
    }
    if (!exist) continue;
    const auto sphere = [&](std::array<int, 5> k) {
      using generate::any;
      return in_sphere(any(p[k[0]]), any(p[k[1]]), any(p[k[2]]), any(p[k[3]]), any(p[k[4]]));
    };
    const auto plane = [&](std::array<int, 4> k) {
      using generate::any;
      return orient3d(any(p[k[0]]), any(p[k[1]]), any(p[k[2]]), any(p[k[3]]));
    };
    for (int from = 0; from < 5; ++from) {
      for (int to = 0; to < from; ++to) {
        std::array<int, 5> k{0, 1, 2, 3, 4};
        std::swap(k[from], k[to]);
        EXPECT_EQ(sphere(k), -sphere({0, 1, 2, 3, 4})) << generate::text(definitions[0]);
        if (from == 4) continue;
        EXPECT_EQ(plane({k[0], k[1], k[2], k[3]}), -plane({0, 1, 2, 3}))
            << generate::text(definitions[0]);
      }
    }
  }
}

// ---- Random ----------------------------------------------------------------------------------------

void expect_exact_signs(int dimension, long loops) {
  const std::uint64_t seed = 20261123;
  Random random(seed);
  std::map<std::string, std::array<long, 3>> counts;
  TierCounts tally;
  for (long i = 0; i < loops; ++i) {
    std::string text;
    bool agrees = true;
    judge::ask(random, dimension, text, agrees, &tally, [&](const judge::Question& q) {
      EXPECT_EQ(to_int(q.found), q.expected)
          << q.name << ", seed " << seed << " number " << i << ": " << text;
      ++counts[q.name][static_cast<std::size_t>(q.expected + 1)];
    });
    ASSERT_TRUE(agrees) << "seed " << seed << " number " << i << ": " << text;
    ASSERT_FALSE(testing::Test::HasFailure());
  }
  for (const auto& [name, of] : counts) {
    for (const long n : of) EXPECT_GE(n, loops / 50) << name << ": the cases are too easy";
  }
  EXPECT_GT(tally[Tier::kInterval], 0u);
  EXPECT_GT(tally[Tier::kExact], 0u);
}

TEST(ImplicitPredicates, InSpaceSignsAreThoseOfTheRationalPoints) {
  expect_exact_signs(3, scaled(1500));
}
TEST(ImplicitPredicates, InThePlaneSignsAreThoseOfTheRationalPoints) {
  expect_exact_signs(2, scaled(3000));
}

}  // namespace
}  // namespace veritope
