// SPDX-License-Identifier: LGPL-3.0-or-later
#include "interval/intersect/distance.h"

#include <gtest/gtest.h>

#include "interval/intersect/point_projection.h"
#include "interval/relations.h"
#include "tests/interval/spline_shapes.h"

namespace veritope {
namespace {

using shapes::at;

bool encloses_root_of(const Interval& a, const Rational& square) {
  const Rational lo = Rational::from_double(a.lo()), hi = Rational::from_double(a.hi());
  return lo * lo <= square && square <= hi * hi;
}
// The four arcs of the unit circle, as one rational curve over [0, 4].
BSplineCurve<Rational> circle() {
  std::vector<Rational> knots{at(0), at(0), at(0)}, x, y, w;
  const long px[] = {1, 0, -1, 0, 1}, py[] = {0, 1, 0, -1, 0};
  for (
      int i = 0; i < 4;
      ++i) {  // ends of weight 1 and 2 in turn: weights (1, 1, 2), (2, 1, 1), ... by symmetry of the arc
    const bool back = i % 2 == 1;
    const long w0 = back ? 2 : 1, w2 = back ? 1 : 2;
    if (i == 0) x.push_back(at(w0 * px[0])), y.push_back(at(w0 * py[0])), w.push_back(at(w0));
    x.push_back(at(px[i] + px[i + 1])), y.push_back(at(py[i] + py[i + 1])), w.push_back(at(1));
    x.push_back(at(w2 * px[i + 1])), y.push_back(at(w2 * py[i + 1])), w.push_back(at(w2));
    knots.push_back(at(i + 1)), knots.push_back(at(i + 1));
  }
  knots.push_back(at(4));
  x.insert(x.end(), y.begin(), y.end());
  x.insert(x.end(), w.begin(), w.end());
  return BSplineCurve<Rational>({KnotAxis<Rational>{2, knots, false}}, 3, true, std::move(x));
}

TEST(Distance, FromAPointToACircle) {
  const Shape ring = Shape::of(circle()).value();
  const Shape p = Shape::point(std::vector<Rational>{at(3), at(4)}).value();
  const auto least = least_distance(p, ring).value(), greatest = greatest_distance(ring, p).value();
  EXPECT_TRUE(least.is_as_asked && greatest.is_as_asked);
  EXPECT_TRUE(is_member(4, least.distance)) << to_string(least.distance);
  EXPECT_TRUE(is_member(6, greatest.distance)) << to_string(greatest.distance);
  EXPECT_LT(least.distance.hi() - least.distance.lo(), 1e-5);
  EXPECT_LT(greatest.distance.hi() - greatest.distance.lo(), 1e-5);
}

TEST(Distance, AgreesWithProjectionOnRandomSurfaces) {
  Random random(3);
  for (int loop = 0; loop < 6; ++loop) {
    const auto surface = shapes::random_surface(random, loop % 2 == 1);
    std::vector<Rational> point;
    for (int k = 0; k < 3; ++k) point.push_back(at(static_cast<long>(random.between(-20, 40)), 10));
    const auto by_roots = project_point<2>(point, surface).value();
    const auto by_bounds =
        least_distance(Shape::point(point).value(), Shape::of(surface).value()).value();
    EXPECT_TRUE(by_bounds.is_as_asked) << loop;
    EXPECT_FALSE(is_disjoint(by_roots.least_distance, by_bounds.distance)) << loop;
  }
}

TEST(Distance, BetweenSurfacesIsBelowThatOfEverySample) {
  Random random(4);
  for (int loop = 0; loop < 3; ++loop) {
    const auto a = shapes::random_surface(random, true);
    auto b = shapes::random_surface(random, false);
    for (Rational& z : b.component(2)) z += at(5, 2);
    const auto d = least_distance(Shape::of(a).value(), Shape::of(b).value()).value();
    const auto most = greatest_distance(Shape::of(a).value(), Shape::of(b).value()).value();
    EXPECT_TRUE(d.is_as_asked && most.is_as_asked) << loop << " pairs " << d.pairs;
    for (int i = 0; i < 60; ++i) {
      const auto draw = [&](long n) { return at(static_cast<long>(random.between(0, n)), 7); };
      const auto p = shapes::value(a, {draw(21), draw(14)}),
                 q = shapes::value(b, {draw(21), draw(14)});
      Rational square;
      for (std::size_t k = 0; k < 3; ++k) square += (p[k] - q[k]) * (p[k] - q[k]);
      const Rational lo = Rational::from_double(d.distance.lo()),
                     hi = Rational::from_double(most.distance.hi());
      EXPECT_LE(lo * lo, square) << loop;
      EXPECT_LE(square, hi * hi) << loop;
    }
  }
}

TEST(Distance, OfCrossingCurvesIsZeroWithinTheAbsoluteWidth) {
  const BSplineCurve<Rational> a({shapes::bezier_axis(1)}, 2, false, {at(0), at(1), at(0), at(1)});
  const BSplineCurve<Rational> b({shapes::bezier_axis(1)}, 2, false,
                                 {at(0), at(1), at(2, 3), at(0)});
  const auto d = least_distance(Shape::of(a).value(), Shape::of(b).value()).value();
  EXPECT_TRUE(d.is_as_asked);
  EXPECT_EQ(d.distance.lo(), 0);
  EXPECT_LE(d.distance.hi(), 0x1p-40);
}

TEST(Distance, EndsWithinTheBudget) {
  DistanceOptions options;
  options.max_pairs = 10, options.relative_width = 1e-15, options.absolute_width = 1e-300;
  const auto d = least_distance(Shape::of(shapes::bowl(at(1))).value(),
                                Shape::point(shapes::point3(at(0), at(0), at(1))).value(), options)
                     .value();
  EXPECT_FALSE(d.is_as_asked);
  EXPECT_LE(d.pairs, 12u);
  EXPECT_TRUE(encloses_root_of(d.distance, at(3, 4)));  // at x^2 + y^2 = 1/2
}

// Opposite arcs of the circle: quarter 0 and quarter 2 are not neighbours, 0 and 3 meet over the seam.
TEST(SelfDistance, IsThatOfPartsThatDoNotMeet) {
  const Shape ring = Shape::of(circle()).value();
  EXPECT_TRUE(ring.are_neighbours(ring.pieces()[0], ring.pieces()[3]));
  EXPECT_FALSE(ring.are_neighbours(ring.pieces()[0], ring.pieces()[2]));
  const auto d = least_self_distance(ring).value();
  EXPECT_TRUE(d.is_as_asked);
  EXPECT_TRUE(encloses_root_of(d.distance, at(2)))
      << to_string(d.distance);  // from (0, 1) to (-1, 0)
}

TEST(SelfDistance, OfOnePieceHasNothingToCompare) {
  EXPECT_TRUE(
      least_self_distance(Shape::of(shapes::bowl(at(1))).value()).value().distance.is_empty());
}

TEST(Distance, RefusesBadInput) {
  const Shape p = Shape::point(std::vector<Rational>{at(1)}).value();
  const Shape q = Shape::point(std::vector<Rational>{at(1), at(2)}).value();
  EXPECT_EQ(least_distance(p, q).error().code, Code::kBadArgument);
  EXPECT_EQ(Shape::point({}).error().code, Code::kBadArgument);
  EXPECT_EQ(Shape::point(std::vector<Rational>(4)).error().code, Code::kBadArgument);
  DistanceOptions options;
  options.relative_width = 0;
  EXPECT_EQ(least_distance(p, p, options).error().code, Code::kBadArgument);
  EXPECT_EQ(least_self_distance(p, options).error().code, Code::kBadArgument);
  auto arc = shapes::quarter_circle();
  arc.coefficients()[7] = at(0);
  EXPECT_EQ(Shape::of(arc).error().message, "a weight is 0, not positive");
}

}  // namespace
}  // namespace veritope
