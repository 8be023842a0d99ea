// SPDX-License-Identifier: LGPL-3.0-or-later
// Laws of triangular Bernstein forms, exactly in rationals. The oracle sums the Bernstein polynomials as textbooks write them.
#include "splines/bezier_triangle.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "splines/bezier_triangle_algebra.h"
#include "tests/splines/composition_draw.h"

namespace veritope {
namespace {

using Triangle = BezierTriangle<Rational>;
using Point = Barycentric<Rational>;

Rational power(const Rational& x, int n) {
  Rational r(1);
  for (int i = 0; i < n; ++i) r *= x;
  return r;
}
Rational factorial(int n) { return n < 2 ? Rational(1) : factorial(n - 1) * Rational(n); }

std::vector<Rational> textbook_value(const Triangle& map, const Point& at) {
  std::vector<Rational> values;
  for (int c = 0; c < map.num_components(); ++c) {
    Rational sum;
    std::size_t next = 0;
    for (int row = 0; row <= map.degree(); ++row)
      for (int k = 0; k <= row; ++k) {
        const int i = map.degree() - row, j = row - k;
        sum += factorial(map.degree()) / (factorial(i) * factorial(j) * factorial(k)) *
               power(at[0], i) * power(at[1], j) * power(at[2], k) * map.component(c)[next++];
      }
    values.push_back(sum);
  }
  return values;
}

Triangle draw_triangle(Random& random, int degree, int dimension, bool is_rational) {
  Triangle map(degree, dimension + is_rational, is_rational);
  for (Rational& v : map.coefficients()) v = draw_rational(random);
  if (is_rational)
    for (Rational& w : map.component(dimension)) w = Rational(random.between(1, 9)) / Rational(4);
  return map;
}
Point draw_point(Random& random) {
  const Rational u = draw_rational(random), v = draw_rational(random);
  return {u, v, Rational(1) - u - v};
}
Point mix(const std::array<Point, 3>& corners, const Point& at) {
  Point p;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t c = 0; c < 3; ++c) p[i] += at[c] * corners[c][i];
  return p;
}

class BezierTriangleLaw : public testing::TestWithParam<int> {
 protected:
  Random random_{static_cast<std::uint64_t>(GetParam())};
  const Triangle map_ = draw_triangle(random_, GetParam(), 2, GetParam() % 2 == 1);
};

TEST_P(BezierTriangleLaw, EvaluationIsTheSumOfBernsteinPolynomials) {
  for (int k = 0; k < 5; ++k) {
    const Point p = draw_point(random_);
    EXPECT_EQ(evaluate(map_, p), textbook_value(map_, p));
  }
}

TEST_P(BezierTriangleLaw, BlossomIsSymmetricAndAffine) {
  std::vector<Point> arguments;
  for (int i = 0; i < map_.degree(); ++i) arguments.push_back(draw_point(random_));
  const auto value = blossom<Rational>(map_, arguments);
  std::rotate(arguments.begin(), arguments.begin() + (arguments.empty() ? 0 : 1), arguments.end());
  EXPECT_EQ(blossom<Rational>(map_, arguments), value);
  if (arguments.empty()) return;
  const Point a = draw_point(random_), b = draw_point(random_);
  const Rational t = draw_rational(random_), s = Rational(1) - t;
  auto with = [&](const Point& p) {
    arguments[0] = p;
    return blossom<Rational>(map_, arguments);
  };
  const auto at_a = with(a), at_b = with(b),
             between = with({s * a[0] + t * b[0], s * a[1] + t * b[1], s * a[2] + t * b[2]});
  for (std::size_t c = 0; c < between.size(); ++c) EXPECT_EQ(between[c], s * at_a[c] + t * at_b[c]);
}

TEST_P(BezierTriangleLaw, SplittingAtAPointKeepsTheMap) {
  const Point p = draw_point(random_), at = draw_point(random_);
  const auto parts = split_at(map_, p);
  for (std::size_t e = 0; e < 3; ++e) {
    std::array<Point, 3> corners{Point{1, 0, 0}, Point{0, 1, 0}, Point{0, 0, 1}};
    corners[e] = p;
    EXPECT_EQ(evaluate(parts[e], at), evaluate(map_, mix(corners, at))) << "part " << e;
    EXPECT_EQ(parts[e], restricted(map_, corners)) << "part " << e;
  }
}

TEST_P(BezierTriangleLaw, SplittingInFourKeepsTheMap) {
  const Rational h = Rational(1) / Rational(2);
  const Point c0{1, 0, 0}, c1{0, 1, 0}, c2{0, 0, 1}, m0{0, h, h}, m1{h, 0, h}, m2{h, h, 0};
  const std::array<Point, 3> corners[] = {{c0, m2, m1}, {m2, c1, m0}, {m1, m0, c2}, {m0, m1, m2}};
  const auto parts = split_in_four(map_);
  for (std::size_t i = 0; i < 4; ++i) {
    const Point at = draw_point(random_);
    EXPECT_EQ(evaluate(parts[i], at), evaluate(map_, mix(corners[i], at))) << "part " << i;
  }
}

TEST_P(BezierTriangleLaw, RestrictionKeepsTheMapOnCollapsedTrianglesToo) {
  std::array<Point, 3> corners{draw_point(random_), draw_point(random_), draw_point(random_)};
  const Point at = draw_point(random_);
  EXPECT_EQ(evaluate(restricted(map_, corners), at), evaluate(map_, mix(corners, at)));
  corners[2] = corners[1];
  EXPECT_EQ(evaluate(restricted(map_, corners), at), evaluate(map_, mix(corners, at)));
}

TEST_P(BezierTriangleLaw, ElevationKeepsTheMap) {
  const Point at = draw_point(random_);
  const auto up = elevated_to(map_, map_.degree() + 2);
  EXPECT_EQ(up.degree(), map_.degree() + 2);
  EXPECT_EQ(evaluate(up, at), evaluate(map_, at));
}

// A polynomial of degree n along a line is the sum of its Taylor terms.
TEST_P(BezierTriangleLaw, DerivativesMakeTheTaylorSeries) {
  const Point at = draw_point(random_);
  const Rational x = draw_rational(random_), y = draw_rational(random_);
  const Point d{x, y, -x - y};
  std::vector<Rational> sum(static_cast<std::size_t>(map_.num_components()));
  Triangle derivative = map_;
  for (int k = 0; k <= map_.degree() + 1; ++k) {
    const auto term = evaluate(derivative, at);
    for (std::size_t c = 0; c < sum.size(); ++c) sum[c] += term[c] / factorial(k);
    derivative = directional_derivative(derivative, d);
  }
  EXPECT_EQ(sum, evaluate(map_, {at[0] + d[0], at[1] + d[1], at[2] + d[2]}));
}

TEST_P(BezierTriangleLaw, ProductAgreesWithEvaluation) {
  const Triangle other = draw_triangle(random_, 3, 2, map_.is_rational()),
                 scalar = draw_triangle(random_, 2, 1, false);
  const Point at = draw_point(random_);
  const auto a = evaluate(map_, at), b = evaluate(other, at), s = evaluate(scalar, at);
  const auto both = evaluate(product(map_, other), at),
             scaled = evaluate(product(scalar, map_), at);
  for (std::size_t c = 0; c < a.size(); ++c) {
    EXPECT_EQ(both[c], a[c] * b[c]);
    EXPECT_EQ(scaled[c], c == 2 ? a[c] : s[0] * a[c]);
  }
}

TEST_P(BezierTriangleLaw, DerivativeOfAProductIsLeibnizs) {
  const Triangle f = draw_triangle(random_, GetParam(), 1, false),
                 g = draw_triangle(random_, 2, 1, false);
  const Point d{2, -3, 1}, at = draw_point(random_);
  EXPECT_EQ(evaluate(directional_derivative(product(f, g), d), at),
            evaluate(sum(product(directional_derivative(f, d), g),
                         product(f, directional_derivative(g, d))),
                     at));
}

TEST_P(BezierTriangleLaw, SumAgreesWithEvaluation) {
  for (const bool is_rational : {false, true}) {
    const Triangle other = draw_triangle(random_, 2, 2, is_rational);
    const Point at = draw_point(random_);
    const auto total = evaluate(sum(map_, other), at), a = evaluate(map_, at),
               b = evaluate(other, at);
    const Rational wa = map_.is_rational() ? a[2] : Rational(1),
                   wb = is_rational ? b[2] : Rational(1);
    ASSERT_EQ(total.size(), is_rational || map_.is_rational() ? 3u : 2u);
    for (std::size_t c = 0; c < 2; ++c) EXPECT_EQ(total[c], a[c] * wb + b[c] * wa);
    if (total.size() == 3) {
      EXPECT_EQ(total[2], wa * wb);
    }
  }
}

TEST_P(BezierTriangleLaw, BoundaryCurvesAreTheMapOnTheEdges) {
  const Rational t = draw_rational(random_);
  for (int e = 0; e < 3; ++e) {
    Point at{0, 0, 0};
    at[static_cast<std::size_t>((e + 1) % 3)] = Rational(1) - t;
    at[static_cast<std::size_t>((e + 2) % 3)] = t;
    EXPECT_EQ(evaluate(boundary_curve(map_, e), {t}), evaluate(map_, at)) << "edge " << e;
  }
}

TEST_P(BezierTriangleLaw, AffineImagesAreThoseOfThePoints) {
  const std::vector<Rational> matrix{1, 2, -3, 5, 0, Rational(1) / Rational(7)}, shift{4, -1, 2};
  const Point at = draw_point(random_);
  const auto p = evaluate(map_, at);
  const auto image = evaluate(affine_image<Rational>(map_, matrix, shift), at);
  const Rational w = map_.is_rational() ? p[2] : Rational(1);
  ASSERT_EQ(image.size(), map_.is_rational() ? 4u : 3u);
  for (std::size_t r = 0; r < 3; ++r)
    EXPECT_EQ(image[r], matrix[2 * r] * p[0] + matrix[2 * r + 1] * p[1] + shift[r] * w);
  if (map_.is_rational()) {
    EXPECT_EQ(image[3], w);
  }
}

TEST_P(BezierTriangleLaw, TensorProductHasTheSamePoints) {
  const auto patch = as_tensor_product(map_);
  const Rational s = draw_rational(random_), t = draw_rational(random_), one(1);
  EXPECT_EQ(evaluate(patch, {s, t}), evaluate(map_, {one - s, s * (one - t), s * t}));
  EXPECT_EQ(evaluate(patch, {0, t}), evaluate(map_, {1, 0, 0}));
}

INSTANTIATE_TEST_SUITE_P(Degrees, BezierTriangleLaw, testing::Range(0, 8));

TEST(BezierTriangle, OfATensorProductHasItsPoints) {
  for (std::uint64_t seed = 0; seed < 12; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const auto surface = draw_map<2>(random, draw_degrees<2>(random, 3), 2, seed % 2 == 0);
    std::array<std::array<Rational, 2>, 3> corners;
    for (auto& c : corners) c = {draw_rational(random), draw_rational(random)};
    const auto triangle = on_triangle(surface, corners);
    EXPECT_EQ(triangle.degree(), surface.degree(0) + surface.degree(1));
    const Point at = draw_point(random);
    std::array<Rational, 2> p;
    for (std::size_t a = 0; a < 2; ++a)
      for (std::size_t c = 0; c < 3; ++c) p[a] += at[c] * corners[c][a];
    EXPECT_EQ(evaluate(triangle, at), evaluate(surface, p));
  }
}

// The integral of u^i v^j w^k over the triangle is i! j! k! / (i + j + k + 2)!.
TEST(BezierTriangle, IntegralIsThatOfMonomials) {
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j)
      for (int k = 0; k < 4; ++k) {
        Triangle map(i + j + k, 1, false);
        map.component(0)[triangle_index(j, k)] =
            factorial(i) * factorial(j) * factorial(k) / factorial(i + j + k);
        EXPECT_EQ(integral(map)[0],
                  factorial(i) * factorial(j) * factorial(k) / factorial(i + j + k + 2));
      }
}

TEST(BezierTriangle, IntegralIsTheSumOfItsParts) {
  Random random(3);
  const Triangle map = draw_triangle(random, 4, 1, false);
  Rational total;
  for (const Triangle& part : split_in_four(map)) total += integral(part)[0] / Rational(4);
  EXPECT_EQ(total, integral(map)[0]);
}

TEST(BezierTriangle, BernsteinPolynomialsAddUpToOne) {
  for (int n = 0; n < 8; ++n) {
    const Triangle ones(n, 1, false,
                        std::vector<Rational>(num_triangle_coefficients(n), Rational(1)));
    EXPECT_EQ(
        evaluate(ones, {Rational(1) / Rational(3), Rational(5), Rational(-13) / Rational(3)})[0],
        Rational(1));
  }
}

TEST(MakeBezierTriangle, NamesWhatIsWrong) {
  const auto message = [](auto result) { return result.error().message; };
  const std::vector<Rational> ten(10);
  EXPECT_TRUE(make_bezier_triangle(3, 1, false, ten));
  EXPECT_EQ(message(make_bezier_triangle(3, 2, false, ten)),
            "10 coefficients instead of 2 times 10");
  EXPECT_EQ(message(make_bezier_triangle(2, 1, false, ten)),
            "10 coefficients instead of 1 times 6");
  EXPECT_EQ(message(make_bezier_triangle(-1, 1, false, ten)),
            "a triangle of degree -1 with 1 components");
  EXPECT_EQ(message(make_bezier_triangle(3, 1, true, ten)),
            "a triangle of degree 3 with 1 components");
  EXPECT_EQ(make_bezier_triangle(64, 1, false, ten).error().code, Code::kOverLimit);
}

TEST(BezierTriangle, ChecksWhatCallersPromise) {
  const Triangle cubic(3, 1, false), weighted(3, 2, true);
  EXPECT_THROW((Triangle(3, 1, false, std::vector<Rational>(9))), InternalError);
  EXPECT_THROW(blossom<Rational>(cubic, {}), InternalError);
  EXPECT_THROW(integral(weighted), InternalError);
  EXPECT_THROW(product(weighted, cubic), InternalError);
  EXPECT_THROW(sum(cubic, Triangle(3, 2, false)), InternalError);
}

}  // namespace
}  // namespace veritope
