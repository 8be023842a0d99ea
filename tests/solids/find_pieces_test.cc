// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/pieces/find_pieces.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "robust/base/random.h"
#include "tests/solids/patch_support.h"

namespace veritope {
namespace {

using Id = PieceForest::Id;

// Finds the pieces without a tree over the roots, in another order.
struct Found {
  std::vector<Id> tested, held;
  std::size_t visits = 0;

  void visit(PieceForest& forest, Id id, const Box3d& box, double longest) {
    const Box3d hull = forest.node(id).hull;
    bool meets_it = true, is_in = true;
    double length = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      meets_it = meets_it && hull.lo[k] <= box.hi[k] && box.lo[k] <= hull.hi[k];
      is_in = is_in && box.lo[k] <= hull.lo[k] && hull.hi[k] <= box.hi[k];
      length = std::max(length, hull.hi[k] - hull.lo[k]);
    }
    if (!meets_it) return;
    ++visits;
    if (is_in) held.push_back(id);
    if (length <= longest) {
      tested.push_back(id);
      return;
    }
    const Id first = forest.children(id);
    for (Id k = 4; k-- > 0;) visit(forest, first + k, box, longest);
  }
};

TEST(FindPieces, FindsWhatALoopOverAllRootsFinds) {
  constexpr std::uint64_t kSeed = 41;
  Random random(kSeed);
  std::size_t tested_in_all = 0, held_in_all = 0;
  for (const Patches& patches :
       {patch_shapes::sphere(), patch_shapes::pn_torus(4, 3), unit_box()}) {
    const PatchComplex complex = complex_of(patches);
    PieceForest forest = PieceForest::make(complex).value();
    for (int trial = 0; trial < 12; ++trial) {
      const Id near = static_cast<Id>(random.below(forest.num_roots()));
      const Point3d c = approx_centre(forest.node(near).hull);
      Box3d box;
      for (std::size_t k = 0; k < 3; ++k) {
        box.lo[k] = c[k] - 0.4 * random.unit();
        box.hi[k] = c[k] + 0.4 * random.unit();
      }
      // Exactly as long as a piece that exists: such a piece is taken.
      const double longest =
          trial % 3 == 0 ? extent(forest.node(near).hull) : 0.1 + 0.3 * random.unit();
      Found expected;
      for (std::uint32_t r = 0; r < forest.num_roots(); ++r)
        expected.visit(forest, forest.root(r), box, longest);
      std::vector<Id> tested, held;
      ASSERT_TRUE(find_pieces(forest, box, longest, 4096, &tested, &held)) << kSeed << " " << trial;
      // Parents come before their children.
      for (std::size_t i = 0; i < held.size(); ++i) {
        const Id parent = forest.node(held[i]).parent;
        const auto at = std::find(held.begin(), held.end(), parent);
        EXPECT_TRUE(at == held.end() || at < held.begin() + static_cast<std::ptrdiff_t>(i));
      }
      std::sort(tested.begin(), tested.end()), std::sort(held.begin(), held.end());
      std::sort(expected.tested.begin(), expected.tested.end());
      std::sort(expected.held.begin(), expected.held.end());
      EXPECT_EQ(tested, expected.tested) << kSeed << " " << trial;
      EXPECT_EQ(held, expected.held) << kSeed << " " << trial;
      tested_in_all += tested.size(), held_in_all += held.size();
      // A limit of exactly that many pieces suffices, one fewer does not.
      if (expected.tested.empty() || 16 * (expected.tested.size() - 1) < expected.visits) continue;
      std::vector<Id> again, held_again;
      EXPECT_TRUE(find_pieces(forest, box, longest, tested.size(), &again, &held_again));
      EXPECT_EQ(again.size(), tested.size());
      again.clear();
      EXPECT_FALSE(find_pieces(forest, box, longest, tested.size() - 1, &again, &held_again));
    }
  }
  EXPECT_GT(tested_in_all, 100u);
  EXPECT_GT(held_in_all, 20u);
}

// A box at one corner of a flat square is met by one chain of pieces, of which only the last is small.
TEST(FindPieces, VisitsSixteenTimesAsManyPiecesAsItMayFind) {
  const PatchComplex complex = complex_of(unit_box());
  PieceForest forest = PieceForest::make(complex).value();
  const Box3d root = forest.node(0).hull;
  // Pieces that meet the line through the root's middle, by level: 1, then 4, then 4 ...
  Box3d box{approx_centre(root), approx_centre(root)};
  for (const int level : {2, 4, 6, 8}) {
    const double longest = std::ldexp(1.5 * extent(root), -level);
    Found expected;
    for (std::uint32_t r = 0; r < forest.num_roots(); ++r)
      expected.visit(forest, forest.root(r), box, longest);
    std::vector<Id> tested, held;
    const std::size_t most = expected.tested.size();
    ASSERT_EQ(most, 4u);
    EXPECT_EQ(find_pieces(forest, box, longest, most, &tested, &held),
              expected.visits <= 16 * most);
  }
  // By a function that never takes a piece: 16 visits, and not one more.
  std::size_t visits = 0;
  std::vector<Id> tested, held;
  EXPECT_FALSE(internal::find_small_pieces(
      forest, root, [&](Id) { return ++visits == 0; }, 1, &tested, &held));
  EXPECT_EQ(visits, 16u);
}

TEST(FindPieces, EndsAtTheGreatestLevel) {
  const PatchComplex complex = complex_of(unit_box());
  PieceForest forest = PieceForest::make(complex).value();
  const Point3d corner = forest.node(0).hull.lo;
  std::vector<Id> tested, held;
  int deepest = 0;
  const auto is_at = [&](int level) {
    return [&forest, &deepest, level](Id id) {
      deepest = std::max(deepest, int{forest.node(id).level});
      return forest.node(id).level == level;
    };
  };
  EXPECT_TRUE(internal::find_small_pieces(forest, {corner, corner}, is_at(PieceForest::kMaxLevel),
                                          4096, &tested, &held));
  EXPECT_EQ(deepest, PieceForest::kMaxLevel);
  EXPECT_FALSE(
      internal::find_small_pieces(forest, {corner, corner}, is_at(99), 4096, &tested, &held));
  EXPECT_EQ(deepest, PieceForest::kMaxLevel);
  EXPECT_THROW((void)forest.children(tested.back()), InternalError);
}

TEST(FindPieces, HullOfRootsContainsAllAndIsTight) {
  const PatchComplex complex = complex_of(patch_shapes::sphere());
  const PieceForest forest = PieceForest::make(complex).value();
  const Box3d all = hull_of_roots(forest);
  for (std::size_t k = 0; k < 3; ++k) {
    double lo = 1e9, hi = -1e9;
    for (std::uint32_t r = 0; r < forest.num_roots(); ++r) {
      lo = std::min(lo, forest.node(forest.root(r)).hull.lo[k]);
      hi = std::max(hi, forest.node(forest.root(r)).hull.hi[k]);
    }
    EXPECT_EQ(all.lo[k], lo);
    EXPECT_EQ(all.hi[k], hi);
  }
}

}  // namespace
}  // namespace veritope
