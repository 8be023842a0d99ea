// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/base/range_tree.h"

#include <gtest/gtest.h>

#include <span>
#include <string>
#include <utility>
#include <vector>

#include "robust/base/random.h"

namespace veritope {
namespace {

using Words = RangeTree<std::string>;

Words words(std::size_t n, unsigned jobs) {
  return Words(
      n, jobs, [](std::uint32_t p) { return "." + std::to_string(p); },
      [](const std::string& a, const std::string& b) { return a + b; });
}

void expect_words(const Words& tree, const TreeRange& r, std::uint32_t* next_node) {
  EXPECT_EQ(r.node, (*next_node)++);
  std::string all;
  for (std::uint32_t p = r.lo; p < r.hi; ++p) all += "." + std::to_string(p);
  EXPECT_EQ(tree[r], all) << "[" << r.lo << ", " << r.hi << ")";
  if (r.is_leaf()) return;
  EXPECT_EQ(r.left().size(), r.size() / 2);
  expect_words(tree, r.left(), next_node);
  expect_words(tree, r.right(), next_node);
}

TEST(RangeTree, EachNodeJoinsTheItemsOfItsRangeAndNodesAreNumberedInPreorder) {
  for (const std::size_t n : {1, 2, 3, 64, 65, 300, 4500})
    for (const unsigned jobs : {1u, 3u}) {
      SCOPED_TRACE(std::to_string(n) + " items, " + std::to_string(jobs) + " jobs");
      const Words tree = words(n, jobs);
      std::uint32_t next = 0;
      expect_words(tree, tree.root(), &next);
      EXPECT_EQ(next, 2 * n - 1);
    }
}

TEST(RangeTree, WithoutItemsIsEmpty) {
  EXPECT_TRUE(words(0, 1).is_empty());
  EXPECT_TRUE(Words().is_empty());
  EXPECT_FALSE(words(1, 1).is_empty());
}

struct Item {
  Point3d at;
  std::uint32_t number;
};

TEST(SplitAtMedian, PutsTheLesserHalfAlongTheLongestSideFirst) {
  Random random(5);
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (int trial = 0; trial < 20; ++trial) {
      std::vector<Item> items;
      for (std::uint32_t i = 0; i < 21; ++i) {
        Item item{{random.unit(), random.unit(), random.unit()}, i};
        item.at[axis] =
            static_cast<double>(random.below(8));  // up to seven times as long, with ties
        items.push_back(item);
      }
      items[0].at[axis] = 0, items[1].at[axis] = 8;
      const std::size_t middle = random.below(items.size());
      split_at_median(std::span(items), middle);
      const auto key = [&](const Item& item) { return std::pair(item.at[axis], item.number); };
      for (std::size_t i = 0; i < middle; ++i)
        for (std::size_t j = middle; j < items.size(); ++j) EXPECT_LT(key(items[i]), key(items[j]));
    }
}

}  // namespace
}  // namespace veritope
