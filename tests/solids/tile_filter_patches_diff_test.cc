// SPDX-License-Identifier: LGPL-3.0-or-later
// Random tiles near round solids of patches against the equations of these; bench/soak_micro_filter_patches.cc runs
// more of them.
#include <gtest/gtest.h>

#include "solids/patches/patch_complex.h"
#include "tests/predicates/test_scale.h"
#include "tests/support/round_truth.h"

namespace veritope {
namespace {

using namespace round_truth;

constexpr std::uint64_t kRoundSeed = 20261202;

TEST(TileFilterPatchesDiff, EquationsOfRoundSolidsContradictNoStatus) {
  std::array<int, 5> seen{};
  for (int n = 0; n < scaled(60); ++n) {
    Random random(kRoundSeed + static_cast<std::uint64_t>(n));
    const bool is_affine = n % 4 != 0;
    const Case c = random_case(random, static_cast<Solid::Kind>(n % Solid::kNumKinds), is_affine);
    const PatchComplex complex = make_patch_complex(c.patches).value();
    const TileShape shape = micro_tiles::shape_of(c.tile);
    const CellFinding finding = TileFilter::make(complex).find({&c.map}, shape);
    std::optional<CellStatus> truth;
    if (is_affine) truth = status_of(c.solid, c.parts());
    ASSERT_EQ(fault_of(c, shape, finding, truth, 60, random), "")
        << "seed " << kRoundSeed << " case " << n << "\n"
        << c.text();
    if (truth && *truth != CellStatus::kTouching) {
      ASSERT_NE(finding.status, CellStatus::kUndecided)
          << "seed " << kRoundSeed << " case " << n << "\n"
          << c.text();
    }
    ++seen[static_cast<std::size_t>(finding.status)];
  }
  for (const std::size_t s : {0u, 1u, 3u}) EXPECT_GT(seen[s], 0) << s;
}

// The solid in another place and size with the cell, with its patches turned around and in another order.
TEST(TileFilterPatchesLaw, OtherDescriptionsAreOneQuestion) {
  for (int n = 0; n < scaled(12); ++n) {
    Random random(kRoundSeed + 1000 + static_cast<std::uint64_t>(n));
    const Case c = random_case(random, static_cast<Solid::Kind>(n % Solid::kNumKinds), n % 2 == 0);
    const TileShape shape = micro_tiles::shape_of(c.tile);
    const PatchComplex complex = make_patch_complex(c.patches).value();
    const CellStatus status = TileFilter::make(complex).status({&c.map}, shape);
    patch_shapes::Patches others;
    for (std::size_t i = c.patches.size(); i-- > 0;)
      others.push_back(turned(c.patches[i], static_cast<std::uint32_t>(random.below(4))));
    const PatchComplex other = make_patch_complex(others).value();
    EXPECT_EQ(TileFilter::make(other).status({&c.map}, shape), status)
        << "seed " << kRoundSeed << " case " << n << "\n"
        << c.text();
    const RVec shift{Rational(3), Rational(-5), Rational(1) / Rational(3)};
    const PatchComplex moved =
        make_patch_complex(patch_shapes::placed(c.patches, Rational(8), shift)).value();
    BezierVolume<Rational> map = c.map;
    for (std::size_t k = 0; k < 3; ++k)
      for (Rational& x : map.component(static_cast<int>(k))) x = Rational(8) * x + shift[k];
    EXPECT_EQ(TileFilter::make(moved).status({&map}, shape), status)
        << "seed " << kRoundSeed << " case " << n << "\n"
        << c.text();
  }
}

}  // namespace
}  // namespace veritope
