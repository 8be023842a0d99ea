// SPDX-License-Identifier: LGPL-3.0-or-later
#include "topology/octree_key.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "robust/base/random.h"
#include "tests/support/octree_shapes.h"
#include "topology/octree_key_set.h"

namespace veritope {
namespace {

OctreeCell random_cell(Random& random, unsigned max_level = OctreeKey::kMaxLevel) {
  const auto level = static_cast<std::uint32_t>(random.below(max_level + 1));
  const auto index = [&] {
    return static_cast<std::uint32_t>(random.below(std::uint64_t{1} << level));
  };
  const std::uint32_t i = index(), j = index(), k = index();
  return {level, i, j, k};
}

OctreeKey key(const OctreeCell& cell) { return OctreeKey::make(cell).value(); }

// By coordinates: the definition.
bool covers(const OctreeCell& a, const OctreeCell& b) {
  if (a.level > b.level) return false;
  const unsigned d = b.level - a.level;
  return b.i >> d == a.i && b.j >> d == a.j && b.k >> d == a.k;
}

TEST(OctreeKey, GivesBackTheCellThatItWasMadeOf) {
  for (std::uint32_t level = 0; level <= 3; ++level)
    for (std::uint32_t i = 0; i < 1u << level; ++i)
      for (std::uint32_t j = 0; j < 1u << level; ++j)
        for (std::uint32_t k = 0; k < 1u << level; ++k) {
          const OctreeCell cell{level, i, j, k};
          EXPECT_EQ(key(cell).cell(), cell) << to_string(cell);
        }
  Random random(1);
  for (int trial = 0; trial < 5000; ++trial) {
    const OctreeCell cell = random_cell(random);
    SCOPED_TRACE(to_string(cell));
    const OctreeKey k = key(cell);
    EXPECT_EQ(k.cell(), cell);
    EXPECT_EQ(k.level(), cell.level);
    EXPECT_EQ(k.size(), OctreeKey::kGrid >> cell.level);
    EXPECT_EQ(k.corner(), (std::array<std::uint32_t, 3>{cell.i * k.size(), cell.j * k.size(),
                                                        cell.k * k.size()}));
    EXPECT_EQ(OctreeKey::from_code(k.code()).value(), k);
  }
}

TEST(OctreeKey, IsRefusedOutOfRangeWithTheCellsName) {
  EXPECT_EQ(OctreeKey::make({21, 0, 0, 0}).error().code, Code::kBadArgument);
  for (const OctreeCell& cell :
       {OctreeCell{3, 8, 0, 0}, OctreeCell{3, 0, 8, 0}, OctreeCell{3, 0, 0, 8},
        OctreeCell{0, 1, 0, 0}, OctreeCell{20, 1u << 20, 0, 0}, OctreeCell{5, 0xffffffffu, 0, 0},
        OctreeCell{0xffffffffu, 0, 0, 0}}) {
    const auto made = OctreeKey::make(cell);
    ASSERT_FALSE(made) << to_string(cell);
    EXPECT_NE(made.error().message.find(to_string(cell)), std::string::npos)
        << made.error().message;
  }
  EXPECT_EQ(OctreeKey::make({3, 8, 0, 0}).error().message,
            "cell (level 3: 8 0 0): its level has indices 0 to 7");
}

TEST(OctreeKey, RefusesCodesOfNoCell) {
  for (const std::uint64_t code :
       {std::uint64_t{0}, std::uint64_t{2}, std::uint64_t{4}, std::uint64_t{1} << 61,
        std::uint64_t{1} << 63, ~std::uint64_t{0}, (std::uint64_t{1} << 60) | 2})
    EXPECT_FALSE(OctreeKey::from_code(code)) << code;
  EXPECT_EQ(OctreeKey::from_code(std::uint64_t{1} << 60).value(), OctreeKey());
  EXPECT_EQ(OctreeKey::from_code((std::uint64_t{1} << 61) - 1).value().cell(),
            (OctreeCell{20, 0xfffff, 0xfffff, 0xfffff}));
}

TEST(OctreeKey, ContainsWhatLiesInsideAndItsCodesAreOneInterval) {
  Random random(2);
  for (int trial = 0; trial < 20000; ++trial) {
    const OctreeCell a = random_cell(random, 3), b = random_cell(random, 4);
    EXPECT_EQ(key(a).contains(key(b)), covers(a, b)) << to_string(a) << to_string(b);
  }
}

TEST(OctreeKey, ParentsChildrenAndAncestorsAgreeWithCoordinates) {
  Random random(3);
  for (int trial = 0; trial < 3000; ++trial) {
    const OctreeCell cell = random_cell(random);
    SCOPED_TRACE(to_string(cell));
    const OctreeKey k = key(cell);
    for (unsigned level = 0; level <= cell.level; ++level) {
      const unsigned d = cell.level - level;
      EXPECT_EQ(k.ancestor(level).cell(),
                (OctreeCell{level, cell.i >> d, cell.j >> d, cell.k >> d}));
    }
    if (cell.level > 0) {
      EXPECT_EQ(k.parent(), k.ancestor(cell.level - 1));
    }
    if (cell.level == OctreeKey::kMaxLevel) continue;
    for (unsigned q = 0; q < 8; ++q) {
      const OctreeCell child{cell.level + 1, 2 * cell.i + (q & 1), 2 * cell.j + (q >> 1 & 1),
                             2 * cell.k + (q >> 2)};
      EXPECT_EQ(k.child(q).cell(), child);
      EXPECT_EQ(k.child(q) < k, q < 4);
    }
  }
}

TEST(OctreeKey, NeighboursAreOneStepAwayAndEndAtTheRootsWalls) {
  Random random(4);
  for (int trial = 0; trial < 5000; ++trial) {
    OctreeCell cell = random_cell(random);
    const std::uint32_t top = (1u << cell.level) - 1;
    std::uint32_t* const index[] = {&cell.i, &cell.j, &cell.k};
    const auto axis = static_cast<unsigned>(random.below(3));
    if (random.below(3) == 0) *index[axis] = random.below(2) == 0 ? 0 : top;  // at a wall
    const OctreeKey k = key(cell);
    SCOPED_TRACE(to_string(cell) + " axis " + std::to_string(axis));
    const std::uint32_t at = *index[axis];
    EXPECT_EQ(k.neighbour(axis, false).has_value(), at > 0);
    EXPECT_EQ(k.neighbour(axis, true).has_value(), at < top);
    for (const bool upper : {false, true}) {
      const auto next = k.neighbour(axis, upper);
      if (!next) continue;
      *index[axis] = upper ? at + 1 : at - 1;
      EXPECT_EQ(next->cell(), cell);
      EXPECT_EQ(next->neighbour(axis, !upper), k);
      *index[axis] = at;
    }
  }
}

TEST(OctreeKeySet, NamesNestedAndDoubledCells) {
  const auto message = [](const octree_shapes::Cells& cells) {
    const auto set = OctreeKeySet::make(std::span<const OctreeCell>(cells));
    return set ? std::string() : set.error().message;
  };
  EXPECT_EQ(message({{2, 1, 2, 3}, {1, 0, 0, 0}, {2, 1, 2, 3}}),
            "cell (level 2: 1 2 3) occurs twice");
  // The inner cell before and after the outer one's code, and far from it in the list.
  EXPECT_EQ(message({{3, 0, 0, 0}, {1, 1, 1, 1}, {1, 0, 0, 0}}),
            "cell (level 1: 0 0 0) contains cell (level 3: 0 0 0), which is in the set too");
  EXPECT_EQ(message({{1, 0, 0, 0}, {1, 1, 1, 1}, {3, 3, 3, 3}}),
            "cell (level 1: 0 0 0) contains cell (level 3: 3 3 3), which is in the set too");
  EXPECT_EQ(message({{0, 0, 0, 0}, {20, 0, 0, 0}}),
            "cell (level 0: 0 0 0) contains cell (level 20: 0 0 0), which is in the set too");
  EXPECT_EQ(message({{1, 0, 0, 0}, {1, 1, 0, 0}}), "");
}

TEST(OctreeKeySet, RefusesNothingAndCellsOutOfRange) {
  EXPECT_EQ(OctreeKeySet::make(std::vector<OctreeKey>{}).error().code, Code::kEmpty);
  EXPECT_EQ(OctreeKeySet::make(std::vector<OctreeKey>(OctreeKeySet::kMaxCells + 1)).error().code,
            Code::kOverLimit);
  const octree_shapes::Cells cells{{1, 0, 0, 0}, {1, 2, 0, 0}};
  const auto set = OctreeKeySet::make(std::span<const OctreeCell>(cells));
  ASSERT_FALSE(set);
  EXPECT_EQ(set.error().code, Code::kBadArgument);
  EXPECT_EQ(set.error().place.entity, 1u);
}

// All pairs against adjacent ones.
TEST(OctreeKeySet, AcceptsExactlyTheDisjointSets) {
  Random random(5);
  int accepted = 0;
  for (int trial = 0; trial < 4000; ++trial) {
    octree_shapes::Cells cells;
    for (std::uint64_t n = 1 + random.below(6); n > 0; --n) cells.push_back(random_cell(random, 3));
    bool disjoint = true;
    for (std::size_t a = 0; a < cells.size(); ++a)
      for (std::size_t b = 0; b < cells.size(); ++b)
        disjoint &= a == b || !covers(cells[a], cells[b]);
    const auto set = OctreeKeySet::make(std::span<const OctreeCell>(cells));
    EXPECT_EQ(set.has_value(), disjoint) << octree_shapes::text(cells);
    accepted += set.has_value();
  }
  EXPECT_GT(accepted, 400);
  EXPECT_LT(accepted, 3600);
}

TEST(OctreeKeySet, FindsLowerBounds) {
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    Random random(seed);
    octree_shapes::Cells cells = octree_shapes::random_cells(random, 4, 3, 6);
    if (cells.empty()) cells.push_back({});
    if (seed % 3 == 0)  // all in one corner
      for (int n = 0; n < 16; ++n) cells = octree_shapes::into_octant(cells, seed % 2, 0, 1);
    const OctreeKeySet set = OctreeKeySet::make(std::span<const OctreeCell>(cells)).value();
    EXPECT_TRUE(std::is_sorted(set.keys().begin(), set.keys().end()));
    const auto expect_bound = [&](std::uint64_t code) {
      std::size_t want = 0;
      while (want < set.size() && set[want].code() < code) ++want;
      EXPECT_EQ(set.lower_bound(code), want) << "seed " << seed << " code " << code;
    };
    for (const OctreeKey k : set.keys())
      for (const std::uint64_t code :
           {k.first_code(), k.code() - 1, k.code(), k.code() + 1, k.last_code() + 1})
        expect_bound(code);
    for (int n = 0; n < 100; ++n) expect_bound(random.below(std::uint64_t{1} << 61));
    expect_bound(0);
    expect_bound(~std::uint64_t{0});
  }
}

}  // namespace
}  // namespace veritope
