// SPDX-License-Identifier: LGPL-3.0-or-later
#include "robust/base/memory_budget.h"

#include <gtest/gtest.h>

namespace veritope {
namespace {

TEST(MemoryBudget, GrantsExactlyItsLimitAndRemembersARefusal) {
  MemoryBudget budget(100);
  EXPECT_TRUE(budget.take(60));
  EXPECT_TRUE(budget.take(40));
  EXPECT_EQ(budget.room(), 0u);
  EXPECT_FALSE(budget.is_spent());
  EXPECT_FALSE(budget.take(1));
  EXPECT_TRUE(budget.is_spent());
  EXPECT_EQ(budget.used(), 100u);
  budget.give_back(60);
  EXPECT_TRUE(budget.is_spent());
  budget.forgive();
  EXPECT_TRUE(budget.take(60));
  EXPECT_FALSE(budget.is_spent());
  EXPECT_EQ(budget.most(), 100u);
}

TEST(MemoryBudget, CountsWhatMustBeTakenAsARefusalBeyondTheLimit) {
  MemoryBudget budget(100);
  budget.take_anyway(100);
  EXPECT_FALSE(budget.is_spent());
  budget.take_anyway(1);
  EXPECT_TRUE(budget.is_spent());
  EXPECT_EQ(budget.most(), 101u);
  EXPECT_EQ(budget.room(), 0u);
}

TEST(MemoryBudget, DoesNotWrapForTheGreatestRequests) {
  MemoryBudget budget(100);
  ASSERT_TRUE(budget.take(1));
  EXPECT_FALSE(budget.take(MemoryBudget::kUnlimited));
  EXPECT_EQ(budget.used(), 1u);
}

TEST(MemoryShare, GivesItsPartBackWithItsOwner) {
  MemoryBudget budget(100);
  {
    MemoryShare first(&budget), second(&budget);
    EXPECT_TRUE(first.resize(70));
    EXPECT_FALSE(second.resize(31));
    EXPECT_EQ(second.bytes(), 0u);
    EXPECT_TRUE(first.resize(50));
    EXPECT_TRUE(second.resize(50));
    const MemoryShare moved = std::move(first);
    EXPECT_EQ(moved.bytes(), 50u);
    second = MemoryShare(&budget);
    EXPECT_EQ(budget.used(), 50u);
  }
  EXPECT_EQ(budget.used(), 0u);
  EXPECT_EQ(budget.most(), 100u);
}

TEST(MemoryShare, OfNoBudgetGrowsWithoutLimit) {
  MemoryShare share;
  EXPECT_TRUE(share.resize(MemoryBudget::kUnlimited));
}

// The capacity is charged before it is there, and a vector that is refused keeps its elements where they are.
TEST(MakeRoom, ChargesCapacityAndLeavesARefusedVectorAsItIs) {
  MemoryBudget budget(64);
  MemoryShare share(&budget);
  std::vector<int> v;
  for (int i = 0; i < 8; ++i) {
    ASSERT_TRUE(make_room(v, 1, share, 8)) << i;
    EXPECT_GE(budget.used(), 8 * v.capacity());
    v.push_back(i);
  }
  const int* const data = v.data();
  EXPECT_FALSE(make_room(v, 1, share, 8));
  EXPECT_EQ(v.data(), data);
  EXPECT_EQ(budget.used(), 64u);
}

TEST(MemoryAllowed, IsWhatIsAskedForOrAPartOfTheMachine) {
  EXPECT_EQ(memory_allowed(5), 5u);
  EXPECT_GE(memory_allowed(std::nullopt), std::uint64_t{1} << 28);
}

}  // namespace
}  // namespace veritope
