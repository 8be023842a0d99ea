// SPDX-License-Identifier: LGPL-3.0-or-later
// tests/solids/dms_fit_test.cc: fits of data by simplex-spline solids.
#include "solids/dms/fit/dms_fit.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "solids/dms/dms_admissible.h"
#include "solids/dms/dms_evaluator.h"
#include "solids/dms/dms_make.h"
#include "solids/dms/fit/fit_constraint.h"
#include "solids/dms/fit/fit_solver.h"
#include "tests/predicates/test_scale.h"
#include "tests/support/random_dms.h"

namespace veritope {
namespace {

Rational ratio(long p, long q) { return Rational(p) / Rational(q); }

DmsModel box_domain(std::array<int, 3> size) {
  DmsModel domain = kuhn_domain(size);
  set_control_by_rule(domain, DmsControlRule::kGreville, {});
  return domain;
}

using Value = std::function<Rational(const DmsPoint&)>;

// Points of the domain's box, on a lattice so that many lie on faces.
DmsData draw_data(std::size_t count, std::array<int, 3> size, const Value& value,
                  std::uint64_t seed) {
  DmsData data;
  Random random(seed);
  for (std::size_t i = 0; i < count; ++i) {
    DmsPoint p;
    for (std::size_t c = 0; c < 3; ++c) p[c] = ratio(random.between(0, 12 * size[c]), 12);
    data.values.push_back(value(p));
    data.points.push_back(std::move(p));
  }
  return data;
}

DmsFit fit(const DmsModel& domain, const DmsData& data, const DmsFitOptions& options) {
  Result<DmsFit> result = fit_dms(domain, data, options);
  EXPECT_TRUE(result.has_value()) << result.error().message;
  return std::move(*result);
}

Rational bump(const DmsPoint& p) {
  const double x = nearest_double(p[0]) - 1, y = nearest_double(p[1]) - 0.7,
               z = nearest_double(p[2]) - 0.4;
  return Rational::from_double(std::tanh(4 * (0.5 - std::sqrt(x * x + y * y + z * z))));
}

TEST(DmsFit, ReproducesPolynomialsOfItsDegree) {
  for (int degree = 1; degree <= 4; ++degree) {
    const auto value = [&](const DmsPoint& p) {
      Rational sum = ratio(1, 3), power(1);
      for (int k = 1; k <= degree; ++k) {
        power *= p[0] - ratio(1, 2) * p[1] + ratio(1, 7) * p[2];
        sum += power * ratio(k, 5);
      }
      return sum;
    };
    const DmsData data = draw_data(2500, {2, 1, 1}, value, 5);
    const DmsFit result = fit(box_domain({2, 1, 1}), data, {degree, {}, {}, false, {}});
    EXPECT_LE(result.errors.attribute_mse[0], 1e-18) << degree;
    EXPECT_LE(result.errors.geometry_mse, 1e-20) << degree;
    EXPECT_TRUE(result.undetermined.empty());
    EXPECT_EQ(result.end, DmsFitEnd::kNoAim);
  }
}

// Data and domain moved and scaled exactly.
TEST(DmsFit, IsTheSameFarFromTheOriginAndInOtherUnits) {
  const auto value = [](const DmsPoint& p) { return p[0] * p[0] - p[1] * p[2] + ratio(1, 3); };
  const DmsData data = draw_data(300, {2, 1, 1}, value, 6);
  const DmsModel domain = box_domain({2, 1, 1});
  const DmsFit expected = fit(domain, data, {2, {}, {}, false, {}});
  for (const std::int64_t exponent : {0, 52, 600, -600})
    for (const std::int64_t offset : {0, 1, 1'000'000'007}) {
      const Rational factor = Rational::power_of_two(exponent == 52 ? 0 : exponent),
                     shift = factor * Rational(offset) *
                             Rational::power_of_two(exponent == 52 ? 22 : 0);
      const auto move = [&](DmsPoint& p) {
        for (Rational& x : p) x = shift + factor * x;
      };
      DmsModel moved_domain = domain;
      for (DmsCloud& cloud : moved_domain.clouds) move(cloud[0]);
      set_control_by_rule(moved_domain, DmsControlRule::kGreville, {});
      DmsData moved = data;
      for (DmsPoint& p : moved.points) move(p);
      for (Rational& x : moved.values) x *= factor;
      const DmsFit result = fit(moved_domain, moved, {2, {}, {}, false, {}});
      EXPECT_EQ(result.undetermined, expected.undetermined) << exponent << " " << offset;
      EXPECT_EQ(result.outside, expected.outside) << exponent << " " << offset;
      ASSERT_EQ(result.model.clouds, moved_domain.clouds) << exponent << " " << offset;
      const double size = nearest_double(factor);
      EXPECT_LE(result.errors.max_error[0], 1e-13 * size) << exponent << " " << offset;
      DmsEvaluator evaluator(result.model);
      for (std::size_t i = 0; i < 20; ++i) {
        const auto at = evaluator.locate(moved.points[i]);
        ASSERT_TRUE(at);
        const DmsValue found = evaluator.evaluate(*at);
        for (std::size_t c = 0; c < 3; ++c) EXPECT_EQ(found.value[c], moved.points[i][c]);
        EXPECT_LE(nearest_double(abs(found.value[3] - moved.values[i])), 1e-13 * size);
      }
    }
}

// Tetrahedra whose volume binary64 does not see, as domains of real meshes have some.
TEST(DmsFit, DataLieInFlatTetrahedra) {
  const auto value = [](const DmsPoint& p) {
    return p[0] + Rational(2) * p[1] - p[2] + ratio(1, 3);
  };
  for (const int bits : {20, 40, 66, 200})
    for (const int degree : {1, 2, 3}) {
      const Rational height = Rational::power_of_two(-bits);
      DmsModel domain;
      domain.degree = 1;
      domain.clouds = {
          {{0, 0, 0}}, {{1, 0, 0}}, {{0, 1, 0}}, {{ratio(1, 3), ratio(1, 3), height}}, {{0, 0, 1}}};
      domain.tetrahedra = {{0, 1, 2, 3}, {0, 1, 3, 4}, {1, 2, 3, 4}, {2, 0, 3, 4}};
      set_control_by_rule(domain, DmsControlRule::kGreville, {});
      DmsData data;
      for (int i = 1; i < 7; ++i)
        for (int k = 1; i + k < 8; ++k)
          for (int z = 0; z < 5; ++z) {
            DmsPoint p{ratio(i, 8), ratio(k, 8), z == 0 ? height / Rational(20) : ratio(z, 40)};
            data.values.push_back(value(p));
            data.points.push_back(std::move(p));
          }
      const DmsFit result = fit(domain, data, {degree, {}, {}, false, {}});
      EXPECT_LE(result.errors.max_error[0], 1e-9) << bits << " " << degree;
      EXPECT_LE(result.errors.geometry_mse, 1e-20) << bits << " " << degree;
    }
}

TEST(DmsFit, FitsNumbersNearTheEndOfBinary64) {
  const auto value = [](const DmsPoint& p) {
    return Rational::from_double(1e308) * (p[0] - p[1]) / Rational(2);
  };
  const DmsFit result =
      fit(box_domain({1, 1, 1}), draw_data(100, {1, 1, 1}, value, 2), {1, {}, {}, false, {}});
  EXPECT_LE(result.errors.max_error[0], 1e294);
}

// The bounds are above the errors of the model's exact values, and by little.
TEST(DmsFit, MeasuresTheModelAsItIs) {
  const DmsData data = draw_data(60, {1, 1, 1}, bump, 1);
  DmsModel domain = box_domain({1, 1, 1});
  Result<DmsModel> made =
      make_dms(domain, {2, DmsCloudDraw{ratio(1, 10), 3}, DmsControlRule::kGreville});
  ASSERT_TRUE(made.has_value());
  made->attributes = {"a"};
  set_control_by_rule(*made, DmsControlRule::kGreville,
                      std::vector<Rational>(made->clouds.size(), ratio(1, 3)));
  made->control.values[0] += ratio(1, 1000);  // no longer the identity
  const DmsFitErrors errors = measure_fit_errors(*made, data);
  DmsEvaluator evaluator(*made);
  Rational geometry, square, most;
  for (std::size_t i = 0; i < data.points.size(); ++i) {
    const DmsValue value = evaluator.evaluate(*evaluator.locate(data.points[i]));
    for (std::size_t c = 0; c < 3; ++c) {
      const Rational d = value.value[c] - data.points[i][c];
      geometry += d * d;
    }
    const Rational d = value.value[3] - data.values[i];
    square += d * d;
    most = std::max(most, abs(d));
  }
  const Rational count(data.points.size());
  const auto check = [](double bound, const Rational& exact) {
    EXPECT_GE(Rational::from_double(bound), exact);
    EXPECT_LE(Rational::from_double(bound), exact * (Rational(1) + ratio(1, 1000000)));
  };
  check(errors.geometry_mse, geometry / count);
  check(errors.attribute_mse[0], square / count);
  check(errors.max_error[0], most);
}

TEST(DmsFit, ListsPointsOutsideAndPointsThatDisagree) {
  DmsData data = draw_data(300, {1, 1, 1}, bump, 2);
  data.points[7] = {2, 0, 0};
  data.points[9] = {0, 0, ratio(-1, 1000000000)};
  data.points[20] = {ratio(1, 3), ratio(1, 5), ratio(1, 7)};
  data.points[30] = data.points[20];
  data.values[20] = Rational(0);
  data.values[30] = Rational(1);
  const DmsFit result = fit(box_domain({1, 1, 1}), data, {2, 1e-9, std::size_t{4000}, false, {}});
  EXPECT_EQ(result.outside, (std::vector<std::size_t>{7, 9}));
  EXPECT_TRUE(std::binary_search(result.conflicts.begin(), result.conflicts.end(), 20u));
  EXPECT_TRUE(std::binary_search(result.conflicts.begin(), result.conflicts.end(), 30u));
  EXPECT_EQ(result.end, DmsFitEnd::kConflict);
  EXPECT_FALSE(result.is_reached(1e-9));
  EXPECT_GE(result.errors.attribute_mse[0], 0.5 / 298);  // half a unit at two of 298 points
}

// Data in one cube of three determine no control point of the last one alone. The smoothest function goes on as it is.
TEST(DmsFit, ContinuesLinearFunctionsWhereThereAreNoData) {
  const auto value = [](const DmsPoint& p) {
    return Rational(2) * p[0] - p[1] + ratio(1, 3) * p[2] + ratio(1, 4);
  };
  const DmsData data = draw_data(800, {1, 1, 1}, value, 3);
  const DmsFit result = fit(box_domain({3, 1, 1}), data, {2, {}, {}, false, {}});
  // 27 of the quadratic's 63 control points lie in the first cube; only they have an effect there.
  EXPECT_EQ(result.model.num_control(), 63u);
  EXPECT_EQ(result.undetermined.size(), 36u);
  DmsEvaluator evaluator(result.model);
  const DmsPoint far{ratio(14, 5), ratio(1, 2), ratio(2, 3)};
  const DmsValue at = evaluator.evaluate(*evaluator.locate(far));
  EXPECT_NEAR(nearest_double(at.value[3] - value(far)), 0, 1e-4);
  EXPECT_LE(result.errors.attribute_mse[0], 1e-18);
}

TEST(DmsFit, CutsTetrahedraWhereTheErrorIs) {
  const DmsModel domain = box_domain({2, 2, 1});
  const DmsData data = draw_data(6000, {2, 2, 1}, bump, 4);
  const DmsFit coarse = fit(domain, data, {2, {}, {}, false, {}});
  const DmsFit fine = fit(domain, data, {2, {}, std::size_t{400}, false, {}});
  EXPECT_EQ(fine.end, DmsFitEnd::kBudget);
  EXPECT_GT(fine.model.tetrahedra.size(), 350u);
  EXPECT_LE(fine.model.tetrahedra.size(), 400u);
  EXPECT_LT(fine.errors.attribute_mse[0], coarse.errors.attribute_mse[0] / 20);
  EXPECT_EQ(find_dms_defects(fine.model).count, 0u);
  Rational volume;
  for (const TetrahedronCorners& t : fine.model.tetrahedra)
    volume += simplex_oracle::volume6(fine.model.clouds[t[0]][0], fine.model.clouds[t[1]][0],
                                      fine.model.clouds[t[2]][0], fine.model.clouds[t[3]][0]);
  EXPECT_EQ(volume, Rational(24));
  const TetrahedralComplex complex(fine.model.tetrahedra,
                                   static_cast<std::uint32_t>(fine.model.clouds.size()));
  EXPECT_EQ(complex.euler(), 1);
  for (const TetrahedronFace f : complex.boundary()) {  // each in a plane of the box
    const auto v = complex.vertices(f);
    bool is_on = false;
    for (std::size_t c = 0; c < 3; ++c) {
      const Rational& at = fine.model.clouds[v[0]][0][c];
      is_on = is_on || ((at == Rational(0) || at == Rational(c == 2 ? 1 : 2)) &&
                        fine.model.clouds[v[1]][0][c] == at && fine.model.clouds[v[2]][0][c] == at);
    }
    EXPECT_TRUE(is_on);
  }
  const DmsFit loose = fit(domain, data, {2, 1e-3, std::size_t{400}, false, {}});
  EXPECT_EQ(loose.end, DmsFitEnd::kTolerance);
  EXPECT_TRUE(loose.is_reached(1e-3));
  EXPECT_LT(loose.model.tetrahedra.size(), fine.model.tetrahedra.size());
  EXPECT_EQ(loose.rounds.back().tetrahedra, loose.model.tetrahedra.size());
}

TEST(DmsFit, FreeKnotsMakeErrorsLessAndStayAdmissible) {
  const DmsModel domain = box_domain({2, 2, 1});
  const DmsData data = draw_data(1500, {2, 2, 1}, bump, 6);
  const DmsPlane plane{{1, 0, 0}, Rational(1)};
  const DmsFit fixed = fit(domain, data, {2, {}, {}, false, {}});
  const DmsFit moved = fit(domain, data, {2, {}, {}, true, {plane}});
  EXPECT_LT(moved.errors.attribute_mse[0], fixed.errors.attribute_mse[0] * 0.8);
  EXPECT_EQ(moved.model.num_control(), fixed.model.num_control());
  EXPECT_LE(moved.errors.geometry_mse, 1e-20);
  EXPECT_EQ(find_dms_defects(moved.model).count, 0u);
  const DmsAdmissibility admissibility(moved.model);
  for (std::uint32_t t = 0; t < moved.model.tetrahedra.size(); ++t)
    EXPECT_TRUE(admissibility.has_core(t));
  for (const TetrahedronFace f : admissibility.complex().boundary())
    EXPECT_TRUE(admissibility.misses_inside(f));
  bool has_open = false, has_moved = false;
  for (std::size_t v = 0; v < moved.model.clouds.size(); ++v) {
    const DmsCloud& cloud = moved.model.clouds[v];
    const DmsPoint& old = domain.clouds[v][0];
    has_open = has_open || cloud.size() > 1;
    has_moved = has_moved || cloud[0] != old;
    for (const DmsPoint& knot : cloud)
      for (std::size_t c = 0; c < 3; ++c) {
        const bool is_on_side = old[c] == Rational(0) || old[c] == Rational(c == 2 ? 1 : 2);
        if (is_on_side || (c == 0 && old[0] == Rational(1))) {
          EXPECT_EQ(knot[c], old[c]);
        }
      }
  }
  EXPECT_TRUE(has_open && has_moved);
}

TEST(DmsFit, GivesTheSameModelAgain) {
  const DmsData data = draw_data(400, {1, 1, 1}, bump, 8);
  const DmsFitOptions options{2, {}, std::size_t{40}, true, {}};
  const DmsFit first = fit(box_domain({1, 1, 1}), data, options),
               second = fit(box_domain({1, 1, 1}), data, options);
  EXPECT_EQ(first.model, second.model);
}

TEST(DmsFit, RefusesWhatItCannotFit) {
  const DmsModel domain = box_domain({1, 1, 1});
  DmsData data = draw_data(10, {1, 1, 1}, bump, 9);
  EXPECT_EQ(fit_dms(domain, data, {0, {}, {}, false, {}}).error().code, Code::kBadArgument);
  EXPECT_EQ(fit_dms(domain, data, {2, {}, std::size_t{5}, false, {}}).error().code,
            Code::kOverLimit);
  DmsModel bent = domain;
  bent.control.values[0] = ratio(1, 2);
  EXPECT_EQ(fit_dms(bent, data, {2, {}, {}, false, {}}).error().code, Code::kBadArgument);
  data.values[3] = Rational::power_of_two(2000);
  EXPECT_EQ(fit_dms(domain, data, {2, {}, {}, false, {}}).error().code, Code::kBadArgument);
  data = draw_data(10, {1, 1, 1}, bump, 9);
  for (DmsPoint& p : data.points) p[0] += Rational(5);
  EXPECT_NE(fit_dms(domain, data, {2, {}, {}, false, {}}).error().message.find("no point"),
            std::string::npos);
}

TEST(FitConstraint, KeepsPointsInPlanesAndOnLines) {
  Random random(4);
  for (int i = 0; i < 200; ++i) {
    const auto draw = [&] {
      DmsPoint p;
      do
        for (Rational& c : p) c = ratio(random.between(-3, 3), random.between(1, 7));
      while (p == DmsPoint{});
      return p;
    };
    const DmsPoint a = draw(), b = draw(), c = draw(), from = draw();
    FitConstraint constraint;
    const DmsPoint free = constraint.moved(from, std::array{0.1, 0.2, -0.3});
    for (std::size_t k = 0; k < 3; ++k)
      EXPECT_EQ(free[k], Rational::from_double(nearest_double(free[k])));
    EXPECT_EQ(constraint.moved(from, std::array{0.0, 0.0, 0.0}), from);
    constraint.add_normal(a);
    const DmsPoint flat = constraint.moved(from, std::array{0.1, 0.25});
    EXPECT_EQ(dot_product(a, difference(flat, from)), Rational(0));
    EXPECT_NE(flat, from);
    if (cross_product(a, b) == DmsPoint{}) continue;
    constraint.add_normal(b);
    ASSERT_EQ(constraint.num_directions(), 1u);
    const DmsPoint along = constraint.moved(from, std::array{0.1});
    EXPECT_EQ(dot_product(a, difference(along, from)), Rational(0));
    EXPECT_EQ(dot_product(b, difference(along, from)), Rational(0));
    EXPECT_NE(along, from);
    if (dot_product(c, cross_product(a, b)) == Rational(0)) continue;
    constraint.add_normal(c);
    EXPECT_EQ(constraint.num_directions(), 0u);
    EXPECT_EQ(constraint.moved(from, {}), from);
  }
}

TEST(FitSolver, FindsWhatRowsDoNotDetermine) {
  SparseRows rows;
  const auto add = [&](std::vector<std::pair<int, double>> row) { rows.add(row); };
  // 0 is determined; of 1 and 2 the sum; 3 has no row; 4 and 5 are determined, though nearly equal columns.
  add({{0, 2.0}});
  add({{1, 1.0}, {2, 1.0}});
  add({{0, 1.0}, {1, 2.0}, {2, 2.0}});
  add({{4, 1.0}, {5, 1.0}});
  add({{4, 1.0}, {5, 1.01}});
  EXPECT_EQ(find_undetermined(rows, 6), (std::vector<std::uint32_t>{1, 2, 3}));
  // What is determined is found to the last digits, the sum of 1 and 2 too.
  const std::vector<double> x =
      solve_least_squares(rows, SparseRows(), 6, std::vector<double>{6, 5, 13, 3, 3.01}, 1);
  EXPECT_NEAR(x[0], 3, 1e-12);
  EXPECT_NEAR(x[1] + x[2], 5, 1e-12);
  EXPECT_NEAR(x[4], 2, 1e-8);
  EXPECT_NEAR(x[5], 1, 1e-8);
}

}  // namespace
}  // namespace veritope
