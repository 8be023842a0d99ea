// SPDX-License-Identifier: LGPL-3.0-or-later
#include "interval/intersect/curve_intersection.h"

#include <gtest/gtest.h>

#include "interval/relations.h"
#include "tests/interval/spline_shapes.h"

namespace veritope {
namespace {

using shapes::at;

BSplineCurve<Rational> line(std::vector<Rational> from, const std::vector<Rational>& to) {
  std::vector<Rational> c;
  for (std::size_t k = 0; k < from.size(); ++k) c.push_back(from[k]), c.push_back(to[k]);
  return BSplineCurve<Rational>({shapes::bezier_axis(1)}, static_cast<int>(from.size()), false, c);
}
// (t, (t - 1)^2) for t in [0, 3], knots at 1 and 2.
BSplineCurve<Rational> parabola() {
  const KnotAxis<Rational> axis{2, {at(0), at(0), at(0), at(1), at(2), at(3), at(3), at(3)}, false};
  return BSplineCurve<Rational>(
      {axis}, 2, false,
      {at(0), at(1, 2), at(3, 2), at(5, 2), at(3), at(1), at(0), at(0), at(2), at(4)});
}

TEST(IntersectCurves, FindsCrossingsOnKnotsOnce) {
  // y = 1 - x/... through (0, 1) and (2, 1): t = 0, an end, and t = 2, a knot.
  const auto report = intersect_curves(parabola(), line({at(-1), at(1)}, {at(4), at(1)})).value();
  EXPECT_TRUE(report.is_complete());
  ASSERT_EQ(report.roots.size(), 2u);
  for (const auto& root : report.roots)
    EXPECT_TRUE(root.box[0].contains(at(0)) || root.box[0].contains(at(2))) << to_string(root.box);
}

TEST(IntersectCurves, NamesATouchAsACluster) {
  const auto report = intersect_curves(parabola(), line({at(0), at(0)}, {at(3), at(0)})).value();
  EXPECT_TRUE(report.roots.empty());
  ASSERT_FALSE(report.clusters.empty());
  bool holds = false;
  for (const auto& c : report.clusters) holds = holds || c.box[0].contains(at(1));
  EXPECT_TRUE(holds);
}

TEST(IntersectCurves, FindsCrossingsAtACorner) {
  const BSplineCurve<Rational> corner(
      {KnotAxis<Rational>{1, {at(0), at(0), at(1), at(2), at(2)}, false}}, 2, false,
      {at(0), at(0), at(1), at(1), at(0), at(0)});
  const auto report = intersect_curves(corner, line({at(-1), at(-1)}, {at(2), at(2)})).value();
  EXPECT_EQ(report.roots.size() + report.clusters.size(), 1u);
  const ExactBox<2> box = report.roots.empty() ? report.clusters[0].box : report.roots[0].box;
  EXPECT_TRUE(box.contains({at(1), at(1, 3)}));
}

TEST(IntersectCurves, RationalArcMeetsALineTwice) {
  const auto report =
      intersect_curves(shapes::quarter_circle(), line({at(9, 10), at(0)}, {at(0), at(9, 10)}));
  ASSERT_TRUE(report);
  EXPECT_EQ(report->roots.size(), 0u);
  EXPECT_TRUE(report->is_complete());
  EXPECT_EQ(intersect_curves(shapes::quarter_circle(), line({at(6, 5), at(0)}, {at(0), at(6, 5)}))
                .value()
                .roots.size(),
            2u);
}

TEST(IntersectCurveSurface, CountsStayAfterKnotInsertionAndMotion) {
  Random random(5);
  for (int loop = 0; loop < 3; ++loop) {
    const auto surface = shapes::random_surface(random, loop % 2 == 1);
    // Wavy, almost along the surface.
    const BSplineCurve<Rational> curve({shapes::bezier_axis(3)}, 3, false,
                                       {at(1, 5), at(1), at(3), at(4), at(1, 3), at(2, 3), at(3, 2),
                                        at(5, 2), at(1), at(-2), at(2), at(-1)});
    const auto report = intersect_curve_surface(curve, surface).value();
    EXPECT_TRUE(report.is_complete()) << loop;
    EXPECT_GT(report.roots.size(), 0u) << loop;
    auto finer = insert_knot(insert_knot(surface, 0, at(4, 3)), 1, at(1, 2));
    EXPECT_EQ(intersect_curve_surface(curve, finer).value().roots.size(), report.roots.size())
        << loop;
    const auto cut = insert_knot(curve, 0, at(1, 2));
    EXPECT_EQ(intersect_curve_surface(cut, surface).value().roots.size(), report.roots.size())
        << loop;
  }
}

TEST(IntersectCurveSurface, PiercesABowlTwice) {
  const auto report =
      intersect_curve_surface(line({at(-3), at(1, 7), at(1, 2)}, {at(3), at(1, 7), at(1, 2)}),
                              shapes::bowl(at(2)))
          .value();
  EXPECT_TRUE(report.is_complete());
  EXPECT_EQ(report.roots.size(), 2u);
}

TEST(NormalChords, EncloseTheGapOfSkewLines) {
  const auto chords = normal_chords(line({at(-1), at(0), at(0)}, {at(1), at(0), at(0)}),
                                    line({at(0), at(-1), at(3, 4)}, {at(0), at(2), at(3, 4)}))
                          .value();
  EXPECT_TRUE(chords.is_complete());
  ASSERT_EQ(chords.chords.size(), 1u);
  EXPECT_TRUE(is_member(0.75, chords.chords[0].gap));
  EXPECT_GT(chords.chords[0].gap.lo(), 0.7);
  EXPECT_TRUE(chords.chords[0].parameters.box.contains({at(1, 2), at(1, 3)}));
}

TEST(NormalChords, HoldZeroWhereCurvesMeetInSpace) {
  const auto chords = normal_chords(line({at(-1), at(0), at(0)}, {at(1), at(0), at(0)}),
                                    line({at(0), at(-1), at(-1)}, {at(0), at(2), at(2)}))
                          .value();
  ASSERT_EQ(chords.chords.size(), 1u);
  EXPECT_EQ(chords.chords[0].gap.lo(), 0);
  EXPECT_LT(chords.chords[0].gap.hi(), 1e-9);
}

TEST(IntersectCurves, RefuseBadInput) {
  const auto flat = line({at(0), at(0)}, {at(1), at(1)}),
             space = line({at(0), at(0), at(0)}, {at(1), at(1), at(1)});
  EXPECT_EQ(intersect_curves(flat, space).error().code, Code::kBadArgument);
  EXPECT_EQ(intersect_curve_surface(flat, shapes::bowl(at(1))).error().code, Code::kBadArgument);
  EXPECT_EQ(normal_chords(flat, space).error().code, Code::kBadArgument);
  auto arc = shapes::quarter_circle();
  arc.coefficients()[6] = at(0);
  EXPECT_EQ(intersect_curves(arc, flat).error().code, Code::kBadArgument);
}

}  // namespace
}  // namespace veritope
