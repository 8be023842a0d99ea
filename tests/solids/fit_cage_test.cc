// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/micro/cage/fit_cage.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "solids/micro/cage/cage_containment.h"
#include "solids/micro/cage/principal_axes.h"
#include "solids/vmodel/jacobian_sign.h"
#include "tests/solids/cage_support.h"
#include "tests/support/random_fields.h"

namespace veritope {
namespace {

using namespace cage_test;
using namespace random_fields;

double worst_of(const std::vector<double>& values) { return *std::ranges::max_element(values); }

FitCageOptions small_options() {
  FitCageOptions options;
  options.grid = {{3, 3, 3}, {2, 2, 2}};
  options.margin = q(1, 8);
  return options;
}

// Circles about the z axis, a quarter of them.
DirectionField quarter_of_circles(Random& random, std::size_t count) {
  DirectionField out;
  for (std::size_t i = 0; i < count; ++i) {
    const double angle = uniform(random, 0, 1.5), radius = uniform(random, 1, 2);
    const double sign = random.below(2) == 0 ? 1 : -1;
    out.points.push_back(
        {radius * std::cos(angle), radius * std::sin(angle), uniform(random, 0, 1)});
    out.axes.push_back({-sign * std::sin(angle), sign * std::cos(angle), 0});
  }
  return out;
}

TEST(FitCage, FollowsCirclesWhateverTheSignsOfTheDirections) {
  Random random(1);
  const DirectionField field = quarter_of_circles(random, 200);
  const FitCage fit = fit_cage(field, {}, small_options()).value();
  EXPECT_EQ(certified({fit.cell}).verdict, Verdict::kValid);
  const auto found = angles(fit.cell, field.points, field.axes);
  EXPECT_LT(median(found), 0.3);
  EXPECT_LT(worst_of(found), 3);
  // The angles that it says are those of another evaluation.
  for (std::size_t i = 0; i < found.size(); ++i)
    EXPECT_NEAR(found[i], fit.approx_angles[i], 1e-4) << i;
}

TEST(FitCage, IsTheSameWithoutSignsAndForEveryNumberOfThreads) {
  Random random(2);
  DirectionField field = quarter_of_circles(random, 100);
  FitCageOptions options = small_options();
  const FitCage fit = fit_cage(field, {}, options).value();
  for (Point3d& axis : field.axes)
    for (double& x : axis) x *= -0.25;
  options.jobs = 2;
  EXPECT_EQ(fit_cage(field, {}, options).value().cell, fit.cell);
}

TEST(FitCage, EqualDirectionsGiveABoxAlongThem) {
  DirectionField field;
  for (int i = 0; i < 8; ++i) {
    field.points.push_back(
        {static_cast<double>(i & 1), static_cast<double>(i >> 1 & 1), static_cast<double>(i >> 2)});
    field.axes.push_back({0, i % 2 == 0 ? 1e300 : -1e-300, 0});
    // Vectors at the same place count again.
    field.points.push_back(field.points.back());
    field.axes.push_back(field.axes.back());
  }
  const FitCage fit = fit_cage(field, {}, small_options()).value();
  EXPECT_LT(worst_of(fit.approx_angles), 1e-4);
  EXPECT_FALSE(fit.stop);
  EXPECT_LT(worst_of(angles(fit.cell, field.points, field.axes)), 1e-4);
}

TEST(FitCage, OneVectorHasACageWithinTheMargin) {
  DirectionField field{{{1, 2, 3}}, {{1, 1, 1}}, {}};
  const FitCage fit = fit_cage(field, {}, small_options()).value();
  EXPECT_EQ(certified({fit.cell}).verdict, Verdict::kValid);
  EXPECT_LT(angles(fit.cell, field.points, field.axes)[0], 1e-3);
}

TEST(FitCage, ContainsTheContent) {
  Random random(3);
  const DirectionField field = quarter_of_circles(random, 200);
  const CageContent content = content_of(box_mesh({0, 0, 0}, {2, 2, 1}));
  FitCageOptions options = small_options();
  options.margin = q(1, 4);
  const FitCage fit = fit_cage(field, content, options).value();
  EXPECT_FALSE(find_gap(model_of({fit.cell}), content));
}

TEST(FitCage, ControlPointsAreShortDyadics) {
  Random random(4);
  const FitCage fit = fit_cage(quarter_of_circles(random, 80), {}, small_options()).value();
  // The diagonal is between 2 and 4: multiples of 2^(1 - 20).
  for (const Rational& x : fit.cell.coefficients())
    EXPECT_EQ((x * Rational::power_of_two(19)).denominator(), Integer(1)) << x.to_string();
}

TEST(FitCage, LinesThatMeetNameTheSpanThatStopsThem) {
  // All lines meet at the origin, and vectors are near to it: the determinant would vanish there.
  DirectionField field;
  Random random(5);
  for (int i = 0; i < 200; ++i) {
    const double z = uniform(random, 0.02, 1);
    field.points.push_back({z * uniform(random, -0.5, 0.5), z * uniform(random, -0.5, 0.5), z});
    field.axes.push_back(field.points.back());
  }
  const FitCage fit = fit_cage(field, {}, small_options()).value();
  EXPECT_TRUE(decide_determinants(model_of({fit.cell})).is_proved());
  ASSERT_TRUE(fit.stop);
  EXPECT_EQ(fit.stop->span[2], 0u);
  EXPECT_LT(std::abs(fit.stop->near[2]), 0.6);
}

TEST(FitCage, AThicknessIsTheFourthCoordinate) {
  Random random(6);
  DirectionField field = quarter_of_circles(random, 100);
  for (const Point3d& p : field.points) field.thickness.push_back(100 + 10 * p[2]);
  const FitCage fit = fit_cage(field, {}, small_options()).value();
  ASSERT_EQ(fit.cell.num_components(), 4);
  EXPECT_LT(worst_of(fit.approx_thickness_errors), 0.5);
  const Sampler sampler(fit.cell);
  for (std::size_t i = 0; i < 10; ++i) {
    const auto place = sampler.find(field.points[i]);
    ASSERT_TRUE(place);
    const auto value = evaluate(nearest_double(fit.cell).value(), *place).value();
    EXPECT_NEAR(value[3], field.thickness[i], 0.5);
  }
  // Without it the net is the same.
  field.thickness.clear();
  const FitCage plain = fit_cage(field, {}, small_options()).value();
  const auto all = fit.cell.coefficients(), points = plain.cell.coefficients();
  EXPECT_TRUE(std::equal(points.begin(), points.end(), all.begin()));
}

TEST(FitCage, OtherDegreesAndSpans) {
  Random random(7);
  const DirectionField field = quarter_of_circles(random, 60);
  for (const CageGrid& grid : {CageGrid{{1, 1, 1}, {1, 1, 1}}, CageGrid{{1, 1, 1}, {4, 4, 6}},
                               CageGrid{{2, 1, 4}, {1, 2, 1}}, CageGrid{{7, 2, 3}, {1, 1, 2}}}) {
    FitCageOptions options = small_options();
    options.grid = grid;
    const FitCage fit = fit_cage(field, {}, options).value();
    EXPECT_TRUE(decide_determinants(model_of({fit.cell})).is_proved());
    for (std::size_t k = 0; k < 3; ++k)
      EXPECT_EQ(fit.cell.grid().size[k], grid.spans[k] + static_cast<std::size_t>(grid.degrees[k]));
  }
}

TEST(FitCage, RefusesWhatIsNoField) {
  const FitCageOptions options = small_options();
  const auto message = [&](const DirectionField& field) {
    return fit_cage(field, {}, options).error().message;
  };
  EXPECT_EQ(message({}), "a field without vectors has no cage");
  EXPECT_EQ(message({{{0, 0, 0}, {1, 0, 0}}, {{0, 0, 1}, {0, 0, 0}}, {}}),
            "vector 1 has no direction: it is 0");
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(message({{{0, kNan, 0}}, {{0, 0, 1}}, {}}), "vector 0 has a number that is not finite");
  EXPECT_EQ(message({{{0, 0, 0}}, {{0, 0, kNan}}, {}}), "vector 0 has a number that is not finite");
  EXPECT_EQ(message({{{0, 0, 0}}, {{0, 0, 1}}, {kNan}}),
            "vector 0 has a number that is not finite");
  const Error far = fit_cage({{{1e30, 0, 0}}, {{0, 0, 1}}, {}}, {}, options).error();
  EXPECT_EQ(far.code, Code::kOverLimit);
}

TEST(FitCage, RefusesOptionsThatDoNotFit) {
  const DirectionField field{{{0, 0, 0}}, {{0, 0, 1}}, {}};
  FitCageOptions options = small_options();
  options.margin = q(0);
  EXPECT_EQ(fit_cage(field, {}, options).error().message, "margin must be positive, not 0");
  options = small_options();
  options.grid.spans = {16, 16, 17};
  EXPECT_EQ(fit_cage(field, {}, options).error().code, Code::kOverLimit);
  options.grid = {{kMaxFitDegree + 1, 1, 1}, {1, 1, 1}};
  EXPECT_EQ(fit_cage(field, {}, options).error().code, Code::kOverLimit);
  options.grid.degrees[0] = 0;
  EXPECT_EQ(fit_cage(field, {}, options).error().code, Code::kBadArgument);
}

TEST(PrincipalAxes, AreEigenvectorsInOrder) {
  Random random(8);
  for (int i = 0; i < 1000; ++i) {
    SymmetricTensor t;
    const double size = std::ldexp(1.0, static_cast<int>(random.between(-400, 400)));
    for (double& x : t) x = size * uniform(random, -1, 1);
    const PrincipalAxes axes = approx_principal_axes(t);
    EXPECT_GE(axes.values[0], axes.values[1]);
    EXPECT_GE(axes.values[1], axes.values[2]);
    for (std::size_t k = 0; k < 3; ++k) {
      const Point3d& d = axes.directions[k];
      const Point3d image = {t[0] * d[0] + t[3] * d[1] + t[5] * d[2],
                             t[3] * d[0] + t[1] * d[1] + t[4] * d[2],
                             t[5] * d[0] + t[4] * d[1] + t[2] * d[2]};
      for (std::size_t a = 0; a < 3; ++a)
        EXPECT_NEAR(image[a] / size, axes.values[k] / size * d[a], 1e-13) << i;
      EXPECT_NEAR(inner(d, d), 1, 1e-14);
    }
  }
}

TEST(PrincipalAxes, EqualGreatestValuesHaveNoFirstDirection) {
  EXPECT_FALSE(approx_principal_axes({2, 2, 2, 0, 0, 0}).has_first());
  EXPECT_FALSE(approx_principal_axes({0, 0, 0, 0, 0, 0}).has_first());
  EXPECT_FALSE(approx_principal_axes({2, 2, 1, 0, 0, 0}).has_first());
  EXPECT_FALSE(approx_principal_axes({-1, -1, -1, 0, 0, 0}).has_first());
  EXPECT_TRUE(approx_principal_axes({2, 1, 1, 0, 0, 0}).has_first());
  EXPECT_TRUE(approx_principal_axes({0, 0, 0, 1, 0, 0}).has_first());
}

}  // namespace
}  // namespace veritope
