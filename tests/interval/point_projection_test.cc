// SPDX-License-Identifier: LGPL-3.0-or-later
#include "interval/intersect/point_projection.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "interval/relations.h"
#include "robust/base/random.h"
#include "tests/interval/spline_shapes.h"

namespace veritope {
namespace {

using shapes::at;
using shapes::point3;

template <std::size_t N>
std::string text(const Projection<N>& p) {
  std::string out;
  for (const auto& c : p.points) {
    out += "\n" + std::string(critical_kind_name(c.kind)) + " distance " + to_string(c.distance) +
           " at";
    for (std::size_t a = 0; a < N; ++a)
      out += (c.is_held[a] ? " held " : " ") + std::to_string(nearest_double(c.parameters[a].lo));
  }
  for (const auto& r : p.open)
    out += std::string("\nopen ") + open_reason_name(r.reason) + " " + to_string(r.parameters);
  return out;
}
bool encloses_root_of(const Interval& a, const Rational& square) {
  const Rational lo = Rational::from_double(a.lo()), hi = Rational::from_double(a.hi());
  return lo * lo <= square && square <= hi * hi;
}
template <std::size_t N>
int count(const Projection<N>& p, CriticalKind kind) {
  return static_cast<int>(std::count_if(p.points.begin(), p.points.end(), [&](const auto& c) {
    return c.kind == kind &&
           std::none_of(c.is_held.begin(), c.is_held.end(), [](bool h) { return h; });
  }));
}

// z = (x^2 + y^2) on [-2,2]^2, above a point of the axis: at height h > 1/2 a maximum in the middle, a circle of minima; off the axis
// the circle breaks up into a minimum and a saddle.
TEST(PointProjection, FindsAllCriticalPointsOfAParaboloid) {
  const auto bowl = shapes::bowl(at(2));
  const auto p = project_point<2>(point3(at(1, 10), at(1, 7), at(3, 2)), bowl).value();
  EXPECT_TRUE(p.is_complete()) << text(p);
  EXPECT_EQ(count(p, CriticalKind::kMinimum), 1) << text(p);
  EXPECT_EQ(count(p, CriticalKind::kSaddle), 1) << text(p);
  EXPECT_EQ(count(p, CriticalKind::kMaximum), 1) << text(p);
  ASSERT_TRUE(p.certified_nearest.has_value()) << text(p);
  EXPECT_EQ(p.points[*p.certified_nearest].kind, CriticalKind::kMinimum);
}

TEST(PointProjection, SaysOpenWhereACircleIsNearest) {
  SolverOptions options;
  options.max_boxes = 3000;
  const auto p =
      project_point<2>(point3(at(0), at(0), at(3, 2)), shapes::bowl(at(2)), options).value();
  EXPECT_FALSE(p.is_complete());
  EXPECT_FALSE(p.certified_nearest.has_value());
  // r^2 + (r^2 - 3/2)^2 has its minimum 5/4 at r^2 = 1.
  EXPECT_TRUE(encloses_root_of(p.least_distance, at(5, 4))) << to_string(p.least_distance);
}

// Every sample is at least least_distance away; some critical point attains it.
TEST(PointProjection, NoSampleIsNearer) {
  Random random(1);
  for (int loop = 0; loop < 6; ++loop) {
    const auto surface = shapes::random_surface(random, loop % 2 == 1);
    std::vector<Rational> point;
    for (int k = 0; k < 3; ++k) point.push_back(at(static_cast<long>(random.between(-20, 30)), 10));
    const auto p = project_point<2>(point, surface).value();
    EXPECT_TRUE(p.is_complete()) << "loop " << loop << text(p);
    ASSERT_TRUE(p.certified_nearest.has_value()) << "loop " << loop << text(p);
    const Rational low = Rational::from_double(p.least_distance.lo());
    for (long i = 0; i <= 12; ++i)
      for (long j = 0; j <= 12; ++j) {
        Rational square;
        const auto s = shapes::value(surface, {at(3 * i, 12), at(2 * j, 12)});
        for (std::size_t k = 0; k < 3; ++k) square += (s[k] - point[k]) * (s[k] - point[k]);
        EXPECT_LE(low * low, square) << "loop " << loop;
      }
  }
}

TEST(PointProjection, CountsStayUnderMotionsAndKnotInsertion) {
  Random random(2);
  for (int loop = 0; loop < 4; ++loop) {
    const auto surface = shapes::random_surface(random, loop % 2 == 1);
    const std::vector<Rational> point = point3(at(4, 3), at(7, 5), at(9, 4));
    const auto p = project_point<2>(point, surface).value();
    auto moved = surface;
    auto q = point;
    shapes::turn(moved), std::rotate(q.begin(), q.begin() + 1, q.end());
    q[0] = -q[0], q[1] = -q[1];
    auto knotted = insert_knot(surface, 0, at(7, 5));
    for (const auto& other :
         {project_point<2>(q, moved).value(), project_point<2>(point, knotted).value()}) {
      EXPECT_EQ(other.points.size(), p.points.size())
          << "loop " << loop << text(p) << "\n--" << text(other);
      for (const CriticalKind kind :
           {CriticalKind::kMinimum, CriticalKind::kSaddle, CriticalKind::kMaximum})
        EXPECT_EQ(count(other, kind), count(p, kind)) << "loop " << loop;
      EXPECT_FALSE(is_disjoint(other.least_distance, p.least_distance)) << "loop " << loop;
    }
  }
}

TEST(PointProjection, ReportsAFootOnAKnotOnce) {
  // The parabola (t, t^2), t in [0, 2], with a knot at 1. Normal at t = 1: (-2, 1).
  const BSplineCurve<Rational> parabola(
      {KnotAxis<Rational>{2, {at(0), at(0), at(0), at(1), at(2), at(2), at(2)}, false}}, 2, false,
      {at(0), at(1, 2), at(3, 2), at(2), at(0), at(0), at(2), at(4)});
  const std::vector<Rational> above{at(1) - at(2, 10), at(1) + at(1, 10)};
  const auto p = project_point<1>(above, parabola).value();
  EXPECT_TRUE(p.is_complete()) << text(p);
  EXPECT_EQ(count(p, CriticalKind::kMinimum), 1) << text(p);
  ASSERT_TRUE(p.certified_nearest.has_value()) << text(p);
  EXPECT_TRUE(p.points[*p.certified_nearest].parameters[0].contains(at(1)));
  EXPECT_TRUE(encloses_root_of(p.least_distance, at(1, 20))) << to_string(p.least_distance);
  EXPECT_EQ(p.points.size(), 3u) << text(p);  // and both ends
}

TEST(PointProjection, TakesCreasesAsBorders) {
  // A corner (0,1), (0,0), (1,0): degree 1.
  const BSplineCurve<Rational> corner(
      {KnotAxis<Rational>{1, {at(0), at(0), at(1), at(2), at(2)}, false}}, 2, false,
      {at(0), at(0), at(1), at(1), at(0), at(0)});
  const auto p = project_point<1>(std::vector<Rational>{at(-1), at(-1)}, corner).value();
  EXPECT_TRUE(p.is_complete()) << text(p);
  ASSERT_TRUE(p.certified_nearest.has_value()) << text(p);
  EXPECT_TRUE(p.points[*p.certified_nearest].is_held[0]);
  EXPECT_EQ(p.points[*p.certified_nearest].parameters[0].lo, at(1));
}

// The foot of (x, 0, 1) on the plate [0, 1]^2 lies on its border, critical with and without it.
TEST(PointProjection, ReportsAFootOnABorderOnce) {
  const BSplineSurface<Rational> plate(
      {shapes::bezier_axis(1), shapes::bezier_axis(1)}, 3, false,
      {at(0), at(0), at(1), at(1), at(0), at(1), at(0), at(1), at(0), at(0), at(0), at(0)});
  const auto p = project_point<2>(point3(at(1, 3), at(0), at(1)), plate).value();
  EXPECT_TRUE(p.is_complete()) << text(p);
  ASSERT_TRUE(p.certified_nearest.has_value()) << text(p);
  const auto& foot = p.points[*p.certified_nearest];
  EXPECT_EQ(foot.place, RootPlace::kOnBoundary);
  EXPECT_FALSE(foot.is_held[0] || foot.is_held[1]);
  EXPECT_EQ(foot.exact, (std::array<Rational, 2>{at(1, 3), at(0)}));
  EXPECT_TRUE(is_member(1, p.least_distance));
}

TEST(PointProjection, RationalArcHasTheRadiusAsDistance) {
  const auto arc = shapes::quarter_circle();
  const auto p = project_point<1>(std::vector<Rational>{at(3), at(3)}, arc).value();
  ASSERT_TRUE(p.certified_nearest.has_value()) << text(p);
  const Interval r = p.least_distance;  // sqrt 18 - 1
  EXPECT_TRUE(encloses_root_of(Interval::from_bounds(r.lo() + 1, r.hi() + 1), at(18)))
      << to_string(r);
  const auto centre = project_point<1>(std::vector<Rational>{at(0), at(0)}, arc).value();
  ASSERT_EQ(centre.open.size(), 1u);
  EXPECT_EQ(centre.open[0].reason, OpenReason::kZeroEquation);
  EXPECT_TRUE(is_member(1, centre.least_distance));
}

TEST(PointProjection, RefusesBadInput) {
  const auto bowl = shapes::bowl(at(1));
  EXPECT_EQ(project_point<2>(std::vector<Rational>{at(1), at(1)}, bowl).error().code,
            Code::kBadArgument);
  auto arc = shapes::quarter_circle();
  arc.coefficients()[8] = at(-1);
  EXPECT_EQ(project_point<1>(std::vector<Rational>{at(1), at(1)}, arc).error().message,
            "a weight is -1, not positive");
  SolverOptions options;
  options.root_width = at(0);
  EXPECT_EQ(project_point<2>(point3(at(0), at(0), at(0)), bowl, options).error().code,
            Code::kBadArgument);
}

}  // namespace
}  // namespace veritope
