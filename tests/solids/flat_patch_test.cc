// SPDX-License-Identifier: LGPL-3.0-or-later
// Which patches are flat: beside each condition a patch that only it refuses.
#include "solids/star_box/flat_patch.h"

#include <gtest/gtest.h>

#include <cmath>

#include "solids/patches/patch_transform.h"
#include "solids/star_box/mesh_box.h"
#include "splines/bezier_triangle_algebra.h"
#include "tests/certify/zero_shapes.h"
#include "tests/solids/patch_support.h"

namespace veritope {
namespace {

using zero_shapes::elevated_patch;
using zero_shapes::polynomial;
using zero_shapes::ratio;

// In the plane z = x + 2 y.
PatchPoint on_plane(const Rational& x, const Rational& y) { return {x, y, x + ratio(2) * y}; }
PatchPoint on_plane(int x, int y) { return on_plane(ratio(x), ratio(y)); }

Patch quad(const PatchPoint& a, const PatchPoint& b, const PatchPoint& c, const PatchPoint& d) {
  return polynomial(1, 1, {a, d, b, c});
}
Patch square() { return quad(on_plane(0, 0), on_plane(2, 0), on_plane(2, 2), on_plane(0, 2)); }
Patch with_point(const Patch& patch, std::size_t at, const PatchPoint& to) {
  Patch out = patch;
  for (int k = 0; k < 3; ++k) out = with_coefficient(out, k, at, to[static_cast<std::size_t>(k)]);
  return out;
}

// PROVES STAR-6
TEST(FlatPatch, IsAConvexQuadrilateralOfAnyDegreeInEitherOrientation) {
  EXPECT_TRUE(is_flat_patch(square()));
  EXPECT_TRUE(is_flat_patch(reversed(square())));
  EXPECT_TRUE(is_flat_patch(quad(on_plane(0, 0), on_plane(5, 0), on_plane(2, 1), on_plane(0, 1))));
  const Patch quadratic = elevated_patch(square());
  EXPECT_TRUE(is_flat_patch(quadratic));
  EXPECT_TRUE(is_flat_patch(elevated_patch(quadratic)));
  EXPECT_TRUE(is_flat_patch(with_point(quadratic, 4, on_plane(ratio(5, 4), ratio(1)))));
  // Control points of a side may be repeated: the normal is zero in a corner.
  EXPECT_TRUE(is_flat_patch(with_point(quadratic, 3, on_plane(0, 0))));
}

TEST(FlatPatch, LeavesNoPlane) {
  EXPECT_FALSE(is_flat_patch(with_point(square(), 3, {ratio(2), ratio(2), ratio(7)})));
  EXPECT_FALSE(is_flat_patch(
      with_point(elevated_patch(square()), 4, {ratio(1), ratio(1), ratio(3) + ratio(1, 1 << 30)})));
}
TEST(FlatPatch, HasStraightSides) {
  EXPECT_FALSE(
      is_flat_patch(with_point(elevated_patch(square()), 1, on_plane(ratio(-1, 8), ratio(1)))));
  EXPECT_FALSE(
      is_flat_patch(with_point(elevated_patch(square()), 1, on_plane(ratio(1, 8), ratio(1)))));
}
TEST(FlatPatch, IsStrictlyConvex) {
  EXPECT_FALSE(is_flat_patch(quad(on_plane(0, 0), on_plane(2, 0), on_plane(1, 1), on_plane(0, 2))));
  EXPECT_FALSE(is_flat_patch(
      quad(on_plane(0, 0), on_plane(2, 0), on_plane(ratio(1, 2), ratio(1, 2)), on_plane(0, 2))));
  EXPECT_FALSE(is_flat_patch(quad(on_plane(0, 0), on_plane(2, 2), on_plane(2, 0), on_plane(0, 2))));
  EXPECT_FALSE(is_flat_patch(quad(on_plane(0, 0), on_plane(2, 0), on_plane(2, 0), on_plane(0, 2))));
}
TEST(FlatPatch, DoesNotFoldInItsPlane) {
  EXPECT_FALSE(is_flat_patch(with_point(elevated_patch(square()), 4, on_plane(6, 1))));
  // A side that overshoots its corner lies on its line.
  EXPECT_FALSE(is_flat_patch(with_point(elevated_patch(square()), 1, on_plane(0, 6))));
}
TEST(FlatPatch, IsPolynomial) {
  const Rational zero, one(1);
  const std::vector<zero_shapes::HomogeneousPoint> points{{zero, zero, zero, one},
                                                          {zero, one, zero, one},
                                                          {one, zero, zero, one},
                                                          {one, one, zero, one}};
  EXPECT_FALSE(is_flat_patch(zero_shapes::rational(1, 1, points)));
}
TEST(FlatPatch, MayBeATriangle) {
  const Patch one = flat(on_plane(0, 0), on_plane(3, 0), on_plane(0, 3));
  EXPECT_TRUE(is_flat_patch(one));
  const auto cubic = [&](const PatchPoint& middle) {
    std::vector<Rational> values;
    for (std::size_t k = 0; k < 3; ++k) {
      std::vector<Rational> component(num_triangle_coefficients(3));
      for_each_triangle_index(
          3, [&](int, int j, int l) { component[triangle_index(j, l)] = on_plane(j, l)[k]; });
      component[triangle_index(1, 1)] = middle[k];
      values.insert(values.end(), component.begin(), component.end());
    }
    return make_patch(Patch::Triangle(3, 3, false, std::move(values))).value();
  };
  EXPECT_TRUE(is_flat_patch(cubic(on_plane(1, 1))));
  EXPECT_FALSE(is_flat_patch(cubic(on_plane(5, 5))));
  EXPECT_FALSE(is_flat_patch(cubic({ratio(1), ratio(1), ratio(4)})));
  EXPECT_FALSE(is_flat_patch(flat(on_plane(0, 0), on_plane(1, 0), on_plane(3, 0))));
}

// The vertex of four blocks, around which faces of three planes meet.
TEST(MeshBox, TakesQuadrilateralsWholeIfVersion2IsAllowed) {
  const PatchComplex complex = complex_of(zero_shapes::four_blocks());
  PieceForest forest = PieceForest::make(complex).value();
  const double at = std::ldexp(1.0, forest.scale());
  const Box3d box{{0.75 * at, 0.75 * at, 0.75 * at}, {1.25 * at, 1.25 * at, 1.25 * at}};
  FlatPatches all(complex, FlatPatches::Kind::kAll);
  FlatPatches triangles(complex, FlatPatches::Kind::kTriangles);
  const auto found = mesh_box_patches(forest, all, box, 48);
  ASSERT_TRUE(found.has_value());
  EXPECT_GE(found->size(), 6u);
  EXPECT_FALSE(mesh_box_patches(forest, triangles, box, 48));
  EXPECT_FALSE(mesh_box_patches(forest, all, box, found->size() - 1));
}

}  // namespace
}  // namespace veritope
