// SPDX-License-Identifier: LGPL-3.0-or-later
// tests/solids/fast_dms_test.cc: the bounds of fast evaluation of simplex-spline solids hold, by every way that a point
// can take; the experiment soak_dms_fast tries more models.
#include "solids/dms/fast/fast_dms.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/predicates/test_scale.h"
#include "tests/support/fast_dms_check.h"

namespace veritope {
namespace {

Rational ratio(long p, long q) { return Rational(p) / Rational(q); }

FastDmsOptions fast_options(double tolerance = 1e300) {
  FastDmsOptions options;
  options.with_gradient = true;
  options.exact_first = 0;
  options.tolerance = tolerance;
  return options;
}

// A cube of eight, clouds of a tenth of the edge; the identity, and the height as an attribute.
DmsModel clouded_cubes(int degree) {
  DmsModel domain = kuhn_domain({2, 2, 2});
  domain.attributes = {"height"};
  std::vector<Rational> heights;
  for (const DmsCloud& cloud : domain.clouds) heights.push_back(cloud[0][2]);
  set_control_by_rule(domain, DmsControlRule::kGreville, heights);
  return make_dms(domain, {degree, DmsCloudDraw{ratio(1, 10), 5}, DmsControlRule::kGreville})
      .value();
}

void expect_bounds(std::uint64_t first, long models, int degree, double tolerance) {
  double greatest = 0;
  FastDmsCounts sum;
  for (std::uint64_t i = 0; i < static_cast<std::uint64_t>(scaled(models)); ++i) {
    const RandomDms drawn = draw_fast_dms(first + i, degree);
    Random random(first + i);
    const FastDmsPoints points = draw_fast_dms_points(random, drawn.model, 16);
    FastDms fast(drawn.model, fast_options(tolerance));
    const FastDmsResults results(fast, points);
    ASSERT_EQ(check_fast_dms(drawn.model, points, results, greatest), "") << drawn.text;
    sum.fast += fast.counts().fast, sum.pairs += fast.counts().pairs;
    sum.near_faces += fast.counts().near_faces, sum.wide += fast.counts().wide;
  }
  EXPECT_LT(greatest, 1);
  EXPECT_GT(sum.near_faces, 0u);
  if (tolerance > 1e-100) {
    EXPECT_GT(tolerance > 1 ? sum.fast : sum.pairs, 0u);
  }
  EXPECT_EQ(sum.wide > 0, tolerance < 1e-100);
}

TEST(FastDms, BoundsHoldOnRandomModels) { expect_bounds(1, 32, 4, 1e300); }
TEST(FastDms, BoundsOfPairsHoldOnRandomModels) { expect_bounds(1000, 24, 4, 1e-20); }
TEST(FastDms, WideBoundsMakePointsExact) { expect_bounds(2000, 8, 3, 1e-200); }
TEST(FastDms, BoundsHoldUpToDegreeSix) { expect_bounds(3000, 4, 6, 1e300); }

TEST(FastDms, BackEndsComputeTheSameBits) {
  if (!is_available(FastDmsBackEnd::kAvx2)) GTEST_SKIP() << "no AVX2";
  for (int degree = 1; degree <= 3; ++degree) {
    const DmsModel model = clouded_cubes(degree);
    FastDmsOptions options = fast_options();
    Random random(static_cast<std::uint64_t>(degree));
    const FastDmsPoints points = draw_fast_dms_points(random, model, 100);
    options.back_end = FastDmsBackEnd::kBaseline;
    FastDms baseline(model, options);
    options.back_end = FastDmsBackEnd::kAvx2;
    FastDms avx2(model, options);
    const FastDmsResults a(baseline, points), b(avx2, points);
    EXPECT_EQ(a.value, b.value);
    EXPECT_EQ(a.value_bound, b.value_bound);
    EXPECT_EQ(a.gradient, b.gradient);
    EXPECT_EQ(a.gradient_bound, b.gradient_bound);
    EXPECT_EQ(a.tetrahedron, b.tetrahedron);
  }
}

// A point's numbers depend neither on the batch nor on what is kept; without bounds they are the same numbers.
TEST(FastDms, NumbersDoNotDependOnOtherPoints) {
  const DmsModel model = clouded_cubes(3);
  Random random(8);
  FastDmsPoints points;
  for (int i = 0; i < 8; ++i)
    points.add({Rational::from_double(2 * random.unit()), Rational::from_double(2 * random.unit()),
                Rational::from_double(2 * random.unit())},
               false);
  FastDms fast(model, fast_options());
  const FastDmsResults all(fast, points);
  FastDmsOptions forgetful = fast_options();
  forgetful.max_bytes = 0;
  FastDms little(model, forgetful);
  std::vector<double> plain(all.value.size());
  fast.evaluate(points.at, {plain.data()});
  EXPECT_EQ(plain, all.value);
  for (std::size_t i = 0; i < points.at.size(); ++i) {
    FastDmsPoints one;
    one.at = {points.at[i]};
    const FastDmsResults alone(little, one);
    for (std::size_t c = 0; c < 4; ++c) {
      EXPECT_EQ(alone.value[c], all.value[4 * i + c]);
      EXPECT_EQ(alone.value_bound[c], all.value_bound[4 * i + c]);
      EXPECT_EQ(alone.gradient[3 * c], all.gradient[12 * i + 3 * c]);
    }
  }
}

TEST(FastDms, BoundsAreNarrow) {
  for (int degree = 1; degree <= 3; ++degree) {
    const DmsModel model = clouded_cubes(degree);
    Random random(9);
    FastDmsPoints points;
    for (int i = 0; i < 300; ++i)
      points.add(
          {Rational::from_double(2 * random.unit()), Rational::from_double(2 * random.unit()),
           Rational::from_double(2 * random.unit())},
          false);
    FastDmsOptions options;
    options.exact_first = 0;
    FastDms fast(model, options);
    const FastDmsResults results(fast, points, false);
    EXPECT_EQ(fast.counts().exact(), 0u);
    EXPECT_EQ(fast.counts().fast + fast.counts().pairs, 300u);
    EXPECT_GT(fast.counts().fast, 290u);
    for (const double b : results.value_bound) EXPECT_LE(b, 2.2 * 0x1p-41);
  }
}

TEST(FastDms, PointsTakeEveryWay) {
  const DmsModel model = clouded_cubes(2);
  FastDms fast(model, fast_options());
  FastDmsPoints points;
  points.add({ratio(1, 2), ratio(1, 3), ratio(1, 7)}, true);  // fast, rounded
  points.add({ratio(1, 2), ratio(1, 4), ratio(1, 8)}, false);
  points.add({1, 1, 1}, false);  // a vertex
  points.add({ratio(1, 3), ratio(1, 3), ratio(1, 7)},
             true);              // on a face, by a hair beside it when rounded
  points.add({2, 2, 2}, false);  // a corner
  points.add({3, 0, 0}, false);  // outside
  points.add({0, 0, -Rational::power_of_two(-1074)}, false);
  double greatest = 0;
  EXPECT_EQ(check_fast_dms(model, points, FastDmsResults(fast, points), greatest), "");
  EXPECT_EQ(fast.counts().fast, 5u);
  EXPECT_EQ(fast.counts().near_faces,
            4u);  // the last one is outside, but not by more than rounding errors
  EXPECT_EQ(fast.counts().outside, 2u);
  const FastDmsResults results(fast, points, false);
  EXPECT_TRUE(std::isnan(results.value[4 * 5]));
  EXPECT_EQ(results.value_bound[4 * 5], std::numeric_limits<double>::infinity());
  EXPECT_TRUE(std::isnan(results.value[4 * 6]));
}

// A tetrahedron with a height of 2^-60 has numbers out of range; its neighbour with 2^10 points does not.
TEST(FastDms, ThinNeighboursLeavePointsFast) {
  DmsModel domain;
  domain.clouds = {{{0, 0, 0}}, {{1, 0, 0}}, {{0, 1, 0}}, {{0, 0, 1}}};
  const Rational third = ratio(1, 3), apex = third + Rational::power_of_two(-60);
  domain.clouds.push_back({{apex, apex, apex}});
  domain.tetrahedra = {{0, 1, 2, 3}, {1, 2, 3, 4}};
  set_control_by_rule(domain, DmsControlRule::kGreville, {});
  const DmsModel model = make_dms(domain, {2, std::nullopt, DmsControlRule::kGreville}).value();
  FastDms fast(model, fast_options());
  FastDmsPoints points;
  for (int i = 0; i < 1024; ++i)
    points.add({ratio(1 + i % 8, 32), ratio(1 + i / 8 % 8, 32), ratio(1 + i / 64, 32)}, false);
  points.add({third, third, third}, true);
  double greatest = 0;
  EXPECT_EQ(check_fast_dms(model, points, FastDmsResults(fast, points), greatest), "");
  EXPECT_LE(fast.counts().exact(), 2u);  // those on the common face
  EXPECT_GE(fast.counts().fast, 1000u);
}

// With collapsed clouds simplex splines jump on planes through faces; inside of a tetrahedron of another size such a
// plane may be near.
TEST(FastDms, OpenSignsAreDecidedExactly) {
  DmsModel model = kuhn_domain({2, 2, 2});
  model.degree = 3;
  // The knots of the middle lie in planes of the grid, off the faces of tetrahedra.
  model.clouds[13] = {{1, 1, 1}, {ratio(11, 10), 1, ratio(21, 20)}, {1, ratio(9, 10), 1}};
  set_control_by_rule(model, DmsControlRule::kGreville, {});
  FastDms fast(model, fast_options());
  FastDmsPoints points;
  Random random(4);
  for (int i = 0; i < 400; ++i) {
    DmsPoint p{ratio(10 + random.between(-3, 3), 10), ratio(10 + random.between(-3, 3), 10),
               ratio(10 + random.between(-3, 3), 10)};
    p[0] += ratio(random.between(0, 3), 31);
    points.add(p, i % 2 == 0);
  }
  double greatest = 0;
  EXPECT_EQ(check_fast_dms(model, points, FastDmsResults(fast, points), greatest), "");
  EXPECT_GT(fast.counts().open_sign + fast.counts().pairs, 0u);
}

TEST(FastDms, FirstPointsOfATetrahedronAreExact) {
  const DmsModel model = clouded_cubes(2);
  FastDms fast(model);
  FastDmsPoints points;
  points.add({ratio(1, 2), ratio(1, 3), ratio(1, 7)}, true);
  for (int i = 0; i < 6; ++i) {
    const FastDmsResults results(fast, points, false);
    if (i < 4) {
      EXPECT_EQ(results.value[1], nearest_double(ratio(1, 3)));
    }
    EXPECT_EQ(fast.counts().unprepared, std::min(i + 1u, 4u));
  }
  EXPECT_EQ(fast.counts().fast, 2u);
}

TEST(FastDms, NumbersOutOfRangeAreEvaluatedExactly) {
  for (const int power : {1500, -1500, 700}) {
    DmsModel model = clouded_cubes(2);
    const Rational scale = Rational::power_of_two(power);
    for (Rational& c : model.control.values) c *= scale;
    if (power != 700)
      for (DmsCloud& cloud : model.clouds)
        for (DmsPoint& knot : cloud)
          for (Rational& c : knot) c *= scale;
    FastDms fast(model, fast_options());
    FastDmsPoints points;
    const Rational by = power == 700 ? Rational(1) : scale;
    points.add({by / Rational(3), by / Rational(5), by / Rational(7)}, true);
    points.add({by * Rational(3), by / Rational(5), by / Rational(7)}, true);
    const FastDmsResults results(fast, points);
    EXPECT_EQ(fast.counts().fast, 0u);
    EXPECT_NE(results.tetrahedron[0], FastDms::kNoTetrahedron);
    EXPECT_EQ(results.tetrahedron[1], FastDms::kNoTetrahedron);
    double greatest = 0;
    if (power < 0) {
      EXPECT_EQ(check_fast_dms(model, points, results, greatest), "");
    }
    if (power == 1500) {
      EXPECT_EQ(results.value_bound[0], std::numeric_limits<double>::infinity());
    }
  }
}

// Control values that are all 0 in one component, tiny in another.
TEST(FastDms, ComponentsHaveBoundsOfTheirOwn) {
  DmsModel model = clouded_cubes(3);
  for (std::size_t i = 0; i < model.control.values.size(); ++i) {
    if (i % 4 == 1) model.control.values[i] = 0;
    if (i % 4 == 2) model.control.values[i] *= Rational::power_of_two(-200);
  }
  FastDms fast(model, fast_options());
  FastDmsPoints points;
  points.add({ratio(1, 2), ratio(1, 3), ratio(1, 7)}, true);
  const FastDmsResults results(fast, points);
  double greatest = 0;
  EXPECT_EQ(check_fast_dms(model, points, results, greatest), "");
  EXPECT_EQ(fast.counts().fast, 1u);
  EXPECT_EQ(results.value[1], 0);
  EXPECT_EQ(results.value_bound[1], 0);
  EXPECT_LE(results.value_bound[2], 0x1p-240);
}

TEST(FastDms, ChecksItsArguments) {
  const DmsModel model = clouded_cubes(2);
  FastDms fast(model);
  const std::vector<Vec3d> points{{0.5, 0.25, 0.125}};
  double numbers[12];
  EXPECT_EQ(fast.num_components(), 4u);
  EXPECT_GE(fast.num_near(0), 4u);
  EXPECT_THROW(fast.evaluate(points, {}), InternalError);
  EXPECT_THROW(fast.evaluate(points, {numbers, nullptr, numbers}), InternalError);
  EXPECT_THROW(fast.evaluate(points, {numbers, nullptr, nullptr, numbers}), InternalError);
}

TEST(FastDms, EnclosuresAreRoundedOutwardOnlyWhereTheyMustBe) {
  const double infinity = std::numeric_limits<double>::infinity();
  using Pair = std::array<double, 2>;
  EXPECT_EQ(enclosure_of(1.5, 0), (Pair{1.5, 1.5}));
  EXPECT_EQ(enclosure_of(1.5, 0.25), (Pair{1.25, 1.75}));
  EXPECT_EQ(enclosure_of(1, 0x1p-60), (Pair{std::nextafter(1, 0), std::nextafter(1, 2)}));
  EXPECT_EQ(enclosure_of(1, infinity), (Pair{-infinity, infinity}));
}

}  // namespace
}  // namespace veritope
