// SPDX-License-Identifier: LGPL-3.0-or-later
// Pairs of surfaces whose intersection is known.
#include "interval/intersect/surface_intersection.h"

#include <gtest/gtest.h>

#include <functional>

#include "interval/numeric.h"
#include "splines/de_casteljau.h"
#include "splines/knot_insertion.h"

namespace veritope {
namespace {

Rational q(std::int64_t p, std::int64_t r = 1) { return Rational(p) / Rational(r); }

using Axis = KnotAxis<Rational>;
/// Clamped, with `spans` equal spans over [0, 1].
Axis uniform_axis(int degree, int spans) {
  Axis axis{degree, {}, false};
  for (int i = 0; i <= degree; ++i) axis.knots.push_back(q(0));
  for (int i = 1; i < spans; ++i) axis.knots.push_back(q(i, spans));
  for (int i = 0; i <= degree; ++i) axis.knots.push_back(q(1));
  return axis;
}

/// A polynomial surface with these axes and control points, v fastest: any degrees, any number of pieces.
using Net = std::vector<std::array<Rational, 3>>;
BSplineSurface<Rational> surface_of(Axis u, Axis v, const Net& net) {
  std::vector<Rational> coefficients;
  for (std::size_t c = 0; c < 3; ++c)
    for (const auto& p : net) coefficients.push_back(p[c]);
  return BSplineSurface<Rational>({u, v}, 3, false, coefficients);
}
/// The plane z = height over [x0, x1] x [y0, y1].
BSplineSurface<Rational> plane(const Rational& x0, const Rational& x1, const Rational& y0,
                               const Rational& y1, const Rational& height) {
  return surface_of(uniform_axis(1, 1), uniform_axis(1, 1),
                    {{x0, y0, height}, {x0, y1, height}, {x1, y0, height}, {x1, y1, height}});
}
/// z = a x^2 + b y^2 + c over [-1, 1]^2.
BSplineSurface<Rational> paraboloid(const Rational& a, const Rational& b, const Rational& c) {
  Net net;
  const std::array<Rational, 3> square{q(1), q(-1), q(1)};  // x^2 in Bernstein form on [-1, 1]
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      net.push_back(
          {q(i - 1), q(j - 1),
           a * square[static_cast<std::size_t>(i)] + b * square[static_cast<std::size_t>(j)] + c});
  return surface_of(uniform_axis(2, 1), uniform_axis(2, 1), net);
}

SurfaceIntersection of(const BSplineSurface<Rational>& a, const BSplineSurface<Rational>& b) {
  auto out = intersect(a, b);
  EXPECT_TRUE(out.has_value()) << to_string(out.error());
  return std::move(*out);
}
std::size_t num_closed(const SurfaceIntersection& x) {
  std::size_t n = 0;
  for (const auto& b : x.branches) n += b.is_closed ? 1 : 0;
  return n;
}

TEST(SurfaceIntersection, APlaneCutsAParaboloidInOneLoop) {
  const auto x = of(paraboloid(q(1), q(1), q(0)), plane(q(-2), q(2), q(-2), q(2), q(1, 4)));
  ASSERT_EQ(x.branches.size(), 1u);
  EXPECT_TRUE(x.branches[0].is_closed);
  EXPECT_TRUE(x.is_complete());
  EXPECT_TRUE(x.tangencies.empty() && x.overlaps.empty());
  // The circle of radius 1/2.
  EXPECT_LE(x.branches[0].length.lo(), 3.14159265358979);
  EXPECT_GE(x.branches[0].length.hi(), 3.14159265358979);
  EXPECT_LE(wid(x.branches[0].length), 0.1);
  EXPECT_LE(x.branches[0].gap, 1e-6);
}

TEST(SurfaceIntersection, ABranchRunsFromBorderToBorder) {
  const auto x = of(paraboloid(q(1), q(1), q(0)), plane(q(0), q(2), q(-2), q(2), q(1, 4)));
  ASSERT_EQ(x.branches.size(), 1u);
  EXPECT_FALSE(x.branches[0].is_closed);
  EXPECT_TRUE(x.is_complete());
  EXPECT_LE(x.branches[0].length.lo(), 1.570796326794897);
  EXPECT_GE(x.branches[0].length.hi(), 1.570796326794896);
}

TEST(SurfaceIntersection, ABranchThatTouchesTheBorderIsNotDecidedThere) {
  // The ellipse x^2 + 2 y^2 = 1 touches x = -1 and x = 1.
  const auto x = of(paraboloid(q(1), q(2), q(-1)), plane(q(-2), q(2), q(-2), q(2), q(0)));
  EXPECT_FALSE(x.is_complete());
  for (const auto& place : x.unresolved) {
    EXPECT_LE(width(place.space), 1e-3);
    EXPECT_LE(mig(Interval::from_bounds(1, 1) - abs(place.space[0])), 1e-6);
  }
  ASSERT_EQ(x.branches.size(), 2u);
  EXPECT_TRUE(x.branches[0].is_partial && x.branches[1].is_partial);
}

TEST(SurfaceIntersection, SegmentsFollowOneAnotherAlongTheTruth) {
  const auto x = of(paraboloid(q(1), q(2), q(-1, 2)), plane(q(-2), q(2), q(-2), q(2), q(0)));
  ASSERT_EQ(x.branches.size(), 1u);
  ASSERT_TRUE(x.branches[0].is_closed);
  const auto& segments = x.branches[0].segments;
  for (std::size_t i = 0; i < segments.size(); ++i) {
    const auto& next = segments[(i + 1) % segments.size()];
    for (std::size_t k = 0; k < 4; ++k)
      EXPECT_NEAR(segments[i].control[3][k], next.control[0][k], 1e-13);
    for (const double t : {0.0, 0.25, 0.5, 1.0}) {  // x = 2 u - 1, y = 2 v - 1
      const double s = 1 - t;
      double at[4];
      for (std::size_t k = 0; k < 4; ++k)
        at[k] = s * s * s * segments[i].control[0][k] + 3 * s * s * t * segments[i].control[1][k] +
                3 * s * t * t * segments[i].control[2][k] + t * t * t * segments[i].control[3][k];
      const double px = 2 * at[0] - 1, py = 2 * at[1] - 1;
      EXPECT_NEAR(px * px + 2 * py * py, 0.5, 2 * segments[i].gap + 1e-14);
      EXPECT_NEAR(px, 4 * at[2] - 2, segments[i].gap + 1e-14);
    }
  }
}

TEST(SurfaceIntersection, SurfacesThatAreApartMeetNowhere) {
  const auto x =
      of(paraboloid(q(1), q(1), q(0)), plane(q(-2), q(2), q(-2), q(2), q(-1, 1000000000)));
  EXPECT_TRUE(x.branches.empty() && x.is_complete() && x.tangencies.empty());
}

TEST(SurfaceIntersection, ATangentPlaneIsNamed) {
  const auto x = of(paraboloid(q(1), q(1), q(0)), plane(q(-2), q(2), q(-2), q(2), q(0)));
  EXPECT_TRUE(x.branches.empty());
  ASSERT_EQ(x.tangencies.size(), 1u);
  EXPECT_EQ(x.tangencies[0].shape, IntersectionContact::Shape::kElliptic);
  EXPECT_TRUE(is_member(0, x.tangencies[0].separation));
  EXPECT_LE(mag(x.tangencies[0].separation), 1e-14);
  EXPECT_LE(width(x.tangencies[0].space), 1e-6);
}

TEST(SurfaceIntersection, ASaddlesTangentPlaneIsHyperbolic) {
  const auto x = of(paraboloid(q(1), q(-1), q(0)), plane(q(-2), q(2), q(-2), q(2), q(0)));
  ASSERT_EQ(x.tangencies.size(), 1u);
  EXPECT_EQ(x.tangencies[0].shape, IntersectionContact::Shape::kHyperbolic);
}

TEST(SurfaceIntersection, NearlyCoincidentSurfacesAreNotDecided) {
  // The whole patch lies within rounding of the plane; in truth they meet in an ellipse, and have one common normal.
  const Rational tiny = q(1, 100000000000000);
  const auto x = of(paraboloid(tiny, tiny, q(-1, 2) * tiny), plane(q(-2), q(2), q(-2), q(2), q(0)));
  if (x.is_complete()) {
    ASSERT_EQ(x.branches.size(), 1u);
    EXPECT_TRUE(x.branches[0].is_closed);
  }
  EXPECT_TRUE(x.tangencies.empty());
}

// PROVES TUBE-2.CUT
TEST(SurfaceIntersection, ASpentBudgetIsNoProof) {
  IntersectionOptions options;
  for (const std::uint64_t pairs : {1u, 5u, 20u, 60u}) {
    options.budget.pairs = pairs;
    const auto x =
        intersect(paraboloid(q(1), q(1), q(0)), plane(q(-2), q(2), q(-2), q(2), q(1, 4)), options);
    ASSERT_TRUE(x.has_value());
    EXPECT_FALSE(x->is_complete()) << pairs;
    EXPECT_TRUE(x->tangencies.empty()) << pairs;
  }
}

TEST(SurfaceIntersection, BoxesHoldTheEndsOnTheBorder) {
  const auto x = of(paraboloid(q(1), q(1), q(0)), plane(q(0), q(2), q(-2), q(2), q(1, 4)));
  ASSERT_EQ(x.branches.size(), 1u);
  const auto& segments =
      x.branches[0].segments;  // the half circle ends at (0, -1/2, 1/4) and (0, 1/2, 1/4)
  for (const auto* end : {&segments.front(), &segments.back()}) {
    EXPECT_TRUE(is_member(0, end->space[0]));
    EXPECT_TRUE(is_member(0, end->parameters[2]));
    EXPECT_TRUE(is_member(0.5, abs(end->space[1])));
  }
}

TEST(SurfaceIntersection, ASurfaceOverlapsItself) {
  const auto s = paraboloid(q(1), q(2), q(0));
  const auto x = of(s, s);
  ASSERT_EQ(x.overlaps.size(), 1u);
  EXPECT_TRUE(is_subset(Interval::from_bounds(0, 1), x.overlaps[0].parameters[0]));
  EXPECT_TRUE(x.is_complete());
}

/// z = (x^2 - 1/4)^2 + b (y^2 - 1/4)^2 over [-1, 1]^2, of bidegree (4, 4).
BSplineSurface<Rational> double_well(const Rational& b) {
  // t^4 - t^2 / 2 + 1 / 16 on [-1, 1] in Bernstein form: t^4 has 1, -1, 1, -1, 1, and t^2 has 1, 0, -1/3, 0, 1.
  const std::array<Rational, 5> well{q(9, 16), q(-15, 16), q(59, 48), q(-15, 16), q(9, 16)};
  Net net;
  for (std::size_t i = 0; i < 5; ++i)
    for (std::size_t j = 0; j < 5; ++j)
      net.push_back({q(static_cast<std::int64_t>(i), 2) - q(1),
                     q(static_cast<std::int64_t>(j), 2) - q(1), well[i] + b * well[j]});
  return surface_of(uniform_axis(4, 1), uniform_axis(4, 1), net);
}

// PROVES TUBE-2, TUBE-2.EMPTY, TUBE-2.HELD
TEST(SurfaceIntersection, CountsLoops) {
  const auto floor = plane(q(-2), q(2), q(-2), q(2), q(1, 100));
  const auto four = of(double_well(q(1)), floor);
  EXPECT_EQ(four.branches.size(), 4u);
  EXPECT_EQ(num_closed(four), 4u);
  EXPECT_TRUE(four.is_complete());
  // Flat in y: two strips, each between two borders on both sides.
  const auto strips = of(double_well(q(0)), floor);
  EXPECT_EQ(strips.branches.size(), 4u);
  EXPECT_EQ(num_closed(strips), 0u);
  EXPECT_TRUE(strips.is_complete());
}

TEST(SurfaceIntersection, PiecesOfOneSurfaceMeetWhatTheWholeMeets) {
  // The knots of the inner borders run through the loops, and near their ends.
  BSplineSurface<Rational> wells = double_well(q(1));
  for (const Rational& knot : {q(1, 4), q(1, 2), q(7, 10)})
    for (std::size_t axis = 0; axis < 2; ++axis) wells = insert_knot(wells, axis, knot);
  BSplineSurface<Rational> floor = plane(q(-2), q(2), q(-2), q(2), q(1, 100));
  floor = insert_knot(floor, 0, q(1, 3));
  for (const bool is_swapped : {false, true}) {
    const auto x = is_swapped ? of(floor, wells) : of(wells, floor);
    EXPECT_EQ(x.branches.size(), 4u);
    EXPECT_EQ(num_closed(x), 4u);
    EXPECT_TRUE(x.is_complete());
  }
}

TEST(SurfaceIntersection, AnArcEndsInTwoCorners) {
  const BSplineSurface<Rational> tilted = surface_of(
      uniform_axis(1, 1), uniform_axis(1, 1),
      {{q(-1), q(-1), q(0)}, {q(-1), q(1), q(-2)}, {q(1), q(-1), q(2)}, {q(1), q(1), q(0)}});
  const auto x = of(tilted, plane(q(-2), q(2), q(-2), q(2), q(0)));
  ASSERT_EQ(x.branches.size(), 1u);
  EXPECT_TRUE(x.is_complete());
  EXPECT_FALSE(x.branches[0].is_closed);
  EXPECT_LE(x.branches[0].length.lo(), 2.8284271247461903);
  EXPECT_GE(x.branches[0].length.hi(), 2.82842712474619);
}

TEST(SurfaceIntersection, RationalSurfacesMeetAsTheirShapesDo) {
  // A quarter of a cylinder of radius 1 along z, exactly, and a plane at height 1/3: a quarter circle.
  const std::vector<Rational> x{q(1), q(1), q(0)}, y{q(0), q(1), q(2)}, w{q(1), q(1), q(2)};
  std::vector<Rational> c;
  for (int k = 0; k < 4; ++k)
    for (std::size_t i = 0; i < 3; ++i)
      for (int j = 0; j < 2; ++j)
        c.push_back(k == 0 ? x[i] : (k == 1 ? y[i] : (k == 2 ? q(j) * w[i] : w[i])));
  const BSplineSurface<Rational> cylinder({uniform_axis(2, 1), uniform_axis(1, 1)}, 4, true, c);
  const auto found = of(cylinder, plane(q(-2), q(2), q(-2), q(2), q(1, 3)));
  ASSERT_EQ(found.branches.size(), 1u);
  EXPECT_TRUE(found.is_complete());
  EXPECT_LE(found.branches[0].length.lo(), 1.570796326794897);
  EXPECT_GE(found.branches[0].length.hi(), 1.570796326794896);
  EXPECT_LE(found.branches[0].gap, 1e-6);
}

TEST(SurfaceIntersection, APartOverlapsTheWholeAlsoUnderAnotherMap) {
  // The part u in [0, 1/2] of the bowl, run through backwards in v and with u and v exchanged.
  const auto whole = paraboloid(q(1), q(2), q(0));
  Net net;
  const std::array<Rational, 3> xs{q(-1), q(-1, 2), q(0)}, x_squares{q(1), q(0), q(0)};
  for (int j = 2; j >= 0; --j)
    for (std::size_t i = 0; i < 3; ++i)
      net.push_back({xs[i], q(j - 1), x_squares[i] + q(2) * (j == 1 ? q(-1) : q(1))});
  const auto part = surface_of(uniform_axis(2, 1), uniform_axis(2, 1), net);
  const auto x = of(whole, part);
  ASSERT_EQ(x.overlaps.size(), 1u);
  EXPECT_TRUE(is_member(0.5, x.overlaps[0].parameters[0]));
  EXPECT_LE(wid(x.overlaps[0].parameters[0]), 0.5000001);
}

TEST(SurfaceIntersection, RefusesAPlaneCurveAndNamesTheSurface) {
  const BSplineSurface<Rational> flat({uniform_axis(1, 1), uniform_axis(1, 1)}, 2, false,
                                      std::vector<Rational>(8));
  const auto x = intersect(paraboloid(q(1), q(1), q(0)), flat);
  ASSERT_FALSE(x.has_value());
  EXPECT_EQ(x.error().code, Code::kBadArgument);
  EXPECT_NE(x.error().message.find("second"), std::string::npos);
}

}  // namespace
}  // namespace veritope
