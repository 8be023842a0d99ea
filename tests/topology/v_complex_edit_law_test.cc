// SPDX-License-Identifier: LGPL-3.0-or-later
// Random sequences of edits: the invariants, dd = 0, links and genera hold after each step; splits and merges keep the
// Euler characteristic and the Betti numbers; a refused edit changes nothing. Failures shrink.
#include <gtest/gtest.h>

#include <cstdint>
#include <cstdlib>
#include <string>

#include "tests/support/v_complex_edits.h"

namespace veritope {
namespace {

using namespace v_edits;

std::uint64_t scaled(std::uint64_t n) {
  const char* const scale = std::getenv("VERITOPE_TEST_SCALE");
  return scale == nullptr ? n : n * std::strtoull(scale, nullptr, 10);
}

void run_sequences(std::uint64_t first_seed, std::uint64_t count, std::size_t steps,
                   bool with_betti, Tally& tally) {
  for (std::uint64_t seed = first_seed; seed < first_seed + count; ++seed) {
    const std::string fault = run_and_shrink(random_sequence(seed, steps), with_betti, &tally);
    ASSERT_EQ(fault, "") << "seed " << seed;
  }
}

TEST(VComplexEditLaws, HoldInShortSequencesWithBettiNumbers) {
  Tally tally;
  run_sequences(1, scaled(150), 50, true, tally);
  for (std::uint32_t edit = 0; edit < kNumEdits; ++edit)
    EXPECT_GT(tally.done_by_edit[edit], 0u) << "edit " << edit;
  EXPECT_GT(tally.refused, 100u);
}

// 10^4 sequences of 50 steps.
TEST(VComplexEditLaws, HoldInManySequences) {
  Tally tally;
  run_sequences(100000, scaled(10000), 50, false, tally);
  EXPECT_GT(tally.done, 200000u);
}

// The runner would notice: a false law is found, and its sequence shrinks to the shortest that breaks it.
TEST(VComplexEditLaws, AFalseLawShrinks) {
  const auto two_cells = [](const VComplex& c) { return c.counts().internal_surfaces == 0; };
  const auto fails = [&](const Sequence& s) { return !run(s, false, nullptr, two_cells).empty(); };
  Sequence sequence;
  for (std::uint64_t seed = 1; !fails(sequence); ++seed) sequence = random_sequence(seed, 60);
  const Sequence small = shrink(sequence, fails);
  ASSERT_EQ(small.size(), 2u) << to_text(small);
  EXPECT_EQ(small[0][0], static_cast<std::uint32_t>(Edit::kAddCell));
  EXPECT_NE(small[1][0], static_cast<std::uint32_t>(Edit::kAddCell));
  EXPECT_NE(run(small, false, nullptr, two_cells).find("the law does not hold"), std::string::npos);
}

}  // namespace
}  // namespace veritope
