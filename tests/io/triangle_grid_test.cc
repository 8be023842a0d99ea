// SPDX-License-Identifier: LGPL-3.0-or-later
// Bezier triangles in pictures: VTK's order, grids, bounds of chords.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "render/spline_view_internal.h"
#include "robust/base/random.h"
#include "tests/io/spline_test_util.h"

namespace veritope {
namespace {

using Point = std::array<double, 3>;

// Points on a grid of fractions with a denominator of 64, a weight from 1 to 2 last if rational.
ExactTriangle random_triangle(Random& random, int degree, bool is_rational) {
  ExactTriangle out(degree, is_rational ? 4 : 3, is_rational);
  for (std::size_t i = 0; i < out.count(); ++i) {
    const Rational w = is_rational ? Rational(random.between(8, 16)) / 8 : Rational(1);
    for (int c = 0; c < 3; ++c) out.component(c)[i] = w * Rational(random.between(-64, 64)) / 64;
    if (is_rational) out.component(3)[i] = w;
  }
  return out;
}
// Turns the domain: corner 1 takes the place of corner 0, 2 that of 1, 0 that of 2.
ExactTriangle turned(const ExactTriangle& t) {
  ExactTriangle out(t.degree(), t.num_components(), t.is_rational());
  for (int c = 0; c < t.num_components(); ++c)
    for_each_triangle_index(t.degree(), [&](int i, int j, int k) {
      out.component(c)[triangle_index(j, k)] = t.component(c)[triangle_index(i, j)];
    });
  return out;
}

TEST(VtkTriangleOrder, NumbersCornersThenEdgesThenTheTriangleInside) {
  // The quartic of VTK: corners, edges 01, 12, 20, then an inner triangle of degree 1.
  const std::array<std::array<int, 3>, 15> order = {{{4, 0, 0},
                                                     {0, 4, 0},
                                                     {0, 0, 4},
                                                     {3, 1, 0},
                                                     {2, 2, 0},
                                                     {1, 3, 0},
                                                     {0, 3, 1},
                                                     {0, 2, 2},
                                                     {0, 1, 3},
                                                     {1, 0, 3},
                                                     {2, 0, 2},
                                                     {3, 0, 1},
                                                     {2, 1, 1},
                                                     {1, 2, 1},
                                                     {1, 1, 2}}};
  for (std::size_t n = 0; n < order.size(); ++n)
    EXPECT_EQ(vtk_triangle_index(order[n][0], order[n][1], order[n][2]), n);
  EXPECT_EQ(vtk_triangle_index(1, 1, 1), 9u);
  EXPECT_EQ(vtk_triangle_index(2, 2, 2), 27u);  // 18 around, 9 around it
}

// vtkHigherOrderTriangle::BarycentricIndex of VTK 9.1, written anew: from a number to (j, k, i).
std::array<int, 3> vtk_barycentric(int index, int order) {
  int most = order, least = 0;
  for (; index != 0 && index >= 3 * order; order -= 3) index -= 3 * order, most -= 2, ++least;
  std::array<int, 3> out{least, least, least};
  const auto at = [&](int i) -> int& { return out[static_cast<std::size_t>(i % 3)]; };
  if (index < 3) {
    at(index + 2) = most;
    return out;
  }
  const int edge = (index - 3) / (order - 1), step = (index - 3) % (order - 1);
  at(edge + 2) = most - 1 - step;
  at(edge) = least + 1 + step;
  return out;
}

TEST(VtkTriangleOrder, IsTheInverseOfVtksOwn) {
  for (int degree = 1; degree <= 12; ++degree) {
    std::set<std::size_t> seen;
    for_each_triangle_index(degree, [&](int i, int j, int k) {
      const std::size_t n = vtk_triangle_index(i, j, k);
      seen.insert(n);
      EXPECT_EQ(vtk_barycentric(static_cast<int>(n), degree), (std::array<int, 3>{j, k, i}));
    });
    EXPECT_EQ(seen.size(), num_triangle_coefficients(degree));
    EXPECT_EQ(*seen.rbegin(), seen.size() - 1);
  }
}

TEST(TriangleGrid, AVtuHoldsTrianglesWithTheirWeights) {
  const auto vtu = view_bytes(io_test::sample("triangles.vjson").model, ViewFormat::kVtu, {});
  ASSERT_TRUE(vtu);
  EXPECT_NE(vtu->find("NumberOfPoints=\"22\" NumberOfCells=\"4\""), std::string::npos);
  EXPECT_NE(vtu->find("\n76\n76\n76\n76\n"), std::string::npos);
  EXPECT_NE(vtu->find("\n1 1 1\n3 3 1\n2 2 1\n1 1 1\n"), std::string::npos);
  // The rational one: corners, then edges, weights divided out of the points.
  EXPECT_NE(vtu->find("\n1\n2\n3\n0.5\n1\n0.5\n"), std::string::npos);
  EXPECT_NE(vtu->find("\n0 0 0\n1 0 0\n0 1 0\n1 0 0.5\n1 1 1\n0 1 0.5\n"), std::string::npos);
}

TEST(TriangleGrid, EqualSidesGiveEqualPointsInEitherDirection) {
  Random random(20251126);
  for (int round = 0; round < 60; ++round) {
    const int degree = static_cast<int>(random.between(1, 6));
    const bool is_rational = random.below(2) == 0;
    const ExactTriangle a = random_triangle(random, degree, is_rational);
    // Another triangle with a's side from corner 0 to corner 1, backwards.
    ExactTriangle b = random_triangle(random, degree, is_rational);
    for (int c = 0; c < a.num_components(); ++c)
      for (int j = 0; j <= degree; ++j)
        b.component(c)[triangle_index(degree - j, 0)] = a.component(c)[triangle_index(j, 0)];
    for (std::uint64_t turns = random.below(3); turns > 0; --turns) b = turned(b);
    const std::size_t n = 1 + random.below(9);
    const auto points_of = [&](const ExactTriangle& t) {
      const auto grid = internal::triangle_grid(internal::rounded_triangle(t, 0).value(), n);
      return std::set<Point>(grid.begin(), grid.end());
    };
    const std::set<Point> first = points_of(a), second = points_of(b);
    std::vector<Point> common;
    std::set_intersection(first.begin(), first.end(), second.begin(), second.end(),
                          std::back_inserter(common));
    EXPECT_GE(common.size(), n + 1) << "seed 20251126, round " << round;
  }
}

TEST(TriangleGrid, CoversTheDomainOnceCounterclockwise) {
  for (std::size_t n = 1; n <= 7; ++n) {
    ExactTriangle flat(1, 3, false);
    flat.component(0)[1] = Rational(1), flat.component(1)[2] = Rational(1);
    const auto points = internal::triangle_grid(internal::rounded_triangle(flat, 0).value(), n);
    ASSERT_EQ(points.size(), num_triangle_coefficients(static_cast<int>(n)));
    std::vector<std::array<std::uint32_t, 3>> triangles;
    internal::append_triangle_grid(n, 5, triangles);
    EXPECT_EQ(triangles.size(), n * n);
    std::set<std::pair<std::uint32_t, std::uint32_t>> edges;
    double area = 0;
    for (const auto& t : triangles) {
      const Point &a = points[t[0] - 5], &b = points[t[1] - 5], &c = points[t[2] - 5];
      const double twice = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
      EXPECT_GT(twice, 0);
      area += twice / 2;
      for (std::size_t e = 0; e < 3; ++e)
        EXPECT_TRUE(edges.insert({t[e], t[(e + 1) % 3]}).second) << "an edge passed twice";
    }
    EXPECT_NEAR(area, 0.5, 1e-14);
  }
}

// The greatest distance between a map and its flat triangles at the same parameters, found on a grid 7 times as fine.
double deviation(const BezierTriangle<double>& map, std::size_t n) {
  constexpr std::size_t kFiner = 7;
  const auto coarse = internal::triangle_grid(map, n),
             fine = internal::triangle_grid(map, kFiner * n);
  std::vector<std::array<std::uint32_t, 3>> triangles;
  internal::append_triangle_grid(n, 0, triangles);
  std::vector<std::array<int, 2>> jk;  // of the coarse points
  for_each_triangle_index(static_cast<int>(n), [&](int, int j, int k) { jk.push_back({j, k}); });
  double worst = 0;
  for (const auto& t : triangles)
    for_each_triangle_index(static_cast<int>(kFiner), [&](int i, int j, int k) {
      const std::array<int, 3> l{i, j, k};
      int at_j = 0, at_k = 0;
      Point flat{};
      for (std::size_t e = 0; e < 3; ++e) {
        at_j += l[e] * jk[t[e]][0], at_k += l[e] * jk[t[e]][1];
        for (std::size_t x = 0; x < 3; ++x)
          flat[x] += static_cast<double>(l[e]) / kFiner * coarse[t[e]][x];
      }
      const Point& p = fine[triangle_index(at_j, at_k)];
      worst = std::max(worst, std::hypot(p[0] - flat[0], p[1] - flat[1], p[2] - flat[2]));
    });
  return worst;
}

TEST(TriangleGrid, FlatTrianglesStayAsCloseAsAskedFor) {
  Random random(20251127);
  double largest = 0;
  for (int round = 0; round < 40; ++round) {
    const int degree = static_cast<int>(random.between(1, 6));
    const auto map = internal::rounded_triangle(random_triangle(random, degree, false), 0).value();
    const double chord = 1.0 / static_cast<double>(random.between(10, 200));
    const std::size_t n = internal::triangle_divisions(map, chord);
    if (degree == 1) {
      EXPECT_EQ(n, 1u);
    }
    const double worst = deviation(map, n);
    EXPECT_LE(worst, chord * (1 + 1e-12)) << "seed 20251127, round " << round;
    largest = std::max(largest, worst / chord);
  }
  EXPECT_GT(largest, 0.1);  // no finer than needed by an order of magnitude
  // A paraboloid whose second differences are all equal along one edge: half the pieces would not do.
  ExactTriangle bent(2, 3, false);
  bent.component(2)[triangle_index(1, 0)] = Rational(1);
  const auto map = internal::rounded_triangle(bent, 0).value();
  for (const double chord : {0.1, 0.01, 0.001})
    EXPECT_GT(deviation(map, internal::triangle_divisions(map, chord) / 2), chord);
}

TEST(TriangleGrid, AllTrianglesOfAModelAreCutAlike) {
  const auto parts = tessellate(io_test::sample("triangles.vjson").model, {.chord = 0.01});
  ASSERT_TRUE(parts);
  for (const Tessellation& t : *parts) {
    EXPECT_EQ(t.points.size(), parts->front().points.size());
    EXPECT_EQ(t.triangles.size(), parts->front().triangles.size());
    EXPECT_TRUE(t.lines.empty());
  }
  EXPECT_GT(parts->front().triangles.size(), 1u);
}

TEST(TriangleGrid, WhatBinary64CannotHoldIsRefusedWithItsEntity) {
  Random random(20251128);
  ExactTriangle wide = random_triangle(random, 2, false), thin = random_triangle(random, 2, true);
  wide.component(0)[3] = Rational::power_of_two(1100);
  thin.component(3)[3] = Rational::power_of_two(-1100);
  for (const ExactTriangle& bad : {wide, thin}) {
    const SplineModel model{{},
                            {{random_triangle(random, 1, false), {}, {}, {}}, {bad, {}, {}, {}}}};
    for (const ViewFormat format : {ViewFormat::kVtu, ViewFormat::kObj, ViewFormat::kGltf}) {
      const auto bytes = view_bytes(model, format, {});
      ASSERT_FALSE(bytes);
      EXPECT_EQ(bytes.error().code, Code::kNotFinite);
      EXPECT_EQ(bytes.error().place.entity, 1u);
    }
  }
}

TEST(TriangleGrid, MorePointsThanAPictureHoldsAreRefusedBeforeTheyAreMade) {
  Random random(20251129);
  SplineModel model;
  for (int i = 0; i < 1100; ++i)
    model.entities.push_back({random_triangle(random, 2, false), {}, {}, {}});
  const auto parts = tessellate(model, {.chord = 1e-9});  // 1100 times 33153
  ASSERT_FALSE(parts);
  EXPECT_EQ(parts.error().code, Code::kOverLimit);
  EXPECT_EQ(parts.error().place.entity, 1099u);
}

}  // namespace
}  // namespace veritope
