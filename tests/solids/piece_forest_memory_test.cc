// SPDX-License-Identifier: LGPL-3.0-or-later
// What a PieceForest keeps, drops and makes again.
#include "solids/pieces/piece_forest.h"

#include <gtest/gtest.h>

#include "tests/solids/exact_nodes.h"

namespace veritope {
namespace {

using Id = PieceForest::Id;

// A net that is dropped is made again with the same numbers; many nets do not overlap.
TEST(PieceForestNets, AreMadeAgainAsTheyWere) {
  Random random(31);
  const PatchComplex complex = both_sides(bent_sheet({false, 3, 3}, true, 0, 3, random));
  PieceForest forest = PieceForest::make(complex).value();
  forest.limit_memory(0);  // roots were made while the thread rounded upward
  std::vector<std::vector<double>> before;
  std::vector<Id> nodes;
  for (Id r = 0; r < forest.num_roots(); ++r) nodes.push_back(r);
  for (std::size_t k = 0; k < 40; ++k) {
    const Id first = forest.children(nodes[k]);
    for (Id c = 0; c < 4; ++c) nodes.push_back(first + c);
  }
  const auto numbers = [&](Id id) {
    const PieceForest::Form& form = forest.form(forest.node(id).patch);
    const double* const g = forest.approx_determinants(id);
    std::vector<double> out(g, g + 4 * form.determinant.count());
    const double* const x = forest.control(id);
    out.insert(out.end(), x, x + 4 * form.shape.count());
    for (std::size_t k = 0; k < 4; ++k)
      out.push_back(forest.control_error(id, k)), out.push_back(forest.determinant_error(id, k));
    return out;
  };
  for (const Id id : nodes) before.push_back(numbers(id));
  const double* const held = forest.control(0);
  forest.limit_memory(std::size_t{1} << 30);
  EXPECT_EQ(forest.control(0), held);
  for (std::size_t i = 0; i < nodes.size(); ++i) EXPECT_EQ(numbers(nodes[i]), before[i]) << i;
  forest.limit_memory(0);
  for (std::size_t i = nodes.size(); i-- > 0;) EXPECT_EQ(numbers(nodes[i]), before[i]) << i;
}

// Dropped nodes leave their numbers to others, which have nothing of them.
TEST(PieceForestNodes, TakeTheNumbersOfDroppedOnes) {
  Random random(32);
  const PatchComplex complex = both_sides(bent_sheet({false, 3, 3}, true, 0, 3, random));
  PieceForest forest = PieceForest::make(complex).value();
  const auto hulls_below = [&](auto& self, Id id, int depth) -> std::vector<double> {
    const Box3d& hull = forest.node(id).hull;
    std::vector<double> out(hull.lo.begin(), hull.lo.end());
    out.insert(out.end(), hull.hi.begin(), hull.hi.end());
    const double* const g = forest.approx_determinants(id);
    out.insert(out.end(), g, g + forest.form(forest.node(id).patch).determinant.count());
    for (Id k = 0; k < 4 && depth > 0; ++k) {
      const auto below = self(self, forest.children(id) + k, depth - 1);
      out.insert(out.end(), below.begin(), below.end());
    }
    return out;
  };
  const Id a = forest.root(0), b = forest.root(1);
  const std::vector<double> below_a = hulls_below(hulls_below, a, 3),
                            below_b = hulls_below(hulls_below, b, 3);
  const std::size_t nodes = forest.num_nodes();
  const std::uint64_t drops = forest.num_drops();
  forest.drop_children(a);
  EXPECT_EQ(forest.num_dropped(), 4u + 16u + 64u);
  EXPECT_NE(forest.num_drops(), drops);
  EXPECT_EQ(forest.node(a).first_child, PieceForest::kNone);
  forest.drop_children(b);
  EXPECT_EQ(hulls_below(hulls_below, b, 3), below_b);
  EXPECT_EQ(hulls_below(hulls_below, a, 3), below_a);
  EXPECT_EQ(forest.num_nodes(), nodes);
  EXPECT_EQ(forest.num_dropped(), 0u);
}

TEST(PieceForestNets, KeepToTheMemoryThatTheyMayUse) {
  Random random(47);
  const PatchComplex complex = both_sides(bent_sheet({false, 3, 3}, true, 0, 1, random));
  const auto used = [&](std::uint64_t limit, std::size_t bytes) {
    MemoryBudget budget(limit);
    PieceForest forest =
        PieceForest::make(complex, PieceForest::FrameChoice::kFitted, &budget).value();
    for (Id id = 0; id < 4000; ++id) {
      (void)forest.children(id);
      forest.limit_memory(bytes);
    }
    EXPECT_FALSE(forest.is_out_of_memory());
    const std::uint64_t out = budget.used();
    EXPECT_FALSE(budget.take(MemoryBudget::kUnlimited));
    EXPECT_TRUE(forest.is_out_of_memory());
    return out;
  };
  constexpr std::uint64_t kMebi = 1 << 20;
  const std::uint64_t all = used(MemoryBudget::kUnlimited, 1 << 30);
  EXPECT_LT(all, 20 * kMebi);
  EXPECT_LT(used(MemoryBudget::kUnlimited, 1 << 20), all - 4 * kMebi);
  EXPECT_LT(used(16 * kMebi, 1 << 30), all - 2 * kMebi);  // a quarter of the limit
  EXPECT_FALSE(PieceForest::make(complex).value().is_out_of_memory());
}

}  // namespace
}  // namespace veritope
