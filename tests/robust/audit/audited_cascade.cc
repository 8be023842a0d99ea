// SPDX-License-Identifier: LGPL-3.0-or-later
// tests/robust/audit/audited_cascade.cc: compiled with VT_AUDIT. A tier that lies is caught, wherever
// it stands; tiers that agree are asked once each and counted as without the audit.
#include <gtest/gtest.h>

#include "robust/base/check.h"
#include "robust/cascade.h"

namespace veritope {
namespace {

static_assert(kCascadesAreAudited);

constexpr Sign3 kPlus = Sign3::kPositive, kMinus = Sign3::kNegative, kUnsure = Sign3::kUncertain;

// A predicate as ours are: the filter, then the rest as a cascade of its own.
Sign predicate(Sign3 filter, Sign3 lattice, Sign3 interval, Sign exact, TierCounts* tally) {
  return cascade(
      tally, [&] { return filter; },
      [&](TierCounts* t) {
        return cascade<1>(
            t, [&] { return lattice; }, [&] { return interval; }, [&] { return exact; });
      });
}

std::string complaint(Sign3 filter, Sign3 lattice, Sign3 interval, Sign exact) {
  try {
    predicate(filter, lattice, interval, exact, nullptr);
  } catch (const InternalError& error) {
    return error.what();
  }
  return "none";
}

std::string contradiction(const std::string& pair) {
  return "audit: two tiers of a cascade contradict each other, please report: " + pair;
}

TEST(AuditedCascade, CatchesATierThatLiesAndNamesTheTwo) {
  constexpr Sign kExactPlus = Sign::kPositive;
  EXPECT_EQ(complaint(kMinus, kPlus, kPlus, kExactPlus),
            contradiction("filter says -1, lattice says 1"));
  EXPECT_EQ(complaint(kMinus, kUnsure, kUnsure, kExactPlus),
            contradiction("filter says -1, exact says 1"));
  EXPECT_EQ(complaint(kPlus, Sign3::kZero, kPlus, kExactPlus),
            contradiction("lattice says 0, interval says 1"));
  EXPECT_EQ(complaint(kUnsure, kUnsure, kMinus, kExactPlus),
            contradiction("interval says -1, exact says 1"));
  EXPECT_EQ(complaint(kPlus, kPlus, kPlus, Sign::kZero),
            contradiction("interval says 1, exact says 0"));
}

TEST(AuditedCascade, AcceptsTiersThatAgreeAndCountsTheFirstAlone) {
  for (const Sign exact : {Sign::kNegative, Sign::kZero, Sign::kPositive}) {
    for (int certain = 0; certain < 8; ++certain) {
      const auto tier = [&](int bit) {
        return (certain & bit) != 0 ? to_sign3(exact) : Sign3::kUncertain;
      };
      TierCounts tally, expected;
      EXPECT_EQ(predicate(tier(1), tier(2), tier(4), exact, &tally), exact);
      const std::size_t first = (certain & 1) != 0   ? 0
                                : (certain & 2) != 0 ? 1
                                : certain != 0       ? 2
                                                     : 3;
      expected.decided[first] = 1;
      EXPECT_EQ(tally, expected) << "certain tiers, as bits: " << certain;
      EXPECT_EQ(predicate(tier(1), tier(2), tier(4), exact, nullptr), exact);
    }
  }
}

TEST(AuditedCascade, AsksEachTierOnce) {
  std::array<int, kNumTiers> asked{};
  const auto tier = [&](std::size_t i, auto answer) {
    return [&asked, i, answer] { return ++asked[i], answer; };
  };
  EXPECT_EQ(
      cascade(nullptr, tier(0, kPlus), tier(1, kUnsure), tier(2, kPlus), tier(3, Sign::kPositive)),
      Sign::kPositive);
  EXPECT_EQ(asked, (std::array<int, kNumTiers>{1, 1, 1, 1}));
}

TEST(AuditedCascade, ALieInAFunctionThatMayNotThrowEndsTheProgramWithTheMessage) {
  const auto quiet = []() noexcept {
    return predicate(Sign3::kPositive, kUnsure, kUnsure, Sign::kNegative, nullptr);
  };
  EXPECT_DEATH(quiet(), "please report: filter says 1, exact says -1");
}

TEST(AuditedCascade, IsUsableAtCompileTime) {
  static_assert(cascade(
                    nullptr, [] { return Sign3::kNegative; }, [] { return Sign::kNegative; }) ==
                Sign::kNegative);
}

}  // namespace
}  // namespace veritope
