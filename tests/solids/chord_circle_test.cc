// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/interval_boxes/chord_circle.h"

#include <gtest/gtest.h>

#include <cmath>

#include "interval/relations.h"
#include "interval/upward.h"
#include "robust/base/random.h"
#include "splines/bspline_make.h"

namespace veritope {
namespace {

struct Numbers {
  double cx, cy, e1x, e1y, e2x, e2y;
};
BoxPair pair_of(const Numbers& n) {
  return {{Interval(n.cx), Interval(n.cy)},
          {Interval(n.e1x), Interval(n.e1y)},
          {Interval(n.e2x), Interval(n.e2y)}};
}
Numbers random_numbers(Random& random) {
  Numbers n;
  n.e1x = 0.2 + random.unit(), n.e2x = 0.2 + random.unit();
  n.e1y = 0.2 + random.unit(), n.e2y = n.e1y + random.unit();
  n.cx = random.unit() * (n.e1x + n.e2x), n.cy = random.unit() * (n.e1y + n.e2y);
  return n;
}
Numbers random_numbers(Random& random, const HalfWidths& widths) {
  const auto in = [&](const Interval& a) { return a.lo() + random.unit() * (a.hi() - a.lo()); };
  Numbers n;
  n.e1x = in(widths.range[0]), n.e2x = in(widths.range[0]);
  n.e2y = in(widths.range[1]), n.e1y = std::min(n.e2y, in(widths.range[1]));
  n.cx = random.unit() * (n.e1x + n.e2x), n.cy = random.unit() * (n.e1y + n.e2y);
  return n;
}

// Some thirty operations, of which differences lose a few bits more.
constexpr double kRelativeWidth = 0x1p-40;

// A circle through 0 and c2, given by where its centre lies on the bisector: an oracle that does not know the formulas.
struct Circle {
  double x, y, r;
};
Circle circle_at(const Numbers& n, double s) {
  const double length = std::hypot(n.cx, n.cy);
  // From the middle of the chord upwards (to the left of the direction to c2).
  const double x = n.cx / 2 - s * n.cy / length, y = n.cy / 2 + s * n.cx / length;
  return {x, y, std::hypot(x, y)};
}

TEST(Psi, TheCircleIsTangentToTheLineOrMeetsItInPAtItsRight) {
  int tangent = 0, through = 0;
  for (std::uint64_t seed = 1; seed <= 2000; ++seed) {
    Random random(seed);
    const Numbers n = random_numbers(random);
    const ScopedUpward upward;
    const Interval r = psi(pair_of(n));
    ASSERT_FALSE(r.is_empty()) << "seed " << seed;
    ASSERT_LE(r.hi() - r.lo(), kRelativeWidth * r.hi()) << "seed " << seed;
    const double h = n.e1y + n.e2y - n.cy, length = std::hypot(n.cx, n.cy);
    // Two circles of this radius pass through both centres.
    const double s = std::sqrt(std::max(0.0, r.hi() * r.hi() - length * length / 4));
    // r is known to kRelativeWidth r, so s, and with it the centre, to sqrt(2 kRelativeWidth) r where s is small; the radius as well.
    const double slack = 2 * std::sqrt(2 * kRelativeWidth) * (1 + r.hi());
    bool is_right = false;
    for (const double side : {s, -s}) {
      const Circle c = circle_at(n, side);
      // The point of contact lies on the lower arc from c1 to c2: to the right of the chord.
      if (std::abs(c.y - c.r + h) <= slack &&
          n.cx * (c.y - c.r) - n.cy * c.x <= slack * (n.cx + n.cy)) {
        is_right = true, ++tangent;
        break;
      }
      if (h <= n.e1y && std::abs(std::hypot(n.e1x - c.x, -h - c.y) - c.r) <= slack &&
          c.x <= n.e1x + slack) {
        is_right = true, ++through;
        break;
      }
    }
    ASSERT_TRUE(is_right) << "seed " << seed << ": c2 (" << n.cx << ", " << n.cy << "), e1 ("
                          << n.e1x << ", " << n.e1y << "), e2y " << n.e2y << ", r " << r.hi();
  }
  EXPECT_GE(tangent, 300);
  EXPECT_GE(through, 300);
}

TEST(Psi, LevelCentresHaveTheTextbookRadius) {
  const ScopedUpward upward;
  // Chord 2 a, sagitta h: r = (a^2 + h^2) / (2 h).
  const Interval r = psi({{Interval(2.0), Interval(0.0)},
                          {Interval(1.0), Interval(0.5)},
                          {Interval(1.0), Interval(0.5)}});
  EXPECT_TRUE(is_member(1.0, r)) << to_string(r);
  // c2 = c1: the tangent circle through one point is no smaller than h / 2, whatever its direction.
  const Interval at_zero = psi({{Interval(0.0), Interval(0.0)},
                                {Interval(1.0), Interval(0.5)},
                                {Interval(1.0), Interval(0.5)}});
  EXPECT_LE(at_zero.lo(), 0.5);
  EXPECT_GE(at_zero.hi(), 1.0);
  EXPECT_TRUE(std::isfinite(at_zero.hi()));
  EXPECT_TRUE(psi({{Interval(0.0), Interval(9.0)},
                   {Interval(1.0), Interval(0.5)},
                   {Interval(1.0), Interval(0.5)}})
                  .is_empty())
      << "boxes apart";
}

TEST(GreatestChordRadius, EnclosesWhatRandomPairsReach) {
  const HalfWidths widths{
      {Interval::from_bounds(0.25, 0.375), Interval::from_bounds(0.25, 0.3125)}};
  const auto r = greatest_chord_radius(widths, {0x1p-4, 100'000}).value();
  double most = 0;
  const ScopedUpward upward;
  for (std::uint64_t seed = 1; seed <= 20000; ++seed) {
    Random random(seed);
    const Numbers n = random_numbers(random, widths);
    const Interval at = psi(pair_of(n));
    ASSERT_LE(at.lo(), r.radius.hi()) << "seed " << seed;
    most = std::max(most, at.lo());
  }
  EXPECT_GE(most, 0.8 * r.radius.lo()) << to_string(r.radius);
}

// How far below l a point of the lens of radius r over the chord comes outside of b1: on its lower arc.
double depth_outside(const Numbers& n, double r) {
  const double length = std::hypot(n.cx, n.cy), h = n.e1y + n.e2y - n.cy;
  const Circle c = circle_at(n, std::sqrt(std::max(0.0, r * r - length * length / 4)));
  const double from = std::atan2(-c.y, -c.x);
  double to = std::atan2(n.cy - c.y, n.cx - c.x), deepest = 0;
  if (to < from) to += 2 * std::acos(-1);
  for (int k = 1; k < 64; ++k) {
    const double a = from + (to - from) * k / 64;
    const double x = c.x + c.r * std::cos(a), y = c.y + c.r * std::sin(a);
    if (std::abs(x) > n.e1x || std::abs(y) > n.e1y) deepest = std::max(deepest, -h - y);
  }
  return deepest;
}

// [SSP01] has a curve inside of psi's circle reach l in b1 only. Flat boxes: it leaves b1 below. R_max is great enough for them.
TEST(GreatestChordRadius, KeepsLensesAboveTheLineWherePsiAloneDoesNot) {
  const Numbers flat{0.95, 0.05, 0.95, 0.03, 0.95, 0.03};
  {
    const ScopedUpward upward;
    EXPECT_GT(depth_outside(flat, psi(pair_of(flat)).hi()), 10 * flat.e1y);
  }
  for (const double aspect : {0.125, 1.0, 8.0}) {
    const HalfWidths widths{
        {Interval::from_bounds(0.75 * aspect, aspect), Interval::from_bounds(0.75, 1)}};
    const auto r = greatest_chord_radius(widths, {0x1p-3, 20'000}).value();
    for (std::uint64_t seed = 1; seed <= 5000; ++seed) {
      Random random(seed);
      const Numbers n = random_numbers(random, widths);
      ASSERT_LE(depth_outside(n, r.radius.lo()), kRelativeWidth) << "seed " << seed;
    }
  }
}

TEST(GreatestChordRadius, EqualBoxesAreDoneToTheWidthAskedFor) {
  const Interval e(0.5);
  const auto r = greatest_chord_radius(HalfWidths{{e, e}}).value();
  EXPECT_TRUE(r.is_as_asked) << to_string(r.radius) << " after " << r.boxes;
  const auto twice = greatest_chord_radius(HalfWidths{{Interval(1.0), Interval(1.0)}}).value();
  const ScopedUpward upward;
  EXPECT_FALSE(is_disjoint(twice.radius, Interval(2.0) * r.radius)) << "lengths scale";
}

TEST(GreatestChordRadius, BadHalfWidthsAreRefused) {
  EXPECT_EQ(greatest_chord_radius(HalfWidths{{Interval(0.0), Interval(1.0)}}).error().code,
            Code::kBadArgument);
  EXPECT_EQ(greatest_chord_radius({Interval(1.0), Interval(1.0), Interval(1.0)}, 3).error().code,
            Code::kBadArgument);
}

template <std::size_t N>
BSpline<Rational, N> bezier(std::array<int, N> degrees, int components, bool rational,
                            std::vector<Rational> c) {
  std::array<KnotAxis<Rational>, N> axes;
  for (std::size_t a = 0; a < N; ++a) {
    axes[a].degree = degrees[a];
    axes[a].knots.assign(static_cast<std::size_t>(degrees[a]) + 1, Rational(0));
    axes[a].knots.insert(axes[a].knots.end(), static_cast<std::size_t>(degrees[a]) + 1,
                         Rational(1));
  }
  return make_bspline<N>(axes, components, rational, std::move(c)).value();
}

TEST(LeastCurvatureRadius, OfAParabolaAQuarterCircleAndAPlane) {
  // (t, t^2): 1/2 at t = 0. Polynomial (x: 0, 1/2, 1; y: 0, 0, 1).
  const auto parabola = bezier<1>({2}, 2, false, {0, Rational(1) / 2, 1, 0, 0, 1});
  const auto r = least_curvature_radius(parabola).value();
  EXPECT_TRUE(r.is_as_asked);
  EXPECT_LE(r.radius.lo(), 0.5);
  EXPECT_GE(r.radius.hi(), 0.5);
  const auto quarter = bezier<1>({2}, 3, true, {1, 1, 0, 0, 1, 2, 1, 1, 2});
  const auto one = least_curvature_radius(quarter).value();
  EXPECT_TRUE(is_member(1.0, one.radius)) << to_string(one.radius);
  const auto plane = bezier<2>({1, 1}, 3, false, {0, 0, 1, 1, 0, 1, 0, 1, 0, 0, 0, 0});
  EXPECT_GT(least_curvature_radius(plane).value().radius.lo(), 1e6);
  EXPECT_EQ(least_curvature_radius(bezier<1>({1}, 1, false, {0, 1})).error().code,
            Code::kBadArgument);
}

TEST(LeastCurvatureRadius, CornersAreRefused) {
  std::array<KnotAxis<Rational>, 1> axis;
  axis[0].degree = 1;
  axis[0].knots = {0, 0, 1, 2, 2};
  const auto corner = make_bspline<1>(axis, 2, false, {0, 1, 1, 0, 0, 1}).value();
  const auto r = least_curvature_radius(corner);
  ASSERT_FALSE(r.has_value()) << to_string(r->radius);
  EXPECT_EQ(r.error().code, Code::kBadArgument);
  axis[0].knots = {0, 0, 1, 1};
  EXPECT_TRUE(least_curvature_radius(make_bspline<1>(axis, 2, false, {0, 1, 0, 1}).value()));
}

// Figure 8: in space, for a surface that is nearly level along z. z = x^2 + y^2 has the curvature 2 at the origin.
TEST(Equation4, InSpaceForAParaboloid) {
  const Rational half = Rational(1) / 2;
  const auto bowl =
      bezier<2>({2, 2}, 3, false, {0, 0, 0,    half, half, half, 1, 1, 1, 0, half, 1, 0, half,
                                   1, 0, half, 1,    0,    0,    1, 0, 0, 1, 1,    1, 2});
  RadiusOptions options;
  options.relative_width = 0.25;
  const auto r_kappa = least_curvature_radius(bowl, options).value();
  EXPECT_LE(r_kappa.radius.lo(), 0.5);
  EXPECT_GE(r_kappa.radius.hi(), 0.5);
  const auto of = [&](double e) {
    return satisfies_eq4(greatest_chord_radius({Interval(e), Interval(e), Interval(e)}, 2).value(),
                         r_kappa);
  };
  EXPECT_EQ(of(1.0 / 64), true);
  EXPECT_EQ(of(4), false);
}

// Eq. 4 holds for boxes that are small against the radius of curvature, and fails for large ones.
TEST(Equation4, ComparesBoxesWithTheCurve) {
  const auto quarter = bezier<1>({2}, 3, true, {1, 1, 0, 0, 1, 2, 1, 1, 2});
  const auto r_kappa = least_curvature_radius(quarter).value();
  const auto of = [&](double e) {
    return satisfies_eq4(greatest_chord_radius(HalfWidths{{Interval(e), Interval(e)}}).value(),
                         r_kappa);
  };
  EXPECT_EQ(of(0.125), true);
  EXPECT_EQ(of(4), false);
  RadiusEnclosure nothing;
  nothing.radius = Interval::empty();
  EXPECT_EQ(satisfies_eq4(nothing, r_kappa), std::nullopt);
}

}  // namespace
}  // namespace veritope
