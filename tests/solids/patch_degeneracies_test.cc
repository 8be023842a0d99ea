// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/patches/patch_degeneracies.h"

#include <gtest/gtest.h>

#include "models/patch_shapes.h"
#include "tests/solids/patch_support.h"

namespace veritope {
namespace {

using Kind = PatchDegeneracy::Kind;

std::vector<PatchDegeneracy> found_in(const Patch& patch) {
  return find_degeneracies(std::span(&patch, 1));
}

TEST(PatchDegeneracies, PatchesOfGoodModelsHaveNone) {
  for (const Patches& good : {unit_box(), patch_shapes::sphere(), patch_shapes::torus(3, 1)})
    EXPECT_TRUE(find_degeneracies(good).empty());
}

TEST(PatchDegeneracies, ASideThatIsOnePointIsLegal) {
  EXPECT_TRUE(found_in(bilinear({{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 0, 0}}})).empty());
}

TEST(PatchDegeneracies, APointAndACurveAreToldApart) {
  const PatchPoint p{1, 2, 3};
  const auto point = found_in(bilinear({p, p, p, p}));
  ASSERT_EQ(point.size(), 1u);
  EXPECT_EQ(point[0].kind, Kind::kPoint);
  // u and v run along one line: the image is a segment, though no two control points are equal.
  const auto segment = found_in(bilinear({{{0, 0, 0}, {1, 1, 0}, {3, 3, 0}, {2, 2, 0}}}));
  ASSERT_EQ(segment.size(), 1u);
  EXPECT_EQ(segment[0].kind, Kind::kCurve);
  const auto flat_triangle = found_in(flat({0, 0, 0}, {1, 1, 0}, {2, 2, 0}));
  ASSERT_EQ(flat_triangle.size(), 1u);
  EXPECT_EQ(flat_triangle[0].kind, Kind::kCurve);
}

// Segments from p to -k p all pass through the origin, at the parameter 1 / (1 + k).
TEST(PatchDegeneracies, ALineThatIsOnePointHasItsParameter) {
  const auto through = found_in(bilinear({{{1, 0, 1}, {-2, 0, -2}, {0, -2, -2}, {0, 1, 1}}}));
  ASSERT_EQ(through.size(), 1u);
  EXPECT_EQ(through[0].kind, Kind::kSingularLine);
  EXPECT_EQ(through[0].axis, 0u);
  EXPECT_EQ(through[0].at, (std::array{Rational(1) / Rational(3), Rational(1) / Rational(3)}));
  const auto other_axis =
      found_in(reversed(bilinear({{{1, 0, 1}, {-2, 0, -2}, {0, -2, -2}, {0, 1, 1}}})));
  ASSERT_EQ(other_axis.size(), 1u);
  EXPECT_EQ(other_axis[0].axis, 1u);
  // One corner is moved off: the segments no longer meet.
  EXPECT_TRUE(found_in(bilinear({{{1, 0, 1}, {-2, 0, -2}, {0, -2, -2}, {0, 1, 2}}})).empty());
}

TEST(PatchDegeneracies, ALineInsideATriangleIsFound) {
  const Rational half = Rational(1) / Rational(2);
  const auto found = found_in(pinched_triangle());
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].kind, Kind::kSingularLine);
  EXPECT_EQ(found[0].axis, 0u);
  EXPECT_EQ(found[0].at, (std::array{half, half}));
}

}  // namespace
}  // namespace veritope
