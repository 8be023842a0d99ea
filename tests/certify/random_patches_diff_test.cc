// SPDX-License-Identifier: LGPL-3.0-or-later
// Random patch models of known truth, decided, certified, and judged by the C++ checker: a sample of what bench/soak_patches.cc runs at length.
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/certify/patch_round_trip.h"
#include "tests/support/checker_call.h"
#include "tests/support/random_solids.h"
#include "verify/certify/star_cover.h"

namespace veritope {
namespace {

using random_solids::Model;

CertifiedPatches decided(const Model& model) {
  PatchDecisionOptions options;
  options.tolerance = 1e-2;
  return certified_patches(model.patches, options);
}
void expect_checked(const CertifiedPatches& c) {
  const std::string answer = check_in_process(c.file, std::string(c.bytes.begin(), c.bytes.end()));
  EXPECT_EQ(answer.substr(0, 7), "ACCEPT ") << answer;
}

// check(model, its decision) for the models of seeds 1 to `count`.
template <typename Make, typename Check>
void for_each_model(std::uint64_t count, Make make, Check check) {
  for (std::uint64_t seed = 1; seed <= count; ++seed) {
    Random random(seed);
    const Model model = make(random);
    SCOPED_TRACE("seed " + std::to_string(seed) + ": " + model.description);
    ASSERT_NO_FATAL_FAILURE(check(model, decided(model)));
  }
}

// PROVES STAR-1
TEST(RandomPatchesDiff, EmbeddedOnesAreValidWithTheirNumbers) {
  for_each_model(25, random_solids::embedded, [](const Model& model, const CertifiedPatches& c) {
    ASSERT_TRUE(c.decision.is_valid) << (c.decision.open ? c.decision.open->message : "invalid");
    std::vector<std::int64_t> genus;
    for (const PatchShellFacts& s : c.decision.shells) genus.push_back(s.genus);
    std::sort(genus.begin(), genus.end());
    EXPECT_EQ(genus, model.genus);
    EXPECT_EQ(c.decision.bodies, model.bodies);
    expect_checked(c);
  });
}

TEST(RandomPatchesDiff, PlantedCrossingsAreFoundAndNeverValid) {
  std::size_t undecided = 0;
  for_each_model(30, random_solids::crossing, [&](const Model&, const CertifiedPatches& c) {
    ASSERT_FALSE(c.decision.is_valid);
    if (c.decision.open)
      ++undecided;
    else
      expect_checked(c);
  });
  EXPECT_EQ(undecided, 0u);
}

TEST(RandomPatchesDiff, PlantedContactsAreNeverValid) {
  for_each_model(20, random_solids::touching, [](const Model&, const CertifiedPatches& c) {
    ASSERT_FALSE(c.decision.is_valid);
    if (!c.decision.open) expect_checked(c);
  });
}

// Where shells touch smoothly, or a vertex touches a face, gaps of every size surround the contact: a search that covers them first tries millions of boxes.
TEST(RandomPatchesDiff, ContactsAreRunDownToAfterAFewThousandBoxes) {
  for (const std::uint64_t seed : {41, 60, 63, 143, 174, 735, 914}) {
    Random random(seed);
    const Model model = random_solids::touching(random);
    SCOPED_TRACE("seed " + std::to_string(seed) + ": " + model.description);
    const PatchComplex complex = make_patch_complex(model.patches).value();
    PieceForest forest = PieceForest::make(complex).value();
    StarCoverOptions options;
    options.max_boxes = 10'000;
    const StarCover cover = find_star_cover(forest, options);
    ASSERT_FALSE(cover.is_complete());
    EXPECT_LT(cover.tried, options.max_boxes);
    EXPECT_LT(cover.uncovered.front().gap, 1e-6);
  }
}

}  // namespace
}  // namespace veritope
