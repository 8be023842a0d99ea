// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/patches/patch_transform.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "tests/solids/patch_support.h"

namespace veritope {
namespace {

constexpr std::uint64_t kSeed = 6100;

// What does not depend on the description.
struct Summary {
  std::vector<std::int64_t> genus;
  double volume;
};
Summary summary_of(const Patches& patches) {
  const PatchComplex complex = complex_of(patches);
  EXPECT_TRUE(complex.is_closed_oriented_surface()) << all_findings(complex);
  Summary out{{}, approx_volume(patches)};
  for (const PatchShell& shell : complex.shells()) out.genus.push_back(shell.genus().value_or(-1));
  std::sort(out.genus.begin(), out.genus.end());
  return out;
}

void expect_same(const std::function<Patches(const Patches&)>& change, double volume_factor,
                 double tolerance) {
  for (const auto& shape : patch_shapes::sound_shapes()) {
    SCOPED_TRACE(shape.name);
    const Summary before = summary_of(shape.patches), after = summary_of(change(shape.patches));
    EXPECT_EQ(before.genus, after.genus);
    EXPECT_NEAR(after.volume, volume_factor * before.volume,
                tolerance * std::abs(volume_factor * before.volume));
  }
}

TEST(PatchTransform, AffineImagesKeepNormalsOutside) {
  const AffineMap turn{3, 3, {2, 1, 0, 0, Rational(1) / 3, 1, 1, 0, 1}, {5, -7, Rational(1) / 9}};
  AffineMap mirror = turn;
  for (std::size_t i = 0; i < 3; ++i) mirror.linear[i] = -mirror.linear[i];
  const double determinant = 2.0 / 3 + 1;
  for (const AffineMap& map : {turn, mirror})
    expect_same([&](const Patches& p) { return affine_image(p, map).value(); }, determinant, 1e-9);
}
TEST(PatchTransform, AFlatMapIsRefused) {
  const AffineMap flat{3, 3, {1, 2, 3, 2, 4, 6, 0, 0, 1}, {0, 0, 0}};
  EXPECT_EQ(affine_image(unit_box(), flat).error().code, Code::kBadArgument);
  EXPECT_EQ(
      affine_image(unit_box(), AffineMap{2, 3, std::vector<Rational>(6), {0, 0}}).error().code,
      Code::kBadArgument);
}
TEST(PatchTransform, RelabellingChangesNothing) {
  Random random(kSeed);
  expect_same([&](const Patches& p) { return relabelled(p, random); }, 1, 1e-3);
}
TEST(PatchTransform, ShearsKeepTopologyAndVolume) {
  const auto shear = [](const Patches& p) { return sheared(p, {0, 1, 2, Rational(1) / 16}); };
  expect_same(shear, 1, 0.02);
}
TEST(PatchTransform, DegreeElevationChangesNothing) {
  expect_same([](const Patches& p) { return elevated(p, 1); }, 1, 1e-9);
}
TEST(PatchTransform, SubdivisionKeepsTopologyAndVolume) {
  for (const auto& shape : patch_shapes::sound_shapes()) {
    SCOPED_TRACE(shape.name);
    const Patches fine = subdivided(shape.patches);
    EXPECT_EQ(fine.size(), 4 * shape.patches.size());
    const PatchComplex coarse_complex = complex_of(shape.patches), complex = complex_of(fine);
    EXPECT_TRUE(complex.is_closed_oriented_surface()) << all_findings(complex);
    EXPECT_EQ(complex.euler(), coarse_complex.euler());
    EXPECT_EQ(complex.shells().size(), coarse_complex.shells().size());
    EXPECT_NEAR(approx_volume(fine, 4), approx_volume(shape.patches, 8),
                1e-9 * approx_volume(shape.patches, 8));
  }
}
TEST(PatchTransform, CutsAlongBeltsKeepTopologyAndVolume) {
  Random random(kSeed + 2);
  std::size_t cut_in_part = 0;
  for (const auto& shape : patch_shapes::sound_shapes()) {
    SCOPED_TRACE(shape.name);
    const Patches cut = cut_along_belts(shape.patches, random);
    const std::size_t before = shape.patches.size();
    cut_in_part += cut.size() != before && cut.size() != 4 * before ? 1 : 0;
    const PatchComplex complex = complex_of(cut);
    EXPECT_TRUE(complex.is_closed_oriented_surface()) << all_findings(complex);
    EXPECT_EQ(complex.euler(), complex_of(shape.patches).euler());
    const int n = before < 20 ? 40 : 8;
    EXPECT_NEAR(approx_volume(cut, n), approx_volume(shape.patches, n),
                0.02 * approx_volume(cut, n));
  }
  EXPECT_GE(cut_in_part, 6u);
}
// Half of the patches, chosen at random, reversed: all directions agree again, and no more than half of a shell is reversed.
TEST(PatchTransform, AnyFlipsAreRepaired) {
  Random random(kSeed + 1);
  for (const auto& shape : patch_shapes::sound_shapes()) {
    SCOPED_TRACE(shape.name);
    Patches mixed = shape.patches;
    for (Patch& p : mixed)
      if (random.below(2) == 1) p = reversed(p);
    const PatchComplex complex = complex_of(mixed, PatchOrientation::kAuto);
    EXPECT_TRUE(complex.is_closed_oriented_surface()) << all_findings(complex);
    std::vector<std::size_t> num_reversed(complex.shells().size(), 0);
    for (const std::uint32_t p : complex.reversed()) {
      EXPECT_EQ(complex.patch(p), reversed(mixed[p]));
      ++num_reversed[complex.shell(p)];
    }
    for (std::size_t s = 0; s < num_reversed.size(); ++s)
      EXPECT_LE(2 * num_reversed[s], complex.shells()[s].patches);
  }
}

}  // namespace
}  // namespace veritope
