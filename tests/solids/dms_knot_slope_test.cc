// SPDX-License-Identifier: LGPL-3.0-or-later
// tests/solids/dms_knot_slope_test.cc: derivatives with respect to knots against quotients of exact values.
#include "solids/dms/dms_knot_slope.h"

#include <gtest/gtest.h>

#include <span>

#include "solids/dms/dms_program.h"
#include "solids/dms/fit/fit_rows.h"
#include "tests/predicates/test_scale.h"
#include "tests/support/dms_laws.h"
#include "tests/support/random_dms.h"

namespace veritope {
namespace {

Rational ratio(long p, long q) { return Rational(p) / Rational(q); }

// A model whose clouds have as many knots as the degree, equal ones or not, so that one of them can move.
DmsModel spread_out(DmsModel model) {
  const auto n = static_cast<std::size_t>(model.degree);
  for (DmsCloud& cloud : model.clouds) cloud.resize(n, cloud[0]);
  return model;
}

std::optional<std::vector<Rational>> value_after(DmsModel model, std::uint32_t vertex, int index,
                                                 std::size_t axis, const Rational& step,
                                                 const DmsPoint& u) {
  model.clouds[vertex][static_cast<std::size_t>(index)][axis] += step;
  DmsEvaluator evaluator(model);
  const auto place = evaluator.locate(u);
  if (!place) return std::nullopt;
  return evaluator.evaluate(*place).value;
}

// Central quotients differ from the derivative by a multiple of the step's square, up to higher powers: a quarter for
// half of the step. A wrong derivative leaves a difference that does not become less.
std::string compare(const DmsModel& model, const DmsPoint& u, std::uint32_t vertex, int index,
                    std::size_t axis, std::span<const std::array<Rational, 3>> slope) {
  std::vector<std::array<Rational, 2>> errors(model.num_components());
  for (int half = 0; half < 2; ++half) {
    const Rational step = Rational::power_of_two(-40 - half);
    const auto up = value_after(model, vertex, index, axis, step, u),
               down = value_after(model, vertex, index, axis, -step, u);
    if (!up || !down) return "";
    for (std::size_t c = 0; c < errors.size(); ++c)
      errors[c][static_cast<std::size_t>(half)] =
          abs(((*up)[c] - (*down)[c]) / (Rational(2) * step) - slope[c][axis]);
  }
  for (const auto& [whole, half] : errors)
    if (whole.sign() != Sign::kZero &&
        (half * Rational(3) > whole || whole > Rational::power_of_two(-30)))
      return "knot " + std::to_string(index) + " of vertex " + std::to_string(vertex) + ", axis " +
             std::to_string(axis) + ", at " + text_of(u) + ": off by " +
             std::to_string(nearest_double(whole)) + ", " + std::to_string(nearest_double(half));
  return "";
}

TEST(DmsKnotSlope, IsTheLimitOfQuotientsOfExactValues) {
  int with_effect = 0;
  for (std::uint64_t seed = 1; seed <= static_cast<std::uint64_t>(scaled(40)); ++seed) {
    const RandomDms drawn = draw_dms(seed, 3);
    const DmsModel model = spread_out(drawn.model);
    DmsKnotSlopes slopes(model);
    const DmsEvaluator evaluator(model);
    Random random(seed);
    for (int i = 0; i < 4; ++i) {
      const auto& t = model.tetrahedra[random.below(model.tetrahedra.size())];
      DmsPoint u;  // inside, on no plane of knots
      Rational total;
      for (const std::uint32_t v : t) {
        const Rational weight = ratio(random.between(1000, 9000), 1009);
        for (std::size_t c = 0; c < 3; ++c) u[c] += weight * model.clouds[v][0][c];
        total += weight;
      }
      for (Rational& c : u) c /= total;
      const auto place = evaluator.locate(u);
      ASSERT_TRUE(place.has_value());
      const auto vertex = i % 2 == 0
                              ? t[random.below(4)]
                              : static_cast<std::uint32_t>(random.below(model.clouds.size()));
      const int index = static_cast<int>(random.below(static_cast<std::uint64_t>(model.degree)));
      const auto slope = slopes.slope(*place, vertex, index);
      ASSERT_EQ(compare(model, u, vertex, index, random.below(3), slope), "") << drawn.text;
      with_effect += slope[0] != std::array<Rational, 3>{};
    }
  }
  EXPECT_GE(with_effect, 60);
}

// The derivative of a collapsed cloud's vertex is the sum of those of its knots: -λ_p times the map's own derivative.
TEST(DmsKnotSlope, OfACollapsedCloudIsThatOfTheBarycentricCoordinates) {
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    DmsModel model = draw_dms(seed, 4).model;
    for (DmsCloud& cloud : model.clouds) cloud.resize(1);
    DmsKnotSlopes slopes(model);
    DmsEvaluator evaluator(model);
    Random random(seed);
    const DmsPoint u = draw_dms_point(random, model);
    const auto place = evaluator.locate(u);
    ASSERT_TRUE(place.has_value());
    const DmsValue value = evaluator.evaluate(*place);
    const TetrahedronCorners& t = model.tetrahedra[place->tetrahedron];
    std::array<std::array<Rational, 3>, 4> corners;
    for (std::size_t m = 0; m < 4; ++m) corners[m] = model.clouds[t[m]][0];
    const auto lambda =
        simplex_frame<Rational>({0, 1, 2, 3}, corners, Sign::kPositive).barycentric(u);
    for (std::size_t m = 0; m < 4; ++m) {
      std::vector<std::array<Rational, 3>> sum(model.num_components());
      for (int i = 0; i < model.degree; ++i) {
        const auto slope = slopes.slope(*place, t[m], i);
        for (std::size_t c = 0; c < sum.size(); ++c)
          for (std::size_t a = 0; a < 3; ++a) sum[c][a] += slope[c][a];
      }
      for (std::size_t c = 0; c < sum.size(); ++c)
        for (std::size_t a = 0; a < 3; ++a)
          EXPECT_EQ(sum[c][a], -lambda[m] * value.gradient[c][a]) << "seed " << seed;
    }
  }
}

// Eq. 11 as printed, with n for n + 1 where it numbers the degree: the derivative of the form of degree n, which is not
// the map where (a), (c) hold to n - 1 only.
std::vector<Rational> printed_slope(const DmsModel& model, const DmsPlace& place,
                                    std::uint32_t vertex, int index, std::size_t axis) {
  DmsEvaluator evaluator(model);
  const Rational step = Rational::power_of_two(-60);
  const auto value = [&](const Rational& by) {
    DmsModel moved = internal::separated(model);
    for (DmsCloud& cloud : moved.clouds)
      if (cloud.size() > 1) cloud.resize(static_cast<std::size_t>(model.degree) + 1, cloud[0]);
    moved.clouds[vertex][static_cast<std::size_t>(index)][axis] += by;
    DmsEvaluator other(moved);
    return other.evaluate(*other.locate(place.path.start().at())).value;
  };
  std::vector<Rational> up = value(step), down = value(-step);
  for (std::size_t c = 0; c < up.size(); ++c) up[c] = (up[c] - down[c]) / (Rational(2) * step);
  return up;
}

TEST(DmsKnotSlope, IsNotThatOfThePaperWhereConditionsHoldToDegreeNMinusOneOnly) {
  DmsModel model;
  model.degree = 2;
  model.attributes = {"one"};
  model.clouds = {{{0, 0, 0}, {-2, -1, 1}, {0, 0, 0}},
                  {{4, 0, 0}, {6, -1, 1}, {4, 0, 0}},
                  {{2, 2, 0}},
                  {{2, 1, -2}},
                  {{2, ratio(-4, 5), ratio(4, 5)}},
                  {{ratio(21, 10), ratio(-4, 5), ratio(4, 5)}},
                  {{2, ratio(-7, 10), ratio(4, 5)}},
                  {{2, ratio(-4, 5), ratio(9, 10)}}};
  model.tetrahedra = {{1, 0, 2, 3}, {4, 5, 6, 7}};
  set_control_by_rule(model, DmsControlRule::kGreville, std::vector<Rational>(8, Rational(1)));
  const DmsPoint u{ratio(81, 40), ratio(-31, 40), ratio(33, 40)};
  const DmsEvaluator evaluator(model);
  const auto place = evaluator.locate(u);
  ASSERT_TRUE(place.has_value());
  DmsKnotSlopes slopes(model);
  // The attribute is 1 everywhere, whatever the knots are.
  EXPECT_EQ(slopes.slope(*place, 0, 1)[3], (std::array<Rational, 3>{}));
  const Rational printed = printed_slope(model, *place, 0, 1, 2)[3];
  EXPECT_GT(abs(printed), ratio(1, 1000));
}

TEST(DmsKnotSlope, ChecksTheKnot) {
  const DmsModel model = draw_dms(3, 3).model;
  const DmsEvaluator evaluator(model);
  DmsKnotSlopes slopes(model);
  const auto& t = model.tetrahedra[0];
  DmsPoint u;
  for (const std::uint32_t v : t)
    for (std::size_t c = 0; c < 3; ++c) u[c] += model.clouds[v][0][c] / Rational(4);
  const auto place = evaluator.locate(u);
  ASSERT_TRUE(place.has_value());
  EXPECT_THROW(slopes.slope(*place, t[0], model.degree), InternalError);
}

// Programs in binary64 and in intervals give the values and derivatives that exact recurrences do.
TEST(DmsProgram, AgreesWithExactValues) {
  for (std::uint64_t seed = 1; seed <= static_cast<std::uint64_t>(scaled(12)); ++seed) {
    const RandomDms drawn = draw_dms(seed, 3);
    const DmsModel& model = drawn.model;
    if (model.attributes.empty()) continue;
    const std::size_t attributes = model.attributes.size();
    DmsData data;
    data.num_attributes = attributes;
    Random random(seed);
    for (int i = 0; i < 10; ++i) data.points.push_back(draw_dms_point(random, model));
    data.values.resize(data.points.size() * attributes);
    const FitPoints points = find_fit_points(model, data);
    ASSERT_EQ(points.size(), data.points.size());
    const FitControl control = fit_control(model);
    std::vector<double> values;
    for (std::size_t c = 0; c < control.count; ++c)
      for (std::size_t a = 0; a < attributes; ++a)
        values.push_back(nearest_double(model.value(c)[3 + a]));
    FitBasis basis(model, control, points, true);
    const SparseRows rows = basis.rows();
    DmsEvaluator evaluator(model);
    DmsKnotSlopes exact(model);
    for (std::size_t i = 0; i < points.size(); ++i) {
      const auto place = evaluator.locate(data.points[i]);
      const DmsValue value = evaluator.evaluate(*place);
      for (std::size_t a = 0; a < attributes; ++a) {
        double sum = 0;
        for (int k = rows.first[i]; k < rows.first[i + 1]; ++k)
          sum += rows.value[static_cast<std::size_t>(k)] *
                 values[static_cast<std::size_t>(rows.column[static_cast<std::size_t>(k)]) *
                            attributes +
                        a];
        EXPECT_NEAR(sum, nearest_double(value.value[3 + a]), 1e-9) << drawn.text;
      }
      for (const KnotSlope& slope : basis.slopes(i, values, attributes)) {
        const auto wanted = exact.slope(*place, slope.vertex, slope.index);
        for (std::size_t a = 0; a < attributes; ++a)
          for (std::size_t k = 0; k < 3; ++k) {
            const double w = nearest_double(wanted[3 + a][k]);
            EXPECT_NEAR(slope.along[a][k], w, 1e-7 * (1 + std::abs(w))) << drawn.text;
          }
      }
    }
  }
}

}  // namespace
}  // namespace veritope
