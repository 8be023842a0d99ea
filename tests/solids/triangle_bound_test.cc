// SPDX-License-Identifier: LGPL-3.0-or-later
// Bounds of distances from triangles against the exact distance.
#include "solids/classify/triangle_bound.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <random>

#include "interval/upward.h"
#include "robust/rational.h"

namespace veritope {
namespace {

using Vector = std::array<Rational, 3>;
using Corners = std::array<Vec3d, 3>;

Vector exact(const Vec3d& p) {
  return {Rational::from_double(p.x), Rational::from_double(p.y), Rational::from_double(p.z)};
}
Vector plus(const Vector& a, const Rational& t, const Vector& d) {
  return {a[0] + t * d[0], a[1] + t * d[1], a[2] + t * d[2]};
}
Vector difference(const Vector& a, const Vector& b) { return plus(a, Rational(-1), b); }
Rational product(const Vector& a, const Vector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
// The square of the distance: the foot in the plane, if it lies in the triangle; else that of a side.
Rational squared_distance(const Vec3d& point, const Corners& triangle) {
  const Vector q = exact(point);
  const std::array<Vector, 3> p = {exact(triangle[0]), exact(triangle[1]), exact(triangle[2])};
  const Vector e = difference(p[1], p[0]), f = difference(p[2], p[0]), w = difference(q, p[0]);
  const Rational a = product(e, e), b = product(e, f), c = product(f, f), det = a * c - b * b;
  if (det.sign() != Sign::kZero) {
    const Rational s = (c * product(e, w) - b * product(f, w)) / det,
                   t = (a * product(f, w) - b * product(e, w)) / det;
    if (s >= Rational(0) && t >= Rational(0) && s + t <= Rational(1)) {
      const Vector off = difference(q, plus(plus(p[0], s, e), t, f));
      return product(off, off);
    }
  }
  std::optional<Rational> least;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vector side = difference(p[(i + 1) % 3], p[i]), way = difference(q, p[i]);
    const Rational length = product(side, side);
    Rational t(0);
    if (length.sign() != Sign::kZero)
      t = std::min(std::max(product(way, side) / length, Rational(0)), Rational(1));
    const Vector off = difference(q, plus(p[i], t, side));
    const Rational square = product(off, off);
    if (!least || square < *least) least = square;
  }
  return *least;
}
double bound(const Vec3d& p, const Corners& triangle) {
  const ScopedUpward upward;
  return distance_bound(Box3(Interval(p.x), Interval(p.y), Interval(p.z)), triangle);
}

TEST(TriangleBound, IsTheDistanceWhereItIsShort) {
  const Corners triangle = {Vec3d{0, 0, 0}, {4, 0, 0}, {0, 4, 0}};
  const struct {
    Vec3d point;
    double distance;
  } cases[] = {{{1, 1, 3}, 3},   {{1, 1, 0}, 0},  {{2, -3, 4}, 5},
               {{-3, -4, 0}, 5}, {{7, -4, 0}, 5}, {{4, 4, 0}, std::sqrt(8)}};
  for (const auto& c : cases) EXPECT_NEAR(bound(c.point, triangle), c.distance, 1e-14);
}

TEST(TriangleBound, IsNeverLessThanTheDistanceAndHardlyMore) {
  const unsigned seed = 7;
  std::mt19937 random(seed);
  const auto number = [&] { return static_cast<double>(static_cast<int>(random() % 65) - 32) / 8; };
  const auto any = [&] { return Vec3d{number(), number(), number()}; };
  for (int i = 0; i < 3000; ++i) {
    Corners triangle = {any(), any(), any()};
    if (i % 10 == 0) triangle[2] = triangle[1];  // a segment
    if (i % 50 == 0) triangle[1] = triangle[2] = triangle[0];
    const Vec3d point = i % 3 == 0 ? triangle[random() % 3] : any();
    const double found = bound(point, triangle);
    const Rational square = squared_distance(point, triangle), b = Rational::from_double(found);
    EXPECT_GE(b * b, square) << "seed " << seed << ", case " << i;
    EXPECT_LE(found, std::sqrt(nearest_double(square)) * (1 + 1e-12) + 1e-12)
        << "seed " << seed << ", case " << i;
  }
}

TEST(TriangleBound, HoldsForAllPointsOfABox) {
  const Corners triangle = {Vec3d{0, 0, 0}, {4, 0, 0}, {0, 4, 0}};
  const ScopedUpward upward;
  const Box3 box{Interval::from_bounds(1, 2), Interval::from_bounds(1, 2),
                 Interval::from_bounds(-1, 3)};
  EXPECT_GE(distance_bound(box, triangle), 3);
}

TEST(NearWeights, AreThoseOfAPointNearTheNearestOne) {
  const Corners triangle = {Vec3d{0, 0, 0}, {4, 0, 0}, {0, 4, 0}};
  const struct {
    Point3d point;
    std::array<double, 2> weights;
  } cases[] = {{{1, 1, 3}, {0.25, 0.25}}, {{2, -3, 4}, {0.5, 0}},  {{-3, -4, 1}, {0, 0}},
               {{7, -4, 0}, {1, 0}},      {{4, 4, 2}, {0.5, 0.5}}, {{-1, 3, 0}, {0, 0.75}}};
  for (const auto& c : cases) {
    const std::array<double, 2> found = near_weights(c.point, triangle);
    EXPECT_NEAR(found[0], c.weights[0], 1e-14);
    EXPECT_NEAR(found[1], c.weights[1], 1e-14);
  }
}

}  // namespace
}  // namespace veritope
