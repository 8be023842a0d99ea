// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/dms/fast/fold_search.h"

#include <gtest/gtest.h>

#include "solids/dms/dms_evaluator.h"
#include "solids/dms/dms_knots.h"
#include "solids/dms/dms_make.h"
#include "tests/predicates/test_scale.h"
#include "tests/support/random_dms.h"

namespace veritope {
namespace {

Rational ratio(long p, long q) { return Rational(p) / Rational(q); }

DmsModel cubes(int degree, const Rational& clouds) {
  std::optional<DmsCloudDraw> draw;
  if (clouds != Rational(0)) draw = DmsCloudDraw{clouds, 5};
  return make_dms(kuhn_domain({2, 2, 2}), {degree, draw, DmsControlRule::kGreville}).value();
}
// The control points after x -> x (1 - x / to): folded where the image's x would be beyond to / 2.
DmsModel bent(DmsModel model, const Rational& to) {
  for (std::size_t i = 0; i < model.num_control(); ++i) {
    Rational& x = model.control.values[3 * i];
    x = x * (Rational(1) - x / to);
  }
  return model;
}

void expect_fold(const DmsModel& model, const std::optional<DmsFold>& fold) {
  ASSERT_TRUE(fold.has_value());
  DmsEvaluator evaluator(model);
  const auto place = evaluator.locate(fold->at);
  ASSERT_TRUE(place.has_value());
  EXPECT_EQ(place->tetrahedron, fold->tetrahedron);
  const auto g = evaluator.evaluate(*place).gradient;
  EXPECT_EQ(dot_product(g[0], cross_product(g[1], g[2])), fold->determinant);
  EXPECT_EQ(fold->determinant.sign(), Sign::kNegative);
}

TEST(FoldSearch, FindsFoldsInEveryDegree) {
  for (const int degree : {1, 2, 3, 4})
    for (const Rational& clouds : {Rational(0), ratio(1, 10)}) {
      if (degree == 1 && clouds != Rational(0)) continue;
      SCOPED_TRACE(degree);
      const DmsModel flat = cubes(degree, clouds);
      EXPECT_FALSE(find_fold(flat).has_value());
      // The cube is two wide, and x (1 - x / to) turns over at to / 2.
      const DmsModel model = bent(flat, degree == 1 ? ratio(5, 2) : Rational(3));
      expect_fold(model, find_fold(model));
    }
}

TEST(FoldSearch, EndsAtItsLimits) {
  const DmsModel model = bent(cubes(2, ratio(1, 10)), Rational(2));
  expect_fold(model, find_fold(model));
  EXPECT_FALSE(find_fold(model, 0, {0, 512}).has_value());
  const auto last = static_cast<std::uint32_t>(model.tetrahedra.size() - 1);
  const auto fold = find_fold(model, last);
  if (fold) expect_fold(model, fold);
}

TEST(FoldSearch, GivesTheSameAnswerAgain) {
  const DmsModel model = bent(cubes(3, ratio(1, 10)), ratio(7, 2));
  const auto first = find_fold(model), again = find_fold(model);
  expect_fold(model, first);
  ASSERT_TRUE(again.has_value());
  EXPECT_EQ(first->at, again->at);
  EXPECT_EQ(first->determinant, again->determinant);
}

// At the greatest exponents FastDms has no tables, and evaluates exactly.
TEST(FoldSearch, WorksAtEveryScale) {
  for (const int exponent : {-900, -300, -40, 40, 300, 900}) {
    SCOPED_TRACE(exponent);
    DmsModel domain = kuhn_domain({1, 1, 1});
    for (DmsCloud& cloud : domain.clouds)
      for (DmsPoint& p : cloud)
        for (Rational& x : p) x *= Rational::power_of_two(exponent);
    const DmsModel model = make_dms(domain, {2, std::nullopt, DmsControlRule::kGreville}).value();
    EXPECT_FALSE(find_fold(model).has_value());
    const DmsModel folded = bent(model, Rational::power_of_two(exponent));
    expect_fold(folded, find_fold(folded));
  }
}

}  // namespace
}  // namespace veritope
