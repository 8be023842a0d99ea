// SPDX-License-Identifier: LGPL-3.0-or-later
// The proofs on pairs whose common points are known exactly.
#include "interval/intersect/intersection_tube.h"

#include <gtest/gtest.h>

#include <cmath>

#include "interval/intersect/intersection_branches.h"
#include "interval/intersect/intersection_curve.h"
#include "interval/intersect/intersection_search.h"
#include "interval/upward.h"
#include "splines/de_casteljau.h"

namespace veritope {
namespace {

Rational q(std::int64_t p, std::int64_t r = 1) { return Rational(p) / Rational(r); }
KnotAxis<Rational> bezier_axis(int degree) {
  KnotAxis<Rational> axis{degree, {}, false};
  for (int i = 0; i < 2 * (degree + 1); ++i) axis.knots.push_back(q(i > degree ? 1 : 0));
  return axis;
}

/// z = x^2 + 2 y^2 - 1/2 over [-1, 1]^2, x = 2 u - 1, y = 2 v - 1.
BSplineSurface<Rational> bowl() {
  std::vector<Rational> c;
  const std::array<Rational, 3> line{q(-1), q(0), q(1)}, square{q(1), q(-1), q(1)};
  for (const Rational& x : line) c.insert(c.end(), 3, x);
  for (int i = 0; i < 3; ++i) c.insert(c.end(), line.begin(), line.end());
  for (const Rational& a : square)
    for (const Rational& b : square) c.push_back(a + q(2) * b - q(1, 2));
  return BSplineSurface<Rational>({bezier_axis(2), bezier_axis(2)}, 3, false, std::move(c));
}
/// z = 0 over [-2, 2]^2.
BSplineSurface<Rational> floor_plane() {
  return BSplineSurface<Rational>(
      {bezier_axis(1), bezier_axis(1)}, 3, false,
      {q(-2), q(-2), q(2), q(2), q(-2), q(2), q(-2), q(2), q(0), q(0), q(0), q(0)});
}
Rational height(const Rational& u, const Rational& v) {
  const Rational x = q(2) * u - q(1), y = q(2) * v - q(1);
  return x * x + q(2) * y * y - q(1, 2);
}
bool changes_sign(const Box4& x) {
  bool low = false, high = false;
  for (const double u : {x[0].lo(), x[0].hi()})
    for (const double v : {x[1].lo(), x[1].hi()}) {
      const Sign s = height(Rational::from_double(u), Rational::from_double(v)).sign();
      low = low || s != Sign::kPositive, high = high || s != Sign::kNegative;
    }
  return low && high;
}

struct Pair {
  EnclosedSurface s1, s2;
  IntersectionCover cover;
};
Pair bowl_and_plane() {
  auto s1 = EnclosedSurface::make(bowl()), s2 = EnclosedSurface::make(floor_plane());
  auto cover = cover_intersection(*s1, *s2, {});
  return {std::move(*s1), std::move(*s2), std::move(cover)};
}

TEST(IntersectionTube, LocatedPointsHoldTheTruth) {
  const ScopedUpward upward;
  const auto pair = bowl_and_plane();
  ASSERT_FALSE(pair.cover.tubes.empty());
  EXPECT_TRUE(pair.cover.undecided.empty());
  for (const auto& tube : pair.cover.tubes)
    for (const double t : {0.0, 0.3, 0.5, 1.0}) {
      const double w = tube.w_lo + t * (tube.w_hi - tube.w_lo);
      const Box4 x = locate(pair.s1, pair.s2, tube, std::min(w, tube.w_hi));
      EXPECT_LE(width(x), 1e-13);
      EXPECT_TRUE(tube.contains(x));
      EXPECT_TRUE(changes_sign(x));
    }
}

// PROVES TUBE-1.DERIVATIVE
TEST(IntersectionTube, DirectionAndDerivativesAreThoseOfTheArc) {
  const ScopedUpward upward;
  const auto pair = bowl_and_plane();
  for (const auto& tube : pair.cover.tubes) {
    const Box4 a = locate(pair.s1, pair.s2, tube, tube.w_lo),
               b = locate(pair.s1, pair.s2, tube, tube.w_hi);
    const Interval step = Interval(tube.w_hi) - Interval(tube.w_lo);
    for (std::size_t i = 0; i < 4; ++i)
      EXPECT_FALSE(is_disjoint(tube.derivative[i], (b[i] - a[i]) / step));
    // n1 points along (-2 x, -4 y, 1), n2 up: n1 x n2 along (-4 y, 2 x, 0), clockwise seen from above... by sign:
    const double x = 2 * a[0].lo() - 1, y = 2 * a[1].lo() - 1;
    const double along = -4 * y * (b[0].lo() - a[0].lo()) + 2 * x * (b[1].lo() - a[1].lo());
    EXPECT_EQ(along > 0, tube.direction > 0);
  }
}

TEST(IntersectionTube, ContainsWhatItSays) {
  const ScopedUpward upward;
  const auto pair = bowl_and_plane();
  const auto& tube = pair.cover.tubes.front();
  EXPECT_TRUE(tube.contains(tube));
  IntersectionTube longer = tube;
  longer.w_hi = tube.w_hi + 0.5 * (tube.w_hi - tube.w_lo);
  EXPECT_FALSE(tube.contains(longer));
  EXPECT_TRUE(longer.contains(tube));
  IntersectionTube wider = tube;
  for (std::size_t i = 0; i < 4; ++i) wider.offset[i] = Interval(2.0) * tube.offset[i];
  EXPECT_FALSE(tube.contains(wider));
}

TEST(IntersectionTube, ATubeAlongAnotherParameterIsComparedAsASet) {
  const ScopedUpward upward;
  IntersectionTube large;  // u in [0, 1], the others in [-1, 1]
  large.w_lo = 0, large.w_hi = 1;
  for (std::size_t i = 1; i < 4; ++i) large.offset[i] = Interval::from_bounds(-1, 1);
  IntersectionTube other;  // v in [0.25, 0.5], s and t 0
  other.pivot = 1;
  other.w_lo = 0.25, other.w_hi = 0.5;
  other.slope = {0, 1, 0, 0};
  other.center[0] = 0.5;
  EXPECT_TRUE(large.contains(other));
  other.offset[0] = Interval(5.0);
  EXPECT_FALSE(large.contains(other));
}

// What is returned is proved: the arc of the longer tube lies in it, however narrow the offsets are
// with which the search begins.
TEST(IntersectionTube, ShortenedTubesHoldTheArcWhereFirstOffsetsAreTooNarrow) {
  const ScopedUpward upward;
  const auto pair = bowl_and_plane();
  std::size_t proved = 0;
  for (const auto& tube : pair.cover.tubes) {
    IntersectionTube narrow = tube;
    for (std::size_t i = 0; i < 4; ++i) narrow.derivative[i] = Interval(tube.slope[i]);
    const auto out = shortened(pair.s1, pair.s2, narrow, tube.w_lo, tube.w_hi);
    if (!out) continue;
    ++proved;
    for (const double t : {0.0, 0.125, 0.5, 0.875, 1.0}) {
      const double w = tube.w_lo + t * (tube.w_hi - tube.w_lo);
      EXPECT_TRUE(out->contains(locate(pair.s1, pair.s2, tube, std::min(w, tube.w_hi)))) << t;
    }
  }
  EXPECT_GT(proved, 0u);
}

// contract() leaves a region without a range where it finds nothing; a search that took it for
// covered would drop a pair of boxes.
TEST(IntersectionTube, ARegionWithoutARangeLiesInNoTube) {
  const ScopedUpward upward;
  IntersectionTube large;
  large.w_lo = -1, large.w_hi = 1;
  for (std::size_t i = 1; i < 4; ++i) large.offset[i] = Interval::from_bounds(-1, 1);
  IntersectionTube small = large;
  small.w_lo = 0, small.w_hi = 0.5;
  EXPECT_TRUE(large.contains(small));
  EXPECT_FALSE(large.contains(IntersectionTube{}));
}

// The inverse of the Jacobian has a row beyond the range of doubles, though the determinant has a
// reciprocal within. Numbers that are not finite prove nothing: neither that a box is empty, nor
// where its points lie.
TEST(IntersectionTube, AnInverseThatOverflowsProvesNothing) {
  const ScopedUpward upward;
  const auto s1 = EnclosedSurface::make(bowl()), s2 = EnclosedSurface::make(floor_plane());
  const auto column = [](double x, double y, double z) {
    return Box3(Interval(x), Interval(y), Interval(z));
  };
  const auto side = [](double r) { return Interval::from_bounds(0.5 - r, 0.5 + r); };
  for (const double z : {0x1p-1063, 0x1p-1030, -0x1p-1063}) {
    const double long_side = 0x1p1000;
    const Box4 x(side(0x1p-10), side(0x1p-10), side(long_side), side(0x1p-10));
    IntersectionTube region;
    EXPECT_EQ(contract(*s1, *s2, x, column(0x1p33, 0, 0), column(0, 0x1p33, 0), column(0, 0, z),
                       column(0, 0, 0), &region),
              Contraction::kUnknown)
        << z;
  }
}

TEST(IntersectionClusters, BoxesThatTouchAreOneAndOthersAreNot) {
  const auto box = [](double u, double v, double s, double t) {
    const auto side = [](double at) { return Interval::from_bounds(at, at + 1); };
    return Box4(side(u), side(v), side(s), side(t));
  };
  using Clusters = std::vector<std::vector<std::size_t>>;
  EXPECT_EQ(clusters_of({box(0, 0, 0, 0), box(0, 0, 0, 2), box(0, 2, 0, 0), box(3, 0, 0, 0)}),
            (Clusters{{0}, {1}, {2}, {3}}));
  EXPECT_EQ(clusters_of({box(4, 0, 0, 0), box(0, 0, 0, 0), box(2, 0, 0, 5), box(3, 0, 0, 1),
                         box(1, 1, 1, 1)}),
            (Clusters{{0, 3}, {1, 4}, {2}}));
}

TEST(IntersectionTube, ShortenedTubesKeepTheArc) {
  const ScopedUpward upward;
  const auto pair = bowl_and_plane();
  for (const auto& tube : pair.cover.tubes) {
    const double w = tube.w_lo + 0.4 * (tube.w_hi - tube.w_lo);
    const auto half = shortened(pair.s1, pair.s2, tube, tube.w_lo, w);
    ASSERT_TRUE(half.has_value());
    const Box4 a = locate(pair.s1, pair.s2, tube, w), b = locate(pair.s1, pair.s2, *half, w);
    EXPECT_FALSE(is_disjoint(a, b));
    EXPECT_TRUE(half->contains(b));
    for (std::size_t i = 0; i < 4; ++i)
      EXPECT_LE(wid(half->derivative[i]), wid(tube.derivative[i]) * 1.5);
  }
}

// Hypotheses of THEORY, TUBE-1, each alone. Parameters run over [0, 1].

/// The plane x = 0 over y, z in [-2, 2].
BSplineSurface<Rational> wall_plane() {
  return BSplineSurface<Rational>(
      {bezier_axis(1), bezier_axis(1)}, 3, false,
      {q(0), q(0), q(0), q(0), q(-2), q(-2), q(2), q(2), q(-2), q(2), q(-2), q(2)});
}
constexpr double kRadius = 0x1p-10;
/// find_tube widens the region's offsets by this factor before its first try.
constexpr double kWider = 1.25;

/// v runs along with the pivot. Its last value is 1, so that restricting a net to the tube divides by 1: no rounding there.
constexpr double kFirst = 0.5, kLast = 1 - kWider * kRadius,
                 kMiddle = 0.75 - 0.5 * kWider * kRadius;

IntersectionTube region_at(int pivot, const Point4& center, const Point4& slope) {
  IntersectionTube region;
  region.pivot = pivot;
  region.w_lo = kFirst, region.w_hi = kLast;
  region.center = center, region.slope = slope;
  for (std::size_t i = 0; i < 4; ++i) {
    const double r = static_cast<int>(i) == pivot ? 0 : kRadius;
    region.offset[i] = Interval::from_bounds(-r, r);
    region.derivative[i] = Interval(0);
  }
  return region;
}

/// Around the line u = 1/2, v = s, t = 1/2 in which floor and wall meet, displaced by `off` in u. Half of the inverse Jacobian is
/// given, so the image of the offsets Z is Z / 2 - off / 2 in u: it contracts by 1/2 and lies in Z iff |off| <= the radius of Z.
IntersectionTube region_off_the_line(double off) {
  auto region = region_at(2, {0.5 + off, kMiddle, kMiddle, 0.5}, {0, 1, 1, 0});
  region.inverse = {{{0.125, 0, 0}, {0, 0.125, 0}, {0, 0, -0.125}}};
  return region;
}

// PROVES TUBE-1, TUBE-1.T1
TEST(IntersectionTube, NoTubeIsProvedWhereTheImageLeavesTheOffsets) {
  const ScopedUpward upward;
  const auto s1 = EnclosedSurface::make(floor_plane()), s2 = EnclosedSurface::make(wall_plane());
  const auto on = find_tube(*s1, *s2, region_off_the_line(0), 0);
  ASSERT_TRUE(on.has_value());
  EXPECT_TRUE(
      on->contains(Box4(Interval(0.5), Interval(kMiddle), Interval(kMiddle), Interval(0.5))));
  // The second try takes 0.625 (off + first radius), so that this one fails twice.
  EXPECT_FALSE(find_tube(*s1, *s2, region_off_the_line(0x1p-4), 0).has_value());
}

// PROVES TUBE-1, TUBE-1.T1
TEST(IntersectionTube, AnArcOnTheBorderOfTheTubeIsProved) {
  const ScopedUpward upward;
  const auto s1 = EnclosedSurface::make(floor_plane()), s2 = EnclosedSurface::make(wall_plane());
  const double r = kWider * kRadius;
  for (const double off : {r, -r}) {
    const auto tube = find_tube(*s1, *s2, region_off_the_line(off), 0);
    ASSERT_TRUE(tube.has_value());
    EXPECT_EQ(tube->offset[0], Interval::from_bounds(-r, r)) << "the first try did not succeed";
    EXPECT_TRUE(
        tube->contains(Box4(Interval(0.5), Interval(kMiddle), Interval(kMiddle), Interval(0.5))));
  }
}

// PROVES TUBE-1, TUBE-1.T2
TEST(IntersectionTube, NoTubeIsProvedWhereTheImageDoesNotContract) {
  const ScopedUpward upward;
  // One plane twice: for each t all (u, v, s) with u = s and v = t are solutions. The image of Z is about Z_s x 0 x Z_s, the last
  // one without rounding: it lies in Z, and only T2 can refuse it.
  const auto s1 = EnclosedSurface::make(floor_plane()), s2 = EnclosedSurface::make(floor_plane());
  auto region = region_at(3, {0.5, kMiddle, 0.5, kMiddle}, {0, 1, 0, 1});
  region.offset[0] = Interval(2) * region.offset[2];
  region.inverse = {{{0.25, 0, 0}, {0, 0.25, 0}, {0, 0, 1}}};
  EXPECT_FALSE(find_tube(*s1, *s2, region, 0).has_value());
}

using Vector3 = std::array<Rational, 3>;
Vector3 cross(const Vector3& a, const Vector3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Rational dot(const Vector3& a, const Vector3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Vector3 negated(const Vector3& a) { return {-a[0], -a[1], -a[2]}; }

/// p + u a + v b.
BSplineSurface<Rational> plane(const Vector3& p, const Vector3& a, const Vector3& b) {
  std::vector<Rational> c;
  for (std::size_t k = 0; k < 3; ++k)
    for (const Rational& v : {p[k], p[k] + b[k], p[k] + a[k], p[k] + a[k] + b[k]}) c.push_back(v);
  return BSplineSurface<Rational>({bezier_axis(1), bezier_axis(1)}, 3, false, std::move(c));
}
using Matrix3 = std::array<std::array<double, 3>, 3>;
Vector3 row(const Matrix3& m, std::size_t i) {
  return {Rational::from_double(m[i][0]), Rational::from_double(m[i][1]),
          Rational::from_double(m[i][2])};
}

// PROVES TUBE-1.DIRECTION
TEST(IntersectionTube, TheDirectionIsThatOfTheArcWhereTheDeterminantInDoublesIsZero) {
  const ScopedUpward upward;
  // The determinant is e^2 or -e^2, and the products that differ by it have the same nearest double, and the same next
  // larger one.
  constexpr double kE = 0x1p-27;
  for (const bool is_swapped : {false, true}) {
    Matrix3 inverse{{{1, 1, 1}, {1, 1, 1 - kE}, {1, 1 + kE, 1}}};
    if (is_swapped) std::swap(inverse[1], inverse[2]);
    const auto& [a, b, c] = inverse;
    const double rounded = a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) +
                           a[2] * (b[0] * c[1] - b[1] * c[0]);
    const Vector3 x = row(inverse, 0), y = row(inverse, 1), z = row(inverse, 2);
    const Rational exact = dot(x, cross(y, z));
    EXPECT_EQ(rounded, 0);
    EXPECT_EQ(exact.sign(), is_swapped ? Sign::kNegative : Sign::kPositive);
    // The columns of the exact inverse are doubles. They are u, v and -t of two planes that meet in u = 1/2, v = s,
    // t = 1/2.
    const auto column = [&](const Vector3& a, const Vector3& b) {
      Vector3 c = cross(a, b);
      for (Rational& v : c) v = v / exact;
      return c;
    };
    const Vector3 u = column(y, z), v = column(z, x), t = negated(column(x, y));
    const auto minus_half = [](Vector3 a) {
      for (Rational& c : a) c = -c / Rational(2);
      return a;
    };
    const auto s1 = EnclosedSurface::make(plane(minus_half(u), u, v)),
               s2 = EnclosedSurface::make(plane(minus_half(t), v, t));
    auto region = region_at(2, {0.5, kMiddle, kMiddle, 0.5}, {0, 1, 1, 0});
    region.inverse = inverse;
    const auto tube = find_tube(*s1, *s2, region, 0);
    ASSERT_TRUE(tube.has_value());
    // With increasing s the arc runs along v.
    const Rational along = dot(cross(cross(u, v), cross(v, t)), v);
    EXPECT_EQ(tube->direction, to_int(along.sign()));
  }
}

TEST(IntersectionCurve, TheBoundOfLebesgueHoldsForTheRoundedNodes) {
  const ScopedUpward upward;
  for (const std::size_t degree : {3u, 6u, 12u, 18u, 24u, 36u}) {
    const auto nodes = internal::chebyshev_nodes(degree);
    ASSERT_EQ(nodes.size(), degree + 1);
    // Sum of |l_i| over small intervals that cover [0, 1].
    double most = 0;
    const int kParts = 20000;
    for (int part = 0; part < kParts; ++part) {
      const Interval t = (Interval(static_cast<double>(part)) + Interval::from_bounds(0, 1)) /
                         Interval(static_cast<double>(kParts));
      Interval sum;
      for (std::size_t i = 0; i <= degree; ++i) {
        Interval l(1.0);
        for (std::size_t j = 0; j <= degree; ++j)
          if (i != j)
            l = l * ((t - Interval(nodes[j])) / (Interval(nodes[i]) - Interval(nodes[j])));
        sum = sum + abs(l);
      }
      most = std::max(most, sum.lo());
    }
    EXPECT_LE(most, internal::lebesgue_bound(degree)) << degree;
    EXPECT_GE(most * 1.5, internal::lebesgue_bound(degree)) << degree;
  }
}

TEST(IntersectionCurve, GapsOfWrongCurvesAreSeen) {
  const ScopedUpward upward;
  const auto pair = bowl_and_plane();
  // The straight line from one point of the ellipse to another leaves the bowl.
  const Point4 a{0.5 + 0.5 * 0.7071067811865476, 0.5, 0.5 + 0.25 * 0.7071067811865476, 0.5};
  const Point4 b{0.5, 0.75, 0.5, 0.625};
  std::array<Point4, 4> line;
  for (std::size_t i = 0; i < 4; ++i)
    line[0][i] = a[i], line[3][i] = b[i], line[1][i] = (2 * a[i] + b[i]) / 3,
    line[2][i] = (a[i] + 2 * b[i]) / 3;
  EXPECT_GE(gap_of_cubic(pair.s1, pair.s2, line), 0.2);
  line[3][0] = 1.5;  // beyond the domain
  EXPECT_TRUE(std::isinf(gap_of_cubic(pair.s1, pair.s2, line)));
}

}  // namespace
}  // namespace veritope
