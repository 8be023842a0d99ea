// SPDX-License-Identifier: LGPL-3.0-or-later
#include "splines/pn_triangle.h"

#include <gtest/gtest.h>

#include <cmath>

#include "splines/bezier_triangle_algebra.h"
#include "tests/splines/composition_draw.h"

namespace veritope {
namespace {

using Points = std::array<PnPoint, 3>;

Rational dot(const PnPoint& a, const PnPoint& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
PnPoint draw_point(Random& random) {
  return {draw_rational(random), draw_rational(random), draw_rational(random)};
}

// A triangle over the plane z = 0, counter-clockwise, with normals that point up; z of the corners is small.
struct Input {
  Points corners, normals;
};
Input draw_input(Random& random) {
  Input in;
  do {
    for (auto& p : in.corners) p = draw_point(random);
    for (auto& n : in.normals) n = draw_point(random);
  } while (!check_pn_triangle(PnCorners<Rational>{in.corners, in.normals}));
  return in;
}
PnPoint at(const BezierTriangle<Rational>& map, const Barycentric<Rational>& p) {
  const auto v = evaluate(map, p);
  return {v[0], v[1], v[2]};
}

constexpr int kUnit[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};

TEST(PnTriangle, InterpolatesCornersAndNormals) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const Input in = draw_input(random);
    const auto pn = make_pn_triangle(in.corners, in.normals);
    ASSERT_TRUE(pn);
    for (std::size_t i = 0; i < 3; ++i) {
      const Barycentric<Rational> corner{kUnit[i][0], kUnit[i][1], kUnit[i][2]};
      EXPECT_EQ(at(pn->points, corner), in.corners[i]);
      EXPECT_EQ(at(pn->normals, corner), in.normals[i]);
      for (const Barycentric<Rational>& d :
           {Barycentric<Rational>{1, -1, 0}, {0, 1, -1}, {3, 2, -5}})
        EXPECT_EQ(dot(at(directional_derivative(pn->points, d), corner), in.normals[i]),
                  Rational(0));
    }
  }
}

TEST(PnTriangle, OfAFlatTriangleIsFlat) {
  const Points corners{{{0, 0, 0}, {3, 0, 0}, {1, 5, 0}}};
  const PnPoint up{0, 0, 2};
  const auto pn = make_pn_triangle(corners, {up, up, up});
  const BezierTriangle<Rational> linear(1, 3, false, {0, 3, 1, 0, 0, 5, 0, 0, 0});
  EXPECT_EQ(pn->points, elevated_to(linear, 3));
  for (std::size_t i = 0; i < 6; ++i) EXPECT_EQ(pn->normals.component(2)[i], Rational(2));
}

TEST(PnTriangle, DoesNotDependOnTheLengthsOfNormals) {
  Random random(1);
  const Input in = draw_input(random);
  Points longer = in.normals;
  for (std::size_t i = 0; i < 3; ++i)
    for (Rational& v : longer[i]) v *= Rational(static_cast<int>(2 + i));
  EXPECT_EQ(make_pn_triangle(in.corners, in.normals)->points,
            make_pn_triangle(in.corners, longer)->points);
}

// Numbering the corners from another one turns the parameters; a reflected and reversed triangle has the reflected patch.
TEST(PnTriangle, TurnsWithItsCorners) {
  Random random(2);
  const Input in = draw_input(random);
  const auto pn = make_pn_triangle(in.corners, in.normals);
  const auto turned = make_pn_triangle({in.corners[1], in.corners[2], in.corners[0]},
                                       {in.normals[1], in.normals[2], in.normals[0]});
  const Barycentric<Rational> p{Rational(1) / Rational(2), Rational(1) / Rational(3),
                                Rational(1) / Rational(6)};
  EXPECT_EQ(at(pn->points, p), at(turned->points, {p[1], p[2], p[0]}));
  EXPECT_EQ(at(pn->normals, p), at(turned->normals, {p[1], p[2], p[0]}));
}

// Turned by an exact rotation, moved and doubled.
TEST(PnTriangle, MovesWithItsCorners) {
  const Rational c = Rational(3) / Rational(5), s = Rational(4) / Rational(5);
  const auto turn = [&](const PnPoint& v) {
    return PnPoint{c * v[0] - s * v[1], s * v[0] + c * v[1], v[2]};
  };
  Random random(3);
  const Input in = draw_input(random);
  Input moved;
  for (std::size_t i = 0; i < 3; ++i) {
    moved.corners[i] = turn(in.corners[i]), moved.normals[i] = turn(in.normals[i]);
    for (std::size_t k = 0; k < 3; ++k)
      moved.corners[i][k] = Rational(2) * moved.corners[i][k] + Rational(static_cast<int>(k));
  }
  const std::vector<Rational> matrix{c, -s, 0, s, c, 0, 0, 0, 1}, none{0, 0, 0}, shift{0, 1, 2};
  std::vector<Rational> doubled = matrix;
  for (Rational& v : doubled) v *= Rational(2);
  const auto pn = make_pn_triangle(in.corners, in.normals),
             image = make_pn_triangle(moved.corners, moved.normals);
  EXPECT_EQ(image->points, affine_image<Rational>(pn->points, doubled, shift));
  EXPECT_EQ(image->normals, affine_image<Rational>(pn->normals, matrix, none));
}

// The formulas of the paper, with unit normals and roots, in doubles.
TEST(PnTriangle, IsThatOfThePaperButForTheScaleOfEdgeNormals) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const Input in = draw_input(random);
    double p[3][3], n[3][3];
    Points unit;
    for (std::size_t i = 0; i < 3; ++i) {
      double length = 0;
      for (std::size_t c = 0; c < 3; ++c) {
        p[i][c] = nearest_double(in.corners[i][c]), n[i][c] = nearest_double(in.normals[i][c]);
        length += n[i][c] * n[i][c];
      }
      for (std::size_t c = 0; c < 3; ++c) {
        n[i][c] /= std::sqrt(length);
        unit[i][c] = Rational::from_double(n[i][c]);
      }
    }
    const auto pn = make_pn_triangle(in.corners, unit);
    ASSERT_TRUE(pn);
    const auto coefficient = [](const auto& map, std::size_t c, int j, int k) {
      return nearest_double(map.component(static_cast<int>(c))[triangle_index(j, k)]);
    };
    double w12 = 0, dd = 0, ds = 0, hh = 0, h[3];
    for (std::size_t c = 0; c < 3; ++c) {
      const double d = p[1][c] - p[0][c];
      w12 += d * n[0][c], dd += d * d, ds += d * (n[0][c] + n[1][c]);
    }
    for (std::size_t c = 0; c < 3; ++c) {
      EXPECT_NEAR(coefficient(pn->points, c, 1, 0), (2 * p[0][c] + p[1][c] - w12 * n[0][c]) / 3,
                  1e-13);
      h[c] = n[0][c] + n[1][c] - 2 * ds / dd * (p[1][c] - p[0][c]);
      hh += h[c] * h[c];
    }
    double half_angle_cosine = 0;
    for (std::size_t c = 0; c < 3; ++c) half_angle_cosine += n[0][c] * n[1][c];
    half_angle_cosine = std::sqrt((1 + half_angle_cosine) / 2);
    for (std::size_t c = 0; c < 3; ++c) {
      EXPECT_NEAR(coefficient(pn->normals, c, 1, 0), half_angle_cosine * h[c] / std::sqrt(hh),
                  1e-12);
    }
  }
}

TEST(PnTriangle, HasItsCentreHalfAsFarOffTheEdgePointsAsTheseAreOffTheCorners) {
  Random random(4);
  const Input in = draw_input(random);
  const auto pn = make_pn_triangle(in.corners, in.normals);
  for (int c = 0; c < 3; ++c) {
    Rational edges, corners;
    for_each_triangle_index(3, [&](int i, int j, int k) {
      const Rational& b = pn->points.component(c)[triangle_index(j, k)];
      const bool is_corner = i == 3 || j == 3 || k == 3;
      if (is_corner) corners += b / Rational(3);
      if (!is_corner && !(j == 1 && k == 1)) edges += b / Rational(6);
    });
    EXPECT_EQ(pn->points.component(c)[triangle_index(1, 1)],
              edges + (edges - corners) / Rational(2));
  }
}

TEST(PnTriangle, RefusesNormalsNinetyDegreesOffOrMore) {
  const Points corners{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}};
  const PnPoint up{0, 0, 1}, across{1, 0, 0}, down{0, 1, -1};
  const Rational tiny = Rational::power_of_two(-300);
  EXPECT_TRUE(make_pn_triangle(corners, {up, PnPoint{1, 0, tiny}, up}));
  const auto refused = make_pn_triangle(corners, {up, across, down});
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().place.vertex, 1u);
  EXPECT_EQ(
      refused.error().message,
      "the normal of corner 1, (1, 0, 0), is 90 degrees or more off the plane's normal, (0, 0, 1)");
  EXPECT_EQ(make_pn_triangle(corners, {up, up, down}).error().place.vertex, 2u);
}

TEST(PnTriangle, RefusesZeroNormalsAndDegenerateTriangles) {
  const PnPoint up{0, 0, 1}, zero{0, 0, 0};
  const auto no_normal = make_pn_triangle({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}}, {zero, up, up});
  ASSERT_FALSE(no_normal);
  EXPECT_EQ(no_normal.error().message, "the normal of corner 0 is zero");
  const auto flat = make_pn_triangle({{{0, 0, 0}, {1, 1, 1}, {3, 3, 3}}}, {up, up, up});
  ASSERT_FALSE(flat);
  EXPECT_EQ(flat.error().message, "the triangle is degenerate: (0, 0, 0) (1, 1, 1) (3, 3, 3)");
}

}  // namespace
}  // namespace veritope
