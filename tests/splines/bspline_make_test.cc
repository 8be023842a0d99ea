// SPDX-License-Identifier: LGPL-3.0-or-later
#include "splines/bspline_make.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "splines/bspline_domain.h"
#include "splines/bspline_pieces.h"
#include "splines/de_boor.h"
#include "splines/knot_insertion.h"
#include "tests/splines/draw.h"

namespace veritope {
namespace {

using Values = std::vector<Rational>;

Values integers(std::initializer_list<int> numbers) {
  return Values(numbers.begin(), numbers.end());
}

KnotAxis<Rational> axis(int degree, std::initializer_list<int> knots, bool is_periodic = false) {
  return {degree, integers(knots), is_periodic};
}

template <typename T>
void expect_error(const Result<T>& result, Code code, const std::string& message) {
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().code, code);
  EXPECT_EQ(result.error().message, message);
}

TEST(MakeBSpline, AcceptsCurvesSurfacesAndVolumes) {
  const auto line = axis(1, {0, 0, 1, 1});
  EXPECT_TRUE(make_bspline<1>({line}, 1, false, Values(2)));
  EXPECT_TRUE(make_bspline<2>({line, axis(2, {0, 0, 0, 1, 1, 1})}, 2, false, Values(12)));
  EXPECT_TRUE(make_bspline<3>({line, line, line}, 2, true, Values(16, Rational(1))));
}

TEST(MakeBSpline, NamesTheAxisOfBadKnots) {
  expect_error(make_bspline<2>({axis(1, {0, 0, 1, 1}), axis(1, {0, 0, 2, 1, 3})}, 1, false, {}),
               Code::kBadArgument, "axis 1: knot 3, 1, is less than the one before it, 2");
  expect_error(make_bspline<1>({axis(64, {})}, 1, false, {}), Code::kOverLimit,
               "axis 0: the degree 64 is over the limit 63");
}

TEST(MakeBSpline, CountsCoefficients) {
  const auto line = axis(1, {0, 0, 1, 2, 2});
  expect_error(make_bspline<2>({line, line}, 2, false, Values(17)), Code::kBadArgument,
               "17 coefficients for 3 x 3 control points of 2 components");
  expect_error(make_bspline<1>({line}, 0, false, {}), Code::kBadArgument,
               "0 components are too few for a polynomial map, which has at least 1");
  expect_error(make_bspline<1>({line}, 1, true, Values(3)), Code::kBadArgument,
               "1 components are too few for a rational map, which has at least 2");
  expect_error(make_bspline<1>({line}, -5, false, {}), Code::kBadArgument,
               "-5 components are too few for a polynomial map, which has at least 1");
}

TEST(Grid, CountsUpToALimitWithoutOverflow) {
  constexpr std::size_t kMost = ~std::size_t{0};
  const Grid<3> huge{{std::size_t{1} << 22, std::size_t{1} << 22, (std::size_t{1} << 22) + 1}};
  EXPECT_FALSE(huge.count_up_to(kMost));  // 2^66 + 2^44
  EXPECT_EQ((Grid<2>{{std::size_t{1} << 32, (std::size_t{1} << 32) - 1}}).count_up_to(kMost),
            kMost - ((std::size_t{1} << 32) - 1));
  EXPECT_EQ((Grid<3>{{2, 3, 4}}).count_up_to(24), 24u);
  EXPECT_FALSE((Grid<3>{{2, 3, 4}}).count_up_to(23));
  EXPECT_EQ((Grid<3>{{kMost, kMost, 0}}).count_up_to(0), 0u);
}

TEST(MakeBSpline, RefusesWeightsThatAreNotPositive) {
  const auto line = axis(1, {0, 0, 1, 1});
  Values values(12, Rational(1));
  EXPECT_TRUE((make_bspline<2>({line, line}, 3, true, values)));
  values[4] = Rational(-1);  // a coordinate may be anything
  EXPECT_TRUE((make_bspline<2>({line, line}, 3, true, values)));
  values[10] = Rational(0);
  expect_error(make_bspline<2>({line, line}, 3, true, values), Code::kBadArgument,
               "control point (1, 0): the weight 0 is not positive");
  values[9] = fraction(-1, 2);
  expect_error(make_bspline<2>({line, line}, 3, true, values), Code::kBadArgument,
               "control point (0, 1): the weight -1/2 is not positive");
}

TEST(MakeBSpline, ComparesControlPointsAcrossThePeriod) {
  const auto ring = axis(2, {-2, -1, 0, 1, 2, 3, 4, 5}, true);
  EXPECT_TRUE(make_bspline<1>({ring}, 1, false, integers({1, 2, 3, 1, 2})));
  expect_error(make_bspline<1>({ring}, 2, false, integers({1, 2, 3, 1, 2, 7, 8, 9, 7, 6})),
               Code::kBadArgument,
               "axis 0 is periodic, but control point (4) has the component 1 6 where that of the "
               "first period, control point (1), has 8");
}

const BSplineCurve<Rational> kTent({axis(1, {0, 0, 1, 2, 2})}, 1, false, integers({0, 1, 0}));

TEST(BSpline, RefusesParametersOutsideOfItsDomain) {
  const std::string message = "axis 0: the parameter 5/2 is not in the domain from 0 to 2";
  expect_error(evaluate(kTent, {fraction(5, 2)}), Code::kBadArgument, message);
  expect_error(point(kTent, {fraction(5, 2)}), Code::kBadArgument, message);
  expect_error(restricted(kTent, 0, fraction(1), fraction(5, 2)), Code::kBadArgument, message);
  expect_error(evaluate(kTent, {fraction(-1)}), Code::kBadArgument,
               "axis 0: the parameter -1 is not in the domain from 0 to 2");
  const BSplineSurface<double> square(
      {KnotAxis<double>{1, {0, 0, 1, 1}, false}, KnotAxis<double>{1, {0, 0, 1, 1}, false}}, 1,
      false, {0, 1, 2, 3});
  EXPECT_EQ(evaluate(square, {0.5, 0.25}).value(), std::vector<double>{1.25});
  expect_error(evaluate(square, {0.5, std::nan("")}), Code::kBadArgument,
               "axis 1: the parameter nan is not in the domain from 0 to 1");
  expect_error(isoparametric(square, 1, -0.1), Code::kBadArgument,
               "axis 1: the parameter -0.10000000000000001 is not in the domain from 0 to 1");
}

TEST(BSpline, RefusesEmptyDomains) {
  expect_error(restricted(kTent, 0, fraction(1), fraction(1)), Code::kBadArgument,
               "axis 0: a domain from 1 to 1 would be empty");
  expect_error(with_domain(kTent, 0, fraction(3), fraction(2)), Code::kBadArgument,
               "axis 0: a domain from 3 to 2 would be empty");
}

TEST(BSpline, RefusesDomainsInWhichRoundedKnotsWouldCollide) {
  const BSplineCurve<double> curve({KnotAxis<double>{1, {0, 0, 0x1p-60, 1, 1}, false}}, 1, false,
                                   {0, 1, 2});
  EXPECT_TRUE(with_domain(curve, 0, 0, 8));
  expect_error(with_domain(curve, 0, 1, 2), Code::kLossy,
               "axis 0: knot 2, 8.6736173798840355e-19, would be rounded to 1, which is no number "
               "between its neighbours");
  EXPECT_FALSE(with_domain(curve, 0, -0x1.8p1023, 0x1.8p1023));
  EXPECT_FALSE(with_domain(curve, 0, std::nan(""), 1));
}

TEST(BSpline, JumpsTakeTheValueFromTheRightAndAtTheEndFromTheLeft) {
  const BSplineCurve<Rational> steps({axis(1, {0, 0, 1, 1, 2, 2})}, 1, false,
                                     integers({0, 1, 5, 6}));
  EXPECT_EQ(evaluate(steps, {fraction(1)}).value(), integers({5}));
  EXPECT_EQ(evaluate(steps, {fraction(2)}).value(), integers({6}));
  EXPECT_EQ(evaluate(restricted(steps, 0, fraction(0), fraction(1)).value(), {fraction(1)}).value(),
            integers({1}));
}

TEST(BSpline, InsertionCopiesControlPointsThatAreNotBlended) {
  // 0 * infinity would be no number: nothing is multiplied with 0.
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  const BSplineCurve<double> curve({KnotAxis<double>{2, {0, 0, 0, 1, 1, 2, 2, 2}, false}}, 1, false,
                                   {kInfinity, 1, 0.1, 3, kInfinity});
  const auto refined = refine(curve, 0, {1});
  const std::vector<double> expected{kInfinity, 1, 0.1, 0.1, 3, kInfinity};
  EXPECT_EQ(std::vector<double>(refined.coefficients().begin(), refined.coefficients().end()),
            expected);
}

TEST(BSpline, ChecksWhatItRequires) {
  EXPECT_THROW(refine(kTent, 0, integers({1, 0})), InternalError);
  EXPECT_THROW(refine(kTent, 0, integers({3})), InternalError);
  EXPECT_THROW(refine(kTent, 0, integers({-1})), InternalError);
  EXPECT_THROW(refine(kTent, 0, integers({1, 1})), InternalError);
  EXPECT_THROW(insert_knot(kTent, 0, fraction(0)), InternalError);
  EXPECT_EQ(refine(kTent, 0, {}), kTent);
  const Bezier<Rational, 1> line({1}, 1, false);
  EXPECT_THROW(to_bspline(line, {fraction(1)}, {fraction(1)}), InternalError);
  BezierPieces<Rational, 1> mixed{{integers({0, 1, 2})},
                                  {line, Bezier<Rational, 1>({2}, 1, false)}};
  EXPECT_THROW(joined(mixed), InternalError);
}

TEST(WithoutKnots, NamesKnotsThatAreNotThere) {
  for (const Rational& u : {fraction(1, 2), fraction(0), fraction(2)})
    expect_error(
        without_knots(kTent, 0, {u}), Code::kBadArgument,
        "axis 0: " + u.to_string() + " is not a knot inside of the domain, or not as often");
  expect_error(without_knots(kTent, 0, integers({1, 1})), Code::kBadArgument,
               "axis 0: 1 is not a knot inside of the domain, or not as often");
  expect_error(without_knots(kTent, 0, integers({1})), Code::kLossy,
               "axis 0: without 1 knots, the first of them 1, the map would change");
  EXPECT_EQ(without_knots(kTent, 0, {}).value(), kTent);
}

}  // namespace
}  // namespace veritope
