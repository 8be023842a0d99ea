// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/patches/patch_sources.h"

#include <gtest/gtest.h>

#include "robust/base/random.h"
#include "solids/patches/patch_knots.h"
#include "splines/bspline_degree.h"
#include "splines/bspline_domain.h"
#include "splines/bspline_pieces.h"
#include "splines/knot_insertion.h"
#include "tests/solids/patch_support.h"

namespace veritope {
namespace {

using Surface = BSplineSurface<Rational>;

std::vector<Surface> as_surfaces(const Patches& patches) {
  std::vector<Surface> out;
  for (const Patch& p : patches) out.push_back(to_bspline(p.tensor()));
  return out;
}

// The surface of the patch with a few more knots, higher degrees, another domain and corner 0.
Surface disguised(const Patch& patch, Random& random) {
  Surface s = to_bspline(turned(patch, static_cast<std::uint32_t>(random.below(4))).tensor());
  for (const std::size_t axis : {std::size_t{0}, std::size_t{1}}) {
    std::vector<Rational> knots;
    for (std::uint64_t k = random.below(4); k > 0; --k)
      knots.push_back(Rational(random.between(1, 9)) / 10);
    std::sort(knots.begin(), knots.end());
    knots.erase(std::unique(knots.begin(), knots.end()), knots.end());
    s = elevate(refine(s, axis, knots), axis, static_cast<int>(random.below(3)));
    s = with_domain(s, axis, Rational(random.between(-5, 5)), Rational(random.between(6, 9)))
            .value();
  }
  return s;
}

TEST(PatchesOfSurfaces, NeighboursWithOtherKnotsDegreesAndDomainsMatch) {
  Random random(6200);
  std::size_t most = 0;
  for (int round = 0; round < 6; ++round) {
    SCOPED_TRACE("round " + std::to_string(round) + " of seed 6200");
    for (const Patches& model :
         {unit_box(), patch_shapes::octant_sphere(), patch_shapes::torus(3, 1)}) {
      std::vector<Surface> surfaces;
      for (const Patch& p : model) surfaces.push_back(disguised(p, random));
      const Patches patches = patches_of(surfaces).value();
      const PatchComplex complex = complex_of(patches);
      EXPECT_TRUE(complex.is_closed_oriented_surface()) << all_findings(complex);
      EXPECT_EQ(complex.euler(), complex_of(model).euler());
      EXPECT_EQ(complex.shells().size(), 1u);
      most = std::max(most, patches.size());
    }
  }
  EXPECT_GT(most, 100u);  // knots did spread
}
TEST(PatchesOfSurfaces, KnotsSpreadAlongOppositeSidesOnly) {
  auto surfaces = as_surfaces(unit_box());
  surfaces[0] = insert_knot(surfaces[0], 0, Rational(1) / 3);
  const Patches patches = patches_of(surfaces).value();
  EXPECT_EQ(patches.size(), 10u);  // a belt of four faces is cut in two
  EXPECT_TRUE(complex_of(patches).is_closed_oriented_surface());
  EXPECT_EQ(patches[1].origin(), (PatchOrigin{PatchOrigin::Kind::kSurface, 0, {1, 0}}));
}
TEST(PatchesOfSurfaces, ASurfaceMayCloseOnItself) {
  const Patches ring = patch_shapes::torus(3, 1);
  BezierPieces<Rational, 2> pieces{{{{0, 1, 2, 3, 4}, {0, 1, 2, 3, 4}}}, {}};
  for (std::size_t u = 0; u < 4; ++u)
    for (std::size_t v = 0; v < 4; ++v) pieces.pieces.push_back(ring[4 * v + u].tensor());
  const std::vector<Surface> one{joined(pieces)};
  const PatchComplex complex = complex_of(patches_of(one).value());
  EXPECT_TRUE(complex.is_closed_oriented_surface()) << all_findings(complex);
  EXPECT_EQ(complex.num_vertices(), 16u);
  EXPECT_EQ(complex.euler(), 0);
  // The single patch with a knot in each axis.
  Surface torus = to_bspline(patch_shapes::one_patch_torus(3, 1)[0].tensor());
  torus = insert_knot(insert_knot(torus, 0, Rational(1) / 5), 1, Rational(3) / 4);
  const PatchComplex four = complex_of(patches_of(std::vector{torus}).value());
  EXPECT_TRUE(four.is_closed_oriented_surface()) << all_findings(four);
  EXPECT_EQ(four.num_vertices(), 4u);
  EXPECT_EQ(four.euler(), 0);
}
TEST(PatchesOfSurfaces, PeriodicAxesMatchAtTheirSeam) {
  // A tube of square section around a square: uniform quadratic in both axes, four control points a period.
  const auto axis = [] {
    std::vector<Rational> knots;
    for (int i = 0; i < 9; ++i) knots.push_back(i);
    return make_knot_axis(2, knots, true).value();
  };
  Surface tube({axis(), axis()}, 3, false, std::vector<Rational>(108));
  const int cosine[] = {1, 0, -1, 0}, sine[] = {0, 1, 0, -1};
  for (std::size_t i = 0; i < 6; ++i)
    for (std::size_t j = 0; j < 6; ++j) {
      const Rational rho = 3 + cosine[j % 4];
      tube.component(0)[6 * i + j] = rho * Rational(cosine[i % 4]);
      tube.component(1)[6 * i + j] = rho * Rational(sine[i % 4]);
      tube.component(2)[6 * i + j] = sine[j % 4];
    }
  const PatchComplex complex = complex_of(patches_of(std::vector{tube}).value());
  EXPECT_EQ(complex.patches().size(), 16u);
  EXPECT_TRUE(complex.is_closed_oriented_surface()) << all_findings(complex);
  EXPECT_EQ(complex.euler(), 0);
}
// A strip whose ends are glued with half a twist: its breaks become symmetric.
TEST(CommonBreaks, AnAxisTiedToItselfInReverseIsCutSymmetrically) {
  const Patch strip = bilinear({{{0, 0, 0}, {0, 0, 1}, {1, 0, 1}, {1, 0, 0}}});
  Patch::Tensor map = elevate_to(strip.tensor(), {1, 3});
  // v runs around and returns to u = 0 at the point of u = 1.
  const PatchPoint ends[2] = {{0, 0, 0}, {0, 0, 1}};
  for (std::size_t c = 0; c < 3; ++c) {
    const auto b = map.component(static_cast<int>(c));
    b[0] = b[7] = ends[0][c], b[4] = b[3] = ends[1][c];
  }
  map.component(0)[1] = map.component(0)[5] = 5;
  map.component(1)[2] = map.component(1)[6] = 5;
  const Surface s = insert_knot(to_bspline(map), 0, Rational(1) / 4);
  const CommonBreaks breaks = common_breaks(std::vector{s});
  EXPECT_EQ(breaks.of(0, 0), (std::vector<Rational>{0, Rational(1) / 4, Rational(3) / 4, 1}));
  EXPECT_EQ(breaks.of(0, 1), (std::vector<Rational>{0, 1}));
  const PatchComplex complex = complex_of(patches_of(std::vector{s}).value());
  EXPECT_EQ(complex.count(PatchDefect::kOneSided), 1u);
  EXPECT_EQ(complex.count(PatchDefect::kOpenSide), 6u - 4u);
}
// Poles in one place tie nothing.
TEST(CommonBreaks, CollapsedSidesTieNothing) {
  auto surfaces = as_surfaces(patch_shapes::octant_sphere());
  surfaces[0] = insert_knot(surfaces[0], 0, Rational(1) / 2);
  std::size_t cut = 0;
  const CommonBreaks breaks = common_breaks(surfaces);
  for (std::size_t s = 0; s < surfaces.size(); ++s) cut += breaks.of(s, 0).size() - 2;
  EXPECT_EQ(cut, 2u);  // this octant and the one across the equator
}

TEST(SplineCurveForm, DoesNotSeeKnotsThatTheCurveDoesNotNeed) {
  Random random(6201);
  for (int round = 0; round < 100; ++round) {
    SCOPED_TRACE("round " + std::to_string(round) + " of seed 6201");
    const bool is_rational = round % 2 == 0;
    const int width = is_rational ? 4 : 3;
    auto axis = make_knot_axis(2, {0, 0, 0, 1, 1, 3, 4, 4, 4}).value();
    BSplineCurve<Rational> curve({axis}, width, is_rational,
                                 std::vector<Rational>(static_cast<std::size_t>(6 * width)));
    for (Rational& v : curve.coefficients()) v = random.between(1, 20);
    auto other = with_domain(curve, 0, Rational(-1), Rational(7)).value();
    other = elevate(insert_knot(other, 0, Rational(random.between(0, 6))), 0, 1);
    if (is_rational)
      for (Rational& v : other.coefficients()) v *= Rational(2) / 3;
    const bool is_reversed = random.below(2) == 1;
    if (is_reversed) other = reversed(other, 0);
    const auto a = internal::canonical_spline(curve), b = internal::canonical_spline(other);
    EXPECT_TRUE((a <=> b) == 0);
    EXPECT_EQ(internal::hash_of(a), internal::hash_of(b));
    EXPECT_EQ(a.breaks.size(), 2u);
    EXPECT_EQ(a.travel != b.travel, is_reversed);
    other.coefficients()[2] += Rational(1) / 64;
    EXPECT_FALSE((a <=> internal::canonical_spline(other)) == 0);
  }
}

TEST(PatchesOfSurfaces, WhatIsNoSurfaceInSpaceIsRefused) {
  const Surface plane = to_bspline(Patch::Tensor({1, 1}, 2, false));
  const auto refused = patches_of(std::vector{to_bspline(unit_box()[0].tensor()), plane});
  ASSERT_FALSE(refused.has_value());
  EXPECT_EQ(refused.error().code, Code::kBadArgument);
  EXPECT_EQ(refused.error().place.entity, std::optional<std::uint64_t>(1));
  const Surface high = to_bspline(Patch::Tensor({1, 64}, 3, false));
  EXPECT_EQ(patches_of(std::vector{high}).error().code, Code::kOverLimit);
}
// Knots of two surfaces that share a side multiply: 5,000 in one direction from each.
TEST(PatchesOfSurfaces, TooManyPiecesAreRefusedBeforeTheyAreMade) {
  std::vector<Rational> knots;
  for (int i = 1; i < 5000; ++i) knots.push_back(Rational(i) / 5000);
  const std::vector<Surface> two{
      refine(to_bspline(bilinear({{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}}).tensor()), 0,
             knots),
      refine(to_bspline(bilinear({{{1, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0}}}).tensor()), 1,
             knots)};
  const auto refused = patches_of(two);
  ASSERT_FALSE(refused.has_value());
  EXPECT_EQ(refused.error().code, Code::kOverLimit);
}

TEST(PatchesOfMeshes, AFacetWithoutItsVertexIsRefused) {
  TriangleMesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  mesh.faces = {{0, 1, 2}, {0, 1, 3}};
  const auto refused = patches_of(mesh);
  ASSERT_FALSE(refused.has_value());
  EXPECT_EQ(refused.error().code, Code::kIndexOutOfRange);
  EXPECT_EQ(refused.error().place.face, std::optional<std::uint64_t>(1));
}
TEST(PatchesOfMeshes, ExactAndRoundedPnTrianglesAreClosed) {
  TriangleMesh mesh;
  mesh.positions = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  mesh.faces = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4},
                {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
  const auto pn = make_pn_mesh(mesh, mesh.positions).value();
  for (const Patches& patches : {patches_of(pn), patches_of(rounded(pn).value())}) {
    const PatchComplex complex = complex_of(patches);
    EXPECT_TRUE(complex.is_closed_oriented_surface()) << all_findings(complex);
    EXPECT_EQ(complex.num_vertices(), 6u);
    EXPECT_EQ(complex.euler(), 2);
    EXPECT_GT(approx_volume(patches), 4.0 / 3);  // between the octahedron and the ball
    EXPECT_LT(approx_volume(patches), 4.18);
  }
}

// The unit cube from p on, as a trilinear volume.
BezierVolume<Rational> cell(const PatchPoint& p) {
  BezierVolume<Rational> out({1, 1, 1}, 3, false);
  for (std::size_t i = 0; i < 8; ++i)
    for (std::size_t c = 0; c < 3; ++c)
      out.component(static_cast<int>(c))[i] = p[c] + Rational((i >> (2 - c)) & 1);
  return out;
}
TEST(FacesOfVolumes, PointOutAndWallsBetweenVolumesAreLeftOut) {
  const Patches one = faces_of(std::vector{cell({0, 0, 0})}).value();
  EXPECT_TRUE(complex_of(one).is_closed_oriented_surface());
  EXPECT_NEAR(approx_volume(one), 1, 1e-12);
  const Patches row =
      faces_of(std::vector{cell({0, 0, 0}), cell({1, 0, 0}), cell({2, 0, 0})}).value();
  EXPECT_EQ(row.size(), 14u);
  EXPECT_TRUE(complex_of(row).is_closed_oriented_surface());
  EXPECT_NEAR(approx_volume(row), 3, 1e-12);
  EXPECT_EQ(faces_of(std::vector{BezierVolume<Rational>({1, 1, 1}, 2, false)}).error().code,
            Code::kBadArgument);
}
// A cell and its copy: no wall may vanish.
TEST(FacesOfVolumes, TheSameCellTwiceIsNamed) {
  const Patches twice = faces_of(std::vector{cell({0, 0, 0}), cell({0, 0, 0})}).value();
  EXPECT_EQ(twice.size(), 12u);
  EXPECT_EQ(complex_of(twice).count(PatchDefect::kRepeatedPatch), 6u);
}

}  // namespace
}  // namespace veritope
