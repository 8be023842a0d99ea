// SPDX-License-Identifier: LGPL-3.0-or-later
// S1 with zeros, one condition after the other: beside each lie that only one condition refuses stands a neighbour for
// which it holds.
#include "solids/star_box/star_zeros.h"

#include <gtest/gtest.h>

#include <cmath>

#include "solids/star_box/star_box.h"
#include "tests/certify/zero_shapes.h"
#include "tests/solids/patch_support.h"

namespace veritope {
namespace {

using zero_shapes::ratio;

class Model {
 public:
  explicit Model(Patches patches)
      : complex_(complex_of(std::move(patches))),
        forest_(PieceForest::make(complex_, PieceForest::FrameChoice::kWhole).value()) {}

  PieceForest& forest() { return forest_; }
  /// For centres in the model's coordinates.
  bool holds(PieceForest::Id id, const Point3d& inside, const Point3d& outside) {
    return has_star_signs_or_zeros(forest_, id, scaled(inside, outside));
  }
  bool holds_strictly(PieceForest::Id id, const Point3d& inside, const Point3d& outside) {
    return has_star_signs(forest_, id, scaled(inside, outside));
  }
  PieceForest::Id root(std::uint32_t patch) const { return forest_.form(patch).first_root; }

 private:
  CentreLine scaled(Point3d inside, Point3d outside) const {
    const double s = std::ldexp(1.0, forest_.scale());
    for (double& v : inside) v *= s;
    for (double& v : outside) v *= s;
    return {inside, outside};
  }
  PatchComplex complex_;
  PieceForest forest_;
};

TEST(StarZeros, AreAllowedInCornersOfPatches) {
  Model model(zero_shapes::round_prism());
  const PieceForest::Id cap = model.root(0);
  EXPECT_TRUE(model.holds(cap, {0, 0, 0}, {0, 0, 2}));
  EXPECT_FALSE(model.holds_strictly(cap, {0, 0, 0}, {0, 0, 2}));
  EXPECT_FALSE(model.holds(cap, {0, 0, 2}, {0, 0, 0}));  // the other side
  EXPECT_FALSE(model.holds(cap, {0, 0, 0}, {0, 0, 1}));  // all coefficients are zero
  const PieceForest::Id first = model.forest().children(cap);
  for (PieceForest::Id k = 0; k < 4; ++k)
    EXPECT_TRUE(model.holds(first + k, {0, 0, 0}, {0, 0, 2})) << k;
}

// The middle control point decides whether the normal turns over near a corner.
TEST(StarZeros, DoNotHideANormalOfTheOtherSign) {
  for (const auto& [by, holds] : {std::pair{ratio(1, 4), true}, {ratio(4), false}}) {
    Model model(zero_shapes::round_prism_with_middle_at(by));
    EXPECT_EQ(model.holds(model.root(0), {0, 0, 0}, {0, 0, 2}), holds) << by.to_string();
  }
}

// PROVES STAR-5.FACES
// Both bars have the same faces. The normals of one are zero along a side of two patches; those of the other are zero
// along a line inside a patch.
TEST(StarZeros, LieOnSidesOfPatchesOnly) {
  Model cut(zero_shapes::repeated_points_bar());
  Model whole(zero_shapes::cut_bar({{ratio(-1), ratio(1), ratio(-1), ratio(1)}}));
  const Point3d inside{0, 0.5, 0.5}, outside{0, 0.5, 2};
  EXPECT_TRUE(cut.holds(cut.root(0), inside, outside));
  EXPECT_TRUE(cut.holds(cut.root(4), inside, outside));
  const PieceForest::Id top = whole.root(0), first = whole.forest().children(top);
  ASSERT_EQ(whole.forest().form(0).num_roots, 1u);
  EXPECT_FALSE(whole.holds(top, inside, outside));
  for (PieceForest::Id k = 0; k < 4; ++k)
    EXPECT_FALSE(whole.holds(first + k, inside, outside)) << k;
  // Beside that line nothing is zero.
  EXPECT_TRUE(whole.holds(whole.forest().children(first), inside, outside));
}

// A prism over the region above the parabola y = x^2, of which patch 0 is the lower wall.
Patches parabola_prism() {
  using zero_shapes::wall;
  const Rational zero, half = ratio(1, 2), one(1);
  Patches out{wall({{zero, zero}, {half, zero}, {one, one}}, zero, one),
              wall({{one, one}, {zero, one}}, zero, one),
              wall({{zero, one}, {zero, half}}, zero, one),
              wall({{zero, half}, {zero, zero}}, zero, one)};
  for (const bool is_upper : {true, false}) {
    std::vector<PatchPoint> points;
    const Rational z(is_upper ? 1 : 0);
    const std::array<std::array<Rational, 2>, 3> curve{{{zero, zero}, {half, zero}, {one, one}}};
    const std::array<Rational, 3> line{half, ratio(3, 4), one};
    for (std::size_t i = 0; i < 3; ++i)
      points.insert(points.end(), {PatchPoint{curve[i][0], curve[i][1], z}, {zero, line[i], z}});
    Patch cap = zero_shapes::polynomial(2, 1, points);
    out.push_back(is_upper ? cap : reversed(cap));
  }
  return out;
}

// PROVES STAR-5.RADIAL
// For a centre in the plane y = 0, which touches the wall along its side x = y = 0, g is zero there.
TEST(StarZeros, AreNotOnALineThroughACentre) {
  Model model(parabola_prism());
  const PieceForest::Id wall = model.root(0);
  const Point3d outside{1, 0, 0.5};
  EXPECT_TRUE(model.holds(wall, {-0.25, 0, 0.5}, outside));
  EXPECT_FALSE(model.holds_strictly(wall, {-0.25, 0, 0.5}, outside));
  EXPECT_FALSE(model.holds(wall, {0, 0, 0.5}, outside));
  EXPECT_FALSE(model.holds(wall, {0, 0, 3}, outside));
  EXPECT_TRUE(model.holds(wall, {0, 0.125, 0.5}, outside));
  EXPECT_FALSE(model.holds(wall, {-0.25, -0x1p-60, 0.5}, outside));  // by however little
  EXPECT_FALSE(model.holds(wall, {-0.25, 0, 0.5}, {1, 0x1p-60, 0.5}));
}

}  // namespace
}  // namespace veritope
