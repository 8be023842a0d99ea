// SPDX-License-Identifier: LGPL-3.0-or-later
// Normals that are zero in corners or along sides, cusps, flat faces of any degree: from the search to both checkers.
// Beside each sound model a neighbour that is no solid.
#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <string>

#include "models/thin_shapes.h"
#include "solids/patches/patch_transform.h"
#include "tests/certify/patch_checkers.h"
#include "tests/certify/zero_shapes.h"

namespace veritope {
namespace {

using zero_shapes::Patches;
using zero_shapes::ratio;

enum class Boxes { kWithZeros, kFlatMesh, kFramed, kAny };

std::size_t num_boxes(const StarCover& cover, Boxes kind) {
  return static_cast<std::size_t>(
      std::count_if(cover.boxes.begin(), cover.boxes.end(), [&](const CoverBox& b) {
        if (kind == Boxes::kFramed) return b.framed != nullptr;
        if (kind == Boxes::kAny) return b.framed != nullptr || b.needs_version_2;
        return b.needs_version_2 && b.is_mesh == (kind == Boxes::kFlatMesh);
      }));
}

// Both checkers accept the certificate, which is of version 2 and has a box of this kind.
void expect_valid(const Patches& patches, Boxes kind, const std::string& what) {
  const CertifiedPatches c = certified_patches(patches);
  ASSERT_TRUE(c.decision.is_valid)
      << what << ": " << (c.decision.open ? c.decision.open->message : std::string("refuted"));
  EXPECT_EQ(c.decision.bodies, 1u) << what;
  EXPECT_TRUE(c.decision.cover.needs_version_2()) << what;
  EXPECT_GT(num_boxes(c.decision.cover, kind), 0u) << what;
  expect_accepted(c, what);
}
void expect_not_valid(const Patches& patches, const std::string& what) {
  EXPECT_FALSE(certified_patches(patches).decision.is_valid) << what;
}

TEST(ZeroCover, OfARoundSectionCutIntoFourSides) {
  expect_valid(zero_shapes::round_prism(), Boxes::kAny, "biquadratic caps");
  expect_valid(zero_shapes::round_prism(true), Boxes::kAny, "bicubic caps");
  expect_valid(zero_shapes::round_prism_with_middle_at(ratio(1, 4)), Boxes::kAny,
               "a cap with its middle moved");
}
// Images under automorphisms of space: nothing is flat.
TEST(ZeroCover, OfBentCapsAndBars) {
  const QuadraticShear shear{2, 0, 0, ratio(1, 2)};
  expect_valid(sheared(zero_shapes::round_prism(), shear), Boxes::kAny, "bent caps");
  expect_valid(sheared(zero_shapes::repeated_points_bar(), shear), Boxes::kAny, "a bent bar");
}
TEST(ZeroCover, OfARoundSectionThatFoldsIsNone) {
  expect_not_valid(zero_shapes::round_prism_with_middle_at(ratio(4)),
                   "a cap that leaves its border");
}

TEST(ZeroCover, OfAThinRoundPlateInFrames) {
  Patches plate = thin_shapes::turned(zero_shapes::round_prism());
  expect_valid(plate, Boxes::kFramed, "turned");
}

TEST(ZeroCover, OfRepeatedControlPoints) {
  expect_valid(zero_shapes::repeated_points_bar(), Boxes::kAny, "repeated points");
  expect_not_valid(zero_shapes::folded_bar(), "folded where points are repeated");
}

TEST(ZeroCover, OfCuspsWhoseCentresLieInATangentPlane) {
  expect_valid(zero_shapes::cusp_tip(), Boxes::kWithZeros, "a spike");
  expect_valid(zero_shapes::cusp_edge(), Boxes::kWithZeros, "a lens");
}

TEST(ZeroCover, OfAFlatFaceWithThreeCornersOnALine) {
  const auto prism = [](const Rational& x) {
    return zero_shapes::quad_prism(
        {{{ratio(0), ratio(0)}, {ratio(2), ratio(0)}, {x, x}, {ratio(0), ratio(2)}}});
  };
  expect_valid(prism(ratio(1)), Boxes::kAny, "a straight angle");
  expect_not_valid(prism(ratio(3, 4)), "a reflex angle");
}

TEST(MeshCover, OfBlocksWithFacesOfAnyDegree) {
  expect_valid(zero_shapes::four_blocks(), Boxes::kFlatMesh, "bilinear");
  for (const Rational& by : {ratio(0), ratio(1, 8)})
    expect_valid(zero_shapes::four_bent_blocks(by), Boxes::kFlatMesh,
                 "biquadratic, by " + by.to_string());
  expect_not_valid(zero_shapes::four_bent_blocks(ratio(2)), "folded in their planes");
}

// Flat patches need their planes, not frames: no coordinate of the turned model is a double.
TEST(MeshCover, OfTurnedBlocks) {
  expect_valid(thin_shapes::turned(zero_shapes::four_blocks()), Boxes::kFlatMesh, "turned");
}

// Mesh boxes cover all of the surface, and walks start at star boxes.
TEST(MeshCover, OfThinTurnedBlocksHasABoxForWalks) {
  const Rational one(1), zero;
  const AffineMap flatten{
      3, 3, {one, zero, zero, zero, one, zero, zero, zero, ratio(1, 1024)}, {zero, zero, zero}};
  const Patches thin = affine_image(zero_shapes::four_blocks(), flatten).value();
  expect_valid(thin_shapes::turned(thin), Boxes::kFlatMesh, "thin and turned");
}

// A walk that started at a mesh box would start at the origin, whatever lies there.
TEST(MeshCover, AloneHasNoWalks) {
  const PatchComplex complex = make_patch_complex(zero_shapes::four_blocks()).value();
  std::optional<PieceForest> forest;
  PatchDecisionOptions options;
  options.with_frames = true;
  PatchDecision decision = decide_patches(complex, options, &forest);
  ASSERT_TRUE(decision.is_valid);
  EXPECT_TRUE(find_shell_walks(*forest, decision.cover).missing.empty());
  for (CoverBox& box : decision.cover.boxes) box.is_mesh = true;
  EXPECT_EQ(find_shell_walks(*forest, decision.cover).missing.size(), 1u);
}

TEST(MeshCover, OfAFlatFoldedFaceIsNone) {
  expect_not_valid(patch_shapes::wrinkled_cube(), "a top of triangles folded like a Z");
}

// Only models that need them have version 2.
TEST(ZeroCover, IsNotTriedWhereThePlainSearchSucceeds) {
  for (const Patches& patches : {patch_shapes::octant_sphere(), patch_shapes::teapot(),
                                 patch_shapes::frustum(ratio(1), ratio(0), ratio(1))}) {
    const CertifiedPatches c = certified_patches(patches);
    ASSERT_TRUE(c.decision.is_valid);
    EXPECT_FALSE(c.decision.cover.needs_version_2());
  }
}

}  // namespace
}  // namespace veritope
