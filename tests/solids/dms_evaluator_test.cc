// SPDX-License-Identifier: LGPL-3.0-or-later
// tests/solids/dms_evaluator_test.cc: values of simplex-spline solids where they are known, and what the formulas of
// [HHQ04] as printed would give.
#include "solids/dms/dms_evaluator.h"

#include <gtest/gtest.h>

#include "solids/dms/dms_defects.h"
#include "solids/dms/dms_make.h"
#include "tests/support/dms_laws.h"
#include "tests/support/random_dms.h"

namespace veritope {
namespace {

Rational ratio(long p, long q) { return Rational(p) / Rational(q); }

Rational basis_sum(DmsEvaluator& evaluator, const DmsPlace& place, int degree) {
  Rational sum;
  evaluator.for_each_basis(
      place, degree, [&](std::uint32_t, const TetrahedralIndex&, const Rational& n) { sum += n; });
  return sum;
}

// One quadratic tetrahedron with drawn clouds.
DmsModel clouded_cube(int degree) {
  DmsModel domain = kuhn_domain({2, 2, 2});
  set_control_by_rule(domain, DmsControlRule::kGreville, {});
  const Result<DmsModel> model =
      make_dms(domain, {degree, DmsCloudDraw{ratio(1, 10), 5}, DmsControlRule::kGreville});
  EXPECT_TRUE(model.has_value());
  return *model;
}

TEST(DmsEvaluator, FindsTheTetrahedronThatRuleHEnters) {
  const DmsModel model = clouded_cube(2);
  const DmsEvaluator evaluator(model);
  const auto locate = [&](Rational x, Rational y, Rational z) {
    return evaluator.locate({std::move(x), std::move(y), std::move(z)});
  };
  EXPECT_FALSE(locate(ratio(-1, 1000), 0, 0).has_value());
  EXPECT_FALSE(locate(2, 2, Rational(2) + Rational::power_of_two(-200)).has_value());
  // The middle: the cube towards (+, +, +), and in it the tetrahedron x > y > z, whose first axis is 0, then 1.
  const auto middle = locate(1, 1, 1);
  ASSERT_TRUE(middle.has_value());
  EXPECT_EQ(middle->tetrahedron, 42u);
  EXPECT_FALSE(middle->path.target().has_value());
  // A corner that the axes leave: the first tetrahedron that has it, by its barycentre.
  const auto corner = locate(2, 2, 2);
  ASSERT_TRUE(corner.has_value());
  EXPECT_EQ(corner->tetrahedron, 42u);
  ASSERT_TRUE(corner->path.target().has_value());
  EXPECT_EQ(corner->path.target()->at(), (DmsPoint{ratio(7, 4), ratio(3, 2), ratio(5, 4)}));
  EXPECT_FALSE(locate(0, 0, 0)->path.target().has_value());
}

TEST(DmsEvaluator, TakesCoordinatesBeyondDoubles) {
  DmsModel model = clouded_cube(2);
  const Rational scale = Rational::power_of_two(1500);
  for (DmsCloud& cloud : model.clouds)
    for (DmsPoint& knot : cloud)
      for (Rational& c : knot) c *= scale;
  set_control_by_rule(model, DmsControlRule::kGreville, {});
  DmsEvaluator evaluator(model);
  const DmsPoint u{scale, scale / Rational(3), scale / Rational(7)};
  const auto place = evaluator.locate(u);
  ASSERT_TRUE(place.has_value());
  const DmsValue value = evaluator.evaluate(*place);
  EXPECT_TRUE(std::equal(u.begin(), u.end(), value.value.begin()));
  EXPECT_FALSE(evaluator.locate({scale * Rational(3), 0, 0}).has_value());
}

TEST(DmsEvaluator, ChecksItsArguments) {
  const DmsModel model = clouded_cube(2);
  DmsEvaluator evaluator(model);
  const auto place = evaluator.locate({1, 1, 1});
  EXPECT_THROW(evaluator.for_each_basis(*place, 3, [](auto&&...) {}), InternalError);
  EXPECT_THROW(evaluator.for_each_basis(*place, -1, [](auto&&...) {}), InternalError);
}

// ---- what is wrong in the paper

// Its simplex spline of degree 0 is 1 / Vol; with six times the volume in eq. 5 the basis adds up to 6.
TEST(DmsPaper, NormalisationByTheVolumeAddsUpToSix) {
  const DmsModel model = clouded_cube(3);
  DmsEvaluator evaluator(model);
  Random random(3);
  for (int i = 0; i < 20; ++i) {
    const DmsPoint u = draw_dms_point(random, model);
    const auto place = evaluator.locate(u);
    ASSERT_TRUE(place.has_value());
    const Rational sum = basis_sum(evaluator, *place, 2);
    EXPECT_EQ(sum, Rational(1));
    // M is linear in M_0, and 1 / Vol = 6 / |d|.
    Rational printed;
    evaluator.for_each_basis(*place, 2,
                             [&](std::uint32_t, const TetrahedralIndex&, const Rational& n) {
                               printed += Rational(6) * n;
                             });
    EXPECT_EQ(printed, Rational(6));
  }
}

// The form of degree n - 1 with three of the four e_m does not reproduce points.
TEST(DmsPaper, FormOfDegreeNMinusOneNeedsAllFourCorners) {
  const DmsModel model = clouded_cube(2);
  DmsEvaluator evaluator(model);
  const DmsPoint u{ratio(2, 3), ratio(5, 4), ratio(9, 7)};
  const auto place = evaluator.locate(u);
  ASSERT_TRUE(place.has_value());
  std::array<Rational, 3> three, four;
  evaluator.for_each_basis(
      *place, 1, [&](std::uint32_t t, const TetrahedralIndex& gamma, const Rational& n) {
        std::array<std::array<Rational, 3>, 4> w;
        for (std::size_t m = 0; m < 4; ++m) w[m] = model.knot(model.tetrahedra[t][m], gamma[m]);
        const auto lambda =
            simplex_frame<Rational>({0, 1, 2, 3}, w, Sign::kPositive).barycentric(u);
        for (std::size_t m = 0; m < 4; ++m) {
          const auto c = model.value(control_of(model, t, raised(gamma, m)));
          for (std::size_t a = 0; a < 3; ++a) {
            four[a] += n * lambda[m] * c[a];
            if (m < 3) three[a] += n * lambda[m] * c[a];
          }
        }
      });
  EXPECT_EQ(four, u);
  EXPECT_NE(three, u);
  EXPECT_EQ(evaluator.evaluate(*place).value, (std::vector<Rational>{u[0], u[1], u[2]}));
}

// "The knots associated to the boundary triangle must lie outside of the domain" does not give a partition of unity.
TEST(DmsPaper, KnotsOutsideOfTheDomainAreNotEnough) {
  DmsModel model = kuhn_domain({2, 2, 2}, [](int x, int y, int z) { return x + y + z < 3; });
  ASSERT_EQ(model.tetrahedra.size(), 42u);
  model.degree = 2;
  const std::uint32_t v = 2 * 9 + 1 * 3 + 1;
  ASSERT_EQ(model.clouds[v][0], (DmsPoint{2, 1, 1}));
  model.clouds[v].push_back({ratio(21, 10), ratio(9, 10), ratio(9, 10)});
  set_control_by_rule(model, DmsControlRule::kGreville, {});
  // It is the condition (c) that is broken.
  const DmsDefects defects = find_dms_defects(model);
  ASSERT_GT(defects.count, 0u);
  for (const DmsDefect& defect : defects.first) EXPECT_EQ(defect.fault, DmsFault::kInside);
  DmsEvaluator evaluator(model);
  EXPECT_FALSE(evaluator.locate(model.clouds[v][1]).has_value());  // the knot is outside
  const auto place = evaluator.locate({ratio(9, 5), ratio(97, 100), ratio(97, 100)});
  ASSERT_TRUE(place.has_value());
  const double sum = nearest_double(basis_sum(evaluator, *place, 1));
  EXPECT_NEAR(sum, 0.53, 0.005);
}

// Eq. 6 is not the map where (c) holds to n - 1 only: its basis functions add up to 409/400, those of degree n - 1 to 1.
TEST(DmsPaper, FormOfDegreeNAddsUpTo409Over400) {
  DmsModel model;
  model.degree = 2;
  model.clouds = {{{0, 0, 0}, {-2, -1, 1}, {0, 0, 0}},
                  {{4, 0, 0}, {6, -1, 1}, {4, 0, 0}},
                  {{2, 2, 0}},
                  {{2, 1, -2}},
                  {{2, ratio(-4, 5), ratio(4, 5)}},
                  {{ratio(21, 10), ratio(-4, 5), ratio(4, 5)}},
                  {{2, ratio(-7, 10), ratio(4, 5)}},
                  {{2, ratio(-4, 5), ratio(9, 10)}}};
  model.tetrahedra = {{1, 0, 2, 3}, {4, 5, 6, 7}};
  set_control_by_rule(model, DmsControlRule::kGreville, {});
  EXPECT_EQ(find_dms_defects(model).count, 0u);
  // With separate control points the conditions go to n, and (c) is broken there.
  const DmsDefects defects = find_dms_defects(internal::separated(model));
  ASSERT_EQ(defects.count, 1u);
  EXPECT_EQ(defects.first[0].fault, DmsFault::kInside);
  DmsEvaluator evaluator(model);
  const DmsPoint u{ratio(81, 40), ratio(-31, 40), ratio(33, 40)};
  const auto place = evaluator.locate(u);
  ASSERT_TRUE(place.has_value());
  EXPECT_EQ(place->tetrahedron, 1u);
  EXPECT_EQ(basis_sum(evaluator, *place, 1), Rational(1));
  EXPECT_EQ(basis_sum(evaluator, *place, 2), ratio(409, 400));
  EXPECT_EQ(evaluator.evaluate(*place).value, (std::vector<Rational>{u[0], u[1], u[2]}));
}

}  // namespace
}  // namespace veritope
