// SPDX-License-Identifier: LGPL-3.0-or-later
// Bounds on searches: what suffices exactly, what is one too few, and what is kept.
#include <gtest/gtest.h>

#include "collar_model.h"
#include "models/thin_shapes.h"
#include "verify/certify/patch_decision.h"

namespace veritope {
namespace {

using collar_model::complex_of;

struct Decided {
  explicit Decided(std::uint64_t bytes, std::size_t boxes = 4'000'000) : budget(bytes) {
    PatchDecisionOptions options;
    options.budget = &budget;
    options.in_plain_frame = true;
    options.cover.max_boxes = boxes;
    decision = decide_patches(complex, options, &forest);
  }
  std::string code() const { return decision.open ? decision.open->code : ""; }

  PatchComplex complex = complex_of(patch_shapes::torus(3, 1));
  MemoryBudget budget;
  std::optional<PieceForest> forest;
  PatchDecision decision;
};

// The last steps ask for memory without which the answer is the same: nets that are kept warm, a tighter volume.
template <typename Suffices>
std::uint64_t least_memory(std::uint64_t enough, Suffices suffices) {
  std::uint64_t too_few = 0;
  while (enough - too_few > 1) {
    const std::uint64_t middle = too_few + (enough - too_few) / 2;
    (suffices(middle) ? enough : too_few) = middle;
  }
  return enough;
}
std::uint64_t least_memory_of_decision() {
  return least_memory(Decided(MemoryBudget::kUnlimited).budget.most(),
                      [](std::uint64_t bytes) { return Decided(bytes).decision.is_valid; });
}

TEST(Limits, ADecisionPassesWithTheMemoryThatItNeedsAndNotWithOneByteLess) {
  const Decided free(MemoryBudget::kUnlimited);
  ASSERT_TRUE(free.decision.is_valid);
  EXPECT_TRUE(Decided(free.budget.most()).decision.is_valid);
  const std::uint64_t need = least_memory_of_decision();
  EXPECT_TRUE(Decided(need).decision.is_valid);
  const Decided less(need - 1);
  EXPECT_EQ(less.decision.verdict(), Verdict::kUndecided);
  EXPECT_EQ(less.code(), open_code::kMemory);
  EXPECT_NE(less.decision.open->message.find("boxes were tried"), std::string::npos);
}

TEST(Limits, ADecisionPassesWithTheBoxesThatItNeedsAndNotWithOneLess) {
  const Decided free(MemoryBudget::kUnlimited);
  const std::size_t need = free.decision.boxes_tried;
  EXPECT_TRUE(Decided(MemoryBudget::kUnlimited, need).decision.is_valid);
  const Decided less(MemoryBudget::kUnlimited, need - 1);
  EXPECT_EQ(less.decision.verdict(), Verdict::kUndecided);
  EXPECT_EQ(less.code(), open_code::kBudget);
}

// Memory is given back with what it was charged for, whether or not there was enough.
TEST(Limits, NothingStaysCharged) {
  for (const int bits : {0, 20, 40}) {
    const std::uint64_t bytes = std::uint64_t{1} << bits;
    Decided one(bytes);
    one.decision = {};
    one.forest.reset();
    EXPECT_EQ(one.budget.used(), 0u) << bytes;
  }
}

// Less memory never changes a verdict to another one: it is UNDECIDED or the same. A search may fail under a limit and
// pass under a lower one, as it drops its nodes at another time.
TEST(Limits, AreNeverAnsweredByAnotherVerdict) {
  const std::uint64_t need = least_memory_of_decision();
  for (std::uint64_t bytes = 1; bytes < 2 * need; bytes += need / 13) {
    const Decided one(bytes);
    EXPECT_FALSE(one.decision.refutation) << bytes;
    EXPECT_TRUE(one.decision.is_valid || bytes < need) << bytes;
    EXPECT_TRUE(one.decision.is_valid || one.code() == open_code::kMemory) << bytes;
  }
}

// At whatever step memory ends, the answer is UNDECIDED or the truth: also where boxes in frames and crossings are
// sought.
TEST(Limits, MayEndASearchAtAnyStep) {
  for (const thin_shapes::Walls walls : {thin_shapes::Walls::kApart, thin_shapes::Walls::kCrossing})
    for (const thin_shapes::Family& family : thin_shapes::families()) {
      if (family.name != "plate-turned" && family.name != "wedge") continue;
      const PatchComplex complex =
          complex_of(family.make(Rational(1) / Rational(10), walls));
      for (std::uint64_t bytes = 1; bytes < std::uint64_t{1} << 28; bytes += 1 + bytes / 3) {
        MemoryBudget budget(bytes);
        std::optional<PieceForest> forest;
        PatchDecisionOptions options;
        options.budget = &budget;
        options.with_frames = true;
        const PatchDecision decision = decide_patches(complex, options, &forest);
        EXPECT_NE(decision.verdict(), walls == thin_shapes::Walls::kApart ? Verdict::kInvalid
                                                                          : Verdict::kValid)
            << family.name << ", " << bytes << " bytes";
      }
    }
}

struct Searched {
  explicit Searched(std::uint64_t bytes, const CollarSearchOptions& options = {}) : budget(bytes) {
    forest.emplace(PieceForest::make(complex, PieceForest::FrameChoice::kPlain, &budget).value());
    cover = find_star_cover(*forest, {});
    if (cover.is_complete()) search = find_patch_collar(*forest, cover, options);
  }
  std::string code() const { return search.open ? search.open->code : ""; }

  PatchComplex complex = complex_of(patch_shapes::torus(3, 1));
  MemoryBudget budget;
  std::optional<PieceForest> forest;
  StarCover cover;
  PatchCollarSearch search;
};

TEST(Limits, ACollarIsFoundWithTheMemoryThatItNeedsAndNotWithOneByteLess) {
  const Searched free(MemoryBudget::kUnlimited);
  ASSERT_TRUE(free.search.collar);
  const std::uint64_t need = least_memory(free.budget.most(), [](std::uint64_t bytes) {
    return Searched(bytes).search.collar.has_value();
  });
  EXPECT_TRUE(Searched(need).search.collar);
  const Searched less(need - 1);
  EXPECT_TRUE(less.cover.is_complete());
  EXPECT_FALSE(less.search.collar);
  EXPECT_EQ(less.code(), open_code::kMemory);
  EXPECT_NE(less.search.open->message.find("cells were tried"), std::string::npos);
}

TEST(Limits, ACollarIsFoundWithTheCellsThatItNeedsAndNotWithOneLess) {
  const Searched free(MemoryBudget::kUnlimited);
  CollarSearchOptions options;
  options.max_cells = free.search.most_cells;
  EXPECT_TRUE(Searched(MemoryBudget::kUnlimited, options).search.collar);
  --options.max_cells;
  const Searched less(MemoryBudget::kUnlimited, options);
  EXPECT_FALSE(less.search.collar);
  EXPECT_EQ(less.code(), open_code::kBudget);
}

}  // namespace
}  // namespace veritope
