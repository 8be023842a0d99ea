// SPDX-License-Identifier: LGPL-3.0-or-later
// Laws of the algebra of Bezier maps, in rationals: equal means equal.
#include <gtest/gtest.h>

#include "splines/affine_map.h"
#include "splines/bezier_calculus.h"
#include "splines/bezier_degree.h"
#include "splines/bezier_domain.h"
#include "splines/bezier_product.h"
#include "splines/blossom.h"
#include "splines/de_boor.h"
#include "tests/splines/draw.h"

namespace veritope {
namespace {

using Values = std::vector<Rational>;

TEST(BezierLaw, ValuesAreTheSumsOfBernsteinPolynomials) {
  for_all_dimensions(10, 40, [](Random& random, auto n) {
    const auto map = draw_bezier<n>(random, 5, 2);
    SCOPED_TRACE(text_of(map));
    const auto at = draw_point<n>(random);
    Values sums(2), ones(1);
    for (std::size_t i = 0; i < map.grid().count(); ++i) {
      const auto index = map.grid().index_of(i);
      Rational basis(1);
      for (std::size_t a = 0; a < n; ++a) {
        const int k = static_cast<int>(index[a]);
        basis *= Rational(binomial(map.degree(a), k));
        for (int m = 0; m < map.degree(a); ++m) basis *= m < k ? at[a] : Rational(1) - at[a];
      }
      ones[0] += basis;
      for (int c = 0; c < 2; ++c) sums[static_cast<std::size_t>(c)] += basis * map.component(c)[i];
    }
    EXPECT_EQ(evaluate(map, at), sums);
    EXPECT_EQ(ones[0], Rational(1));
  });
}

TEST(BezierLaw, ElevationLeavesTheMapUnchanged) {
  for_all_dimensions(20, 40, [](Random& random, auto n) {
    const auto map = draw_bezier<n>(random, 4, 3, true);
    SCOPED_TRACE(text_of(map));
    const std::size_t axis = random.below(n);
    const int by = draw_int(random, 0, 5);
    const auto raised = elevate(map, axis, by);
    EXPECT_EQ(raised.degree(axis), map.degree(axis) + by);
    EXPECT_TRUE(raised.is_rational());
    const auto at = draw_point<n>(random);
    EXPECT_EQ(evaluate(raised, at), evaluate(map, at));
    EXPECT_EQ(elevate(elevate(map, axis, 1), axis, 2), elevate(map, axis, 3));
  });
}

TEST(BezierLaw, EqualMapsHaveEqualCoefficientsInCommonDegrees) {
  for_all_dimensions(30, 20, [](Random& random, auto n) {
    const auto map = draw_bezier<n>(random, 3, 2);
    auto a = elevate(map, 0, draw_int(random, 0, 3)),
         b = elevate(map, n - 1, draw_int(random, 0, 3));
    const auto [x, y] = to_common_degrees(a, b);
    EXPECT_EQ(x, y) << text_of(map);
    b.coefficients()[random.below(b.coefficients().size())] += Rational(1);
    const auto [z, w] = to_common_degrees(a, b);
    EXPECT_NE(z, w) << text_of(map);
  });
}

TEST(BezierLaw, PartsReversedAndPermutedMapsTakeTheValuesOfTheMap) {
  for_all_dimensions(40, 40, [](Random& random, auto n) {
    const auto map = draw_bezier<n>(random, 4, 2);
    SCOPED_TRACE(text_of(map));
    const std::size_t axis = random.below(n), other = random.below(n);
    auto at = draw_point<n>(random), to = at;
    // Any part, also one that sticks out of [0, 1].
    const Rational a = draw_parameter(random) * fraction(3, 2) - fraction(1, 4);
    const Rational b = a + draw_parameter(random) + fraction(1, 7);
    to[axis] = a + at[axis] * (b - a);
    EXPECT_EQ(evaluate(restricted(map, axis, a, b), at), evaluate(map, to)) << a.to_string();
    to = at, to[axis] = Rational(1) - at[axis];
    EXPECT_EQ(evaluate(reversed(map, axis), at), evaluate(map, to));
    EXPECT_EQ(reversed(reversed(map, axis), axis), map);
    to = at, std::swap(to[axis], to[other]);
    EXPECT_EQ(evaluate(swapped(map, axis, other), at), evaluate(map, to));
  });
}

TEST(BezierLaw, CyclicPermutationMovesAxisOrderOfIToI) {
  for_loops(45, 20, [](Random& random) {
    const auto map = draw_bezier<3>(random, 3, 2);
    const auto at = draw_point<3>(random);
    const auto turned = permuted(map, std::array<std::size_t, 3>{2, 0, 1});
    EXPECT_EQ(turned.degree(0), map.degree(2));
    EXPECT_EQ(evaluate(turned, {at[2], at[0], at[1]}), evaluate(map, at)) << text_of(map);
  });
}

TEST(BezierLaw, IsoparametricMapsAndBoundariesFixOneVariable) {
  for_loops(50, 40, [](Random& random) {
    const auto volume = draw_bezier<3>(random, 3, 2);
    SCOPED_TRACE(text_of(volume));
    const auto at = draw_point<3>(random);
    EXPECT_EQ(evaluate(isoparametric(volume, 0, at[0]), {at[1], at[2]}), evaluate(volume, at));
    EXPECT_EQ(evaluate(isoparametric(volume, 1, at[1]), {at[0], at[2]}), evaluate(volume, at));
    EXPECT_EQ(evaluate(isoparametric(volume, 2, at[2]), {at[0], at[1]}), evaluate(volume, at));
    for (std::size_t axis = 0; axis < 3; ++axis)
      for (int end = 0; end < 2; ++end)
        EXPECT_EQ(boundary(volume, axis, end), isoparametric(volume, axis, Rational(end)));
  });
}

TEST(BezierLaw, ProductsAndSumsAreThoseOfTheValues) {
  for_all_dimensions(60, 24, [](Random& random, auto n) {
    const bool a_rational = random.below(2) == 0, b_rational = random.below(2) == 0;
    const auto a = draw_bezier<n>(random, 3, 3 + a_rational, a_rational);
    const auto b = draw_bezier<n>(random, 3, 3 + b_rational, b_rational);
    const auto s = draw_bezier<n>(random, 2, 1 + b_rational, b_rational);
    SCOPED_TRACE(text_of(a) + " | " + text_of(b) + " | " + text_of(s));
    const auto at = draw_point<n>(random);
    const Values x = point(a, at), y = point(b, at), f = point(s, at);
    const Values products = point(componentwise_product(a, b), at), sums = point(sum(a, b), at),
                 differences = point(difference(a, b), at), scaled = point(multiplied(s, a), at);
    for (std::size_t c = 0; c < 3; ++c) {
      EXPECT_EQ(products[c], x[c] * y[c]);
      EXPECT_EQ(sums[c], x[c] + y[c]);
      EXPECT_EQ(differences[c], x[c] - y[c]);
      EXPECT_EQ(scaled[c], f[0] * x[c]);
    }
    if (a_rational || b_rational) return;
    EXPECT_EQ(point(dot(a, b), at)[0], x[0] * y[0] + x[1] * y[1] + x[2] * y[2]);
    EXPECT_EQ(point(cross(a, b), at), (Values{x[1] * y[2] - x[2] * y[1], x[2] * y[0] - x[0] * y[2],
                                              x[0] * y[1] - x[1] * y[0]}));
  });
}

TEST(BezierLaw, ScaledCoefficientsGoThereAndBack) {
  for_all_dimensions(65, 12, [](Random& random, auto n) {
    const auto map = draw_bezier<n>(random, 5, 2);
    EXPECT_EQ(from_scaled(to_scaled(map)), map) << text_of(map);
  });
}

TEST(BezierLaw, DerivativesAreLinearAndObeyLeibniz) {
  for_all_dimensions(70, 24, [](Random& random, auto n) {
    const auto a = draw_bezier<n>(random, 3, 3), b = draw_bezier<n>(random, 3, 3);
    SCOPED_TRACE(text_of(a) + " | " + text_of(b));
    const std::size_t axis = random.below(n);
    const auto rule = sum(dot(derivative(a, axis), b), dot(a, derivative(b, axis)));
    const auto [x, y] = to_common_degrees(derivative(dot(a, b), axis), rule);
    EXPECT_EQ(x, y);
    const auto [v, w] = to_common_degrees(derivative(sum(a, b), axis),
                                          sum(derivative(a, axis), derivative(b, axis)));
    EXPECT_EQ(v, w);
  });
}

TEST(BezierLaw, DerivativeOfAMonomialIsTheNextOne) {
  for (const int n : {1, 2, 5, 63}) {
    // u^n has one coefficient 1, the last; of u^(n-1), of degree n - 1, too.
    Bezier<Rational, 1> power({n}, 1, false);
    power.component(0).back() = Rational(1);
    Bezier<Rational, 1> expected({n - 1}, 1, false);
    expected.component(0).back() = Rational(n);
    EXPECT_EQ(derivative(power, 0), expected);
  }
}

// The derivative d of x = P / w is the one that solves (x w)' = P': d w + x w' = P'.
TEST(BezierLaw, DerivativeOfARationalMapSolvesTheProductRule) {
  for_all_dimensions(80, 24, [](Random& random, auto n) {
    const auto map = draw_bezier<n>(random, 3, 3, true);
    SCOPED_TRACE(text_of(map));
    const std::size_t axis = random.below(n);
    const auto at = draw_point<n>(random);
    const Values x = point(map, at), d = point(derivative(map, axis), at);
    const Values w = evaluate(weight(map), at), dw = evaluate(derivative(weight(map), axis), at),
                 dp = evaluate(derivative(numerators(map), axis), at);
    for (std::size_t c = 0; c < 2; ++c) EXPECT_EQ(d[c] * w[0] + x[c] * dw[0], dp[c]);
  });
}

TEST(BezierLaw, AntiderivativeUndoesTheDerivativeAndGivesTheIntegral) {
  for_all_dimensions(90, 24, [](Random& random, auto n) {
    const auto map = draw_bezier<n>(random, 4, 2);
    SCOPED_TRACE(text_of(map));
    const std::size_t axis = random.below(n);
    EXPECT_EQ(derivative(antiderivative(map, axis), axis), map);
    auto all = map;
    for (std::size_t a = 0; a < n; ++a) all = antiderivative(all, a);
    std::array<Rational, n> ends;
    ends.fill(Rational(1));
    EXPECT_EQ(integral(map), evaluate(all, ends));
    auto begin = draw_point<n>(random);
    begin[axis] = Rational(0);
    EXPECT_EQ(evaluate(antiderivative(map, axis), begin), (Values{Rational(0), Rational(0)}));
  });
}

TEST(BezierLaw, BlossomIsTheMapOnTheDiagonalSymmetricAndAffineInEveryArgument) {
  for_all_dimensions(100, 24, [](Random& random, auto n) {
    const auto map = draw_bezier<n>(random, 4, 2);
    SCOPED_TRACE(text_of(map));
    const auto at = draw_point<n>(random);
    std::array<Values, n> diagonal, arguments;
    for (std::size_t a = 0; a < n; ++a) {
      diagonal[a].assign(static_cast<std::size_t>(map.degree(a)), at[a]);
      for (int i = 0; i < map.degree(a); ++i) arguments[a].push_back(draw_rational(random));
    }
    EXPECT_EQ(blossom(map, diagonal), evaluate(map, at));
    const std::size_t axis = random.below(n);
    if (map.degree(axis) == 0) return;
    auto turned = arguments;
    std::rotate(turned[axis].begin(), turned[axis].begin() + 1, turned[axis].end());
    EXPECT_EQ(blossom(map, turned), blossom(map, arguments));
    const std::size_t i = random.below(arguments[axis].size());
    const Rational t = draw_rational(random), u = draw_rational(random), v = draw_rational(random);
    auto with = [&](const Rational& value) {
      auto changed = arguments;
      changed[axis][i] = value;
      return blossom(map, changed);
    };
    const Values at_u = with(u), at_v = with(v), between = with((Rational(1) - t) * u + t * v);
    for (std::size_t c = 0; c < 2; ++c)
      EXPECT_EQ(between[c], (Rational(1) - t) * at_u[c] + t * at_v[c]);
  });
}

TEST(BezierLaw, CoefficientsAreBlossomsOfZerosAndOnes) {
  for_loops(105, 12, [](Random& random) {
    const auto map = draw_bezier<2>(random, 4, 1);
    for (std::size_t i = 0; i < map.grid().count(); ++i) {
      const auto index = map.grid().index_of(i);
      std::array<Values, 2> arguments;
      for (std::size_t a = 0; a < 2; ++a)
        for (std::size_t k = 0; k + 1 < map.grid().size[a]; ++k)
          arguments[a].push_back(Rational(k < index[a] ? 1 : 0));
      EXPECT_EQ(blossom(map, arguments)[0], map.component(0)[i]) << text_of(map);
    }
  });
}

TEST(BezierLaw, AffineMapsActOnPoints) {
  for_all_dimensions(110, 24, [](Random& random, auto n) {
    const bool is_rational = random.below(2) == 0;
    const auto map = draw_bezier<n>(random, 3, 2 + is_rational, is_rational);
    SCOPED_TRACE(text_of(map));
    AffineMap affine{3, 2, {}, {}};
    for (int i = 0; i < 6; ++i) affine.linear.push_back(draw_rational(random));
    for (int i = 0; i < 3; ++i) affine.translation.push_back(draw_rational(random));
    const auto at = draw_point<n>(random);
    const Values x = point(map, at), y = point(transformed(map, affine), at);
    ASSERT_EQ(y.size(), 3u);
    for (std::size_t r = 0; r < 3; ++r)
      EXPECT_EQ(y[r], affine.linear[2 * r] * x[0] + affine.linear[2 * r + 1] * x[1] +
                          affine.translation[r]);
  });
}

TEST(BezierLaw, DegreeSixtyThreeWorks) {
  Random random(120);
  Bezier<Rational, 1> map({kMaxSplineDegree}, 1, false,
                          draw_coefficients(random, kMaxSplineDegree + 1, 1, false));
  const std::array<Rational, 1> at{fraction(2, 3)};
  const Rational x = evaluate(map, at)[0];
  EXPECT_EQ(evaluate(elevate(map, 0, kMaxSplineDegree), at)[0], x);
  EXPECT_EQ(evaluate(dot(map, map), at)[0], x * x);
  EXPECT_EQ(derivative(antiderivative(map, 0), 0), map);
  EXPECT_EQ(evaluate(restricted(map, 0, fraction(1, 3), fraction(1)), {fraction(1, 2)})[0], x);
}

TEST(BezierRequires, IsCheckedWhereACallerCanBreakIt) {
  const Bezier<Rational, 1> line({1}, 2, false), rational({1}, 2, true), space({1}, 3, false);
  EXPECT_THROW(elevate(line, 0, -1), InternalError);
  EXPECT_THROW(restricted(line, 0, fraction(1), fraction(1)), InternalError);
  EXPECT_THROW(dot(line, rational), InternalError);
  EXPECT_THROW(dot(line, space), InternalError);
  EXPECT_THROW(cross(line, line), InternalError);
  EXPECT_THROW(sum(line, space), InternalError);
  EXPECT_THROW(difference(line, space), InternalError);
  EXPECT_THROW(componentwise_product(line, space), InternalError);
  EXPECT_THROW(multiplied(line, space), InternalError);
  EXPECT_THROW(integral(rational), InternalError);
  EXPECT_THROW(antiderivative(rational, 0), InternalError);
  EXPECT_THROW(blossom(line, {Values{}}), InternalError);
  EXPECT_THROW(components(line, 1, 2), InternalError);
  EXPECT_THROW(joined(rational, line), InternalError);
  EXPECT_THROW(quotient(line, line), InternalError);
  EXPECT_THROW(transformed(line, AffineMap{1, 3, Values(3), Values(1)}), InternalError);
  EXPECT_THROW(transformed(line, AffineMap{1, 2, Values(3), Values(1)}), InternalError);
}

}  // namespace
}  // namespace veritope
