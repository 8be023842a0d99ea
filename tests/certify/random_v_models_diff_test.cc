// SPDX-License-Identifier: LGPL-3.0-or-later
// Random V-models of known truth, decided, certified, and judged by the C++ checker: a sample of what
// bench/soak_v_models.cc runs at length.
#include <gtest/gtest.h>

#include "tests/support/v_model_judge.h"

namespace veritope::random_v_models {
namespace {

using Make = Model (*)(Random&);

// check(model, what certify says of it) for `count` seeds from 1 on, and for one other description of each.
template <typename Check>
void for_each_v_model(std::uint64_t count, Make make, Check check) {
  for (std::uint64_t seed = 1; seed <= count; ++seed) {
    Random random(seed * 1000003);
    const Model model = make(random);
    const auto change = static_cast<Change>(seed % kChangeNames.size());
    const Changed other = changed(model.cells, change, random);
    for (const bool is_changed : {false, true}) {
      const auto& cells = is_changed ? other.cells : model.cells;
      SCOPED_TRACE(
          "seed " + std::to_string(seed) + ": " + model.description +
          (is_changed ? std::string(", ") + kChangeNames[seed % kChangeNames.size()] : ""));
      const Judged j = judged(cells, is_changed && other.has_left_handed ? PatchOrientation::kAuto
                                                                         : PatchOrientation::kKeep);
      EXPECT_EQ(j.problem, "");
      ASSERT_NO_FATAL_FAILURE(check(model, j, is_changed && change == Change::kSplit));
    }
  }
}

// PROVES VMODEL-1
TEST(RandomVModelsDiff, ExclusiveOnesAreValidWithTheirNumbers) {
  for (const Make make : {grid, polycube, ring, helix})
    for_each_v_model(
        make == helix ? 1 : 4, make, [](const Model& model, const Judged& j, bool is_split) {
          ASSERT_EQ(j.verdict(), Verdict::kValid) << j.certified.findings.front().message;
          EXPECT_EQ(wrong_numbers(j, *model.solid, model.cells.size(), !is_split), "");
        });
}

TEST(RandomVModelsDiff, OnesWithOpposedFacesAreNeverInvalid) {
  for_each_v_model(5, opposed, [](const Model&, const Judged& j, bool) {
    ASSERT_NE(j.verdict(), Verdict::kInvalid) << j.code;
  });
}

TEST(RandomVModelsDiff, PlantedFoldsAreFoundAndNeverValid) {
  std::size_t undecided = 0;
  for_each_v_model(40, folded, [&](const Model& model, const Judged& j, bool) {
    EXPECT_TRUE(
        has_determinant(model.cells[model.folded_cell], *model.negative_at, Sign::kNegative));
    ASSERT_NE(j.verdict(), Verdict::kValid);
    if (j.verdict() == Verdict::kUndecided) {
      ++undecided;
    } else {
      EXPECT_EQ(j.code, "folded");
      EXPECT_TRUE(j.certified.findings.front().witness.fold);
    }
  });
  EXPECT_EQ(undecided, 0u);
}

TEST(RandomVModelsDiff, OverlapsAreInvalid) {
  for_each_v_model(8, overlapping, [](const Model&, const Judged& j, bool) {
    ASSERT_EQ(j.verdict(), Verdict::kInvalid);
  });
}

TEST(RandomVModelsDiff, ContactsAndPlacesThatAreNoManifoldAreNeverValid) {
  for (const Make make : {touching_at_sides, touching_inside, non_manifold})
    for_each_v_model(3, make, [](const Model&, const Judged& j, bool) {
      ASSERT_NE(j.verdict(), Verdict::kValid);
    });
}

}  // namespace
}  // namespace veritope::random_v_models
