// SPDX-License-Identifier: LGPL-3.0-or-later
#include "robust/base/disjoint_sets.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <thread>
#include <utility>
#include <vector>

#include "robust/base/random.h"

namespace veritope {
namespace {

using Joins = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

/// The least element of each element's class, by renaming the whole class at each join.
std::vector<std::uint32_t> least_by_renaming(std::size_t n, const Joins& joins) {
  std::vector<std::uint32_t> least(n);
  for (std::uint32_t i = 0; i < n; ++i) least[i] = i;
  for (const auto& [a, b] : joins) {
    const std::uint32_t from = std::max(least[a], least[b]), to = std::min(least[a], least[b]);
    std::replace(least.begin(), least.end(), from, to);
  }
  return least;
}

Joins random_joins(std::size_t n, std::size_t count, Random& random) {
  Joins joins;
  for (std::size_t i = 0; i < count; ++i)
    joins.emplace_back(static_cast<std::uint32_t>(random.below(n)),
                       static_cast<std::uint32_t>(random.below(n)));
  return joins;
}

template <typename Sets>
std::vector<std::uint32_t> least_of_all(Sets& sets) {
  std::vector<std::uint32_t> least;
  for (std::uint32_t i = 0; i < sets.size(); ++i)
    least.push_back(static_cast<std::uint32_t>(sets.find(i)));
  return least;
}

TEST(DisjointSets, NameAClassByItsLeastElementAfterEachJoin) {
  Random random(1);
  for (const std::size_t n : {1u, 2u, 7u, 40u}) {
    DisjointSets sets(n);
    DisjointSets<std::size_t> wide(n);
    ConcurrentDisjointSets concurrent(n);
    concurrent.reset(0, n / 2);
    concurrent.reset(n / 2, n);
    const Joins joins = random_joins(n, 2 * n, random);
    Joins seen;
    EXPECT_EQ(least_of_all(sets), least_by_renaming(n, seen));
    for (const auto& [a, b] : joins) {
      sets.join(a, b);
      wide.join(a, b);
      concurrent.join(a, b);
      seen.emplace_back(a, b);
      const auto expected = least_by_renaming(n, seen);
      ASSERT_EQ(least_of_all(sets), expected) << n << " elements, " << seen.size() << " joins";
      ASSERT_EQ(least_of_all(wide), expected) << n << " elements, " << seen.size() << " joins";
      ASSERT_EQ(least_of_all(concurrent), expected)
          << n << " elements, " << seen.size() << " joins";
    }
  }
}

TEST(DisjointSets, ChainsInEitherOrderAreOneClass) {
  constexpr std::uint32_t kCount = 100'000;
  DisjointSets up(kCount), down(kCount);
  for (std::uint32_t i = 1; i < kCount; ++i) {
    up.join(i - 1, i);
    down.join(kCount - i, kCount - i - 1);
  }
  for (std::uint32_t i = 0; i < kCount; ++i) {
    ASSERT_EQ(up.find(i), 0u);
    ASSERT_EQ(down.find(i), 0u);
  }
}

TEST(DisjointSets, AnAddedElementIsAClassOfItsOwn) {
  DisjointSets sets;
  EXPECT_EQ(sets.size(), 0u);
  for (std::uint32_t i = 0; i < 4; ++i) {
    EXPECT_EQ(sets.add(), i);
    EXPECT_EQ(sets.find(i), i);
    if (i == 2) sets.join(2, 1);
  }
  EXPECT_EQ(least_of_all(sets), (std::vector<std::uint32_t>{0, 1, 1, 3}));
}

TEST(ConcurrentDisjointSets, ThreadsThatJoinAtOnceMakeTheSameClasses) {
  constexpr std::size_t kCount = 2'000, kThreads = 4;
  Random random(2);
  for (int round = 0; round < 20; ++round) {
    ConcurrentDisjointSets sets(kCount);
    sets.reset(0, kCount);
    const Joins joins = random_joins(kCount, kCount, random);
    std::vector<std::thread> threads;
    for (std::size_t t = 0; t < kThreads; ++t)
      threads.emplace_back([&, t] {
        for (std::size_t i = t; i < joins.size(); i += kThreads)
          sets.join(joins[i].first, joins[i].second);
      });
    for (std::thread& thread : threads) thread.join();
    ASSERT_EQ(least_of_all(sets), least_by_renaming(kCount, joins)) << "round " << round;
  }
}

}  // namespace
}  // namespace veritope
