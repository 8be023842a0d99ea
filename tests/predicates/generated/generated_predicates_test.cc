// SPDX-License-Identifier: LGPL-3.0-or-later
// Every generated predicate: its examples, its laws, its tiers against the formula over rationals.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <string>

#include "named_predicates/hard_points.h"
#include "tests/predicates/generated/subject.h"
#include "tests/predicates/test_scale.h"

namespace veritope::generated {
namespace {

constexpr std::uint64_t kSeed = 20;

std::string text(const Subject& subject, const Operands& v) {
  std::string all = std::string(subject.name) + ":";
  for (std::size_t i = 0; i < subject.axes.size(); ++i) {
    char number[40];
    std::snprintf(number, sizeof number, " %a", v[i]);
    all += number;
  }
  return all;
}

// Two points coincide every second time, the numbers are equal every fourth time: many zeros.
Operands random_operands(const Subject& subject, generate::Kind kind, Random& random) {
  generate::Points p = generate::points(kind, random);
  const generate::Points other = generate::points(kind, random);
  const std::uint64_t turn = random.below(4);
  if (turn < 2) p[random.below(3)] = p[random.below(3)];
  const bool squared = random.below(2) == 0;
  Operands v{};
  std::size_t point = 0, number = 0;
  for (std::size_t i = 0; i < subject.axes.size(); ++i) {
    const int axis = subject.axes[i];
    if (axis >= 0) {
      v[i] = p[point % 5][axis];
      point += i + 1 == subject.axes.size() || subject.axes[i + 1] <= axis ? 1 : 0;
    } else {
      const double w = other[turn == 2 ? 0 : number++ % 5].x;
      const double w2 = squared ? w * std::abs(w) : w;
      v[i] = std::isfinite(w2) ? w2 : w;
    }
  }
  return v;
}

template <typename Check>
void on_random_operands(long loops, Check check) {
  ASSERT_GE(subjects().size(), 10u);
  for (const Subject& subject : subjects()) {
    SCOPED_TRACE(subject.name);
    for (int kind = 0; kind < generate::kNumKinds; ++kind) {
      Random random(kSeed + static_cast<unsigned>(kind));
      for (long i = 0; i < scaled(loops); ++i) {
        const Operands v = random_operands(subject, static_cast<generate::Kind>(kind), random);
        check(subject, v, random);
        ASSERT_FALSE(testing::Test::HasFailure())
            << generate::kKindNames[kind] << ", seed " << kSeed + static_cast<unsigned>(kind)
            << ", case " << i << ": " << text(subject, v);
      }
    }
  }
}

TEST(GeneratedPredicates, HaveTheSignsOfTheirExamples) {
  for (const Subject& subject : subjects()) {
    EXPECT_GE(subject.examples.size(), 3u) << subject.name;
    for (const Example& example : subject.examples) {
      EXPECT_EQ(subject.decide(example.operands, nullptr), example.sign)
          << text(subject, example.operands);
      EXPECT_EQ(subject.by_formula(example.operands), example.sign)
          << text(subject, example.operands);
    }
  }
}

TEST(GeneratedPredicates, NoTierContradictsTheFormulaOverRationals) {
  std::array<long, 3> signs{};
  on_random_operands(60, [&](const Subject& subject, const Operands& v, Random&) {
    const Sign s = subject.by_formula(v);
    ++signs[static_cast<std::size_t>(to_int(s) + 1)];
    const auto agrees = [&](Sign3 tier) { return !is_certain(tier) || to_sign(tier) == s; };
    EXPECT_EQ(subject.decide(v, nullptr), s);
    EXPECT_TRUE(agrees(subject.filter(v)));
    EXPECT_TRUE(agrees(subject.lattice(v)));
    EXPECT_TRUE(agrees(subject.interval(v)));
    EXPECT_EQ(subject.exact(v), s);
  });
  for (const long count : signs) EXPECT_GT(count, (signs[0] + signs[1] + signs[2]) / 8);
}

TEST(GeneratedPredicates, EveryTierDecidesSomethingAndEachCaseIsCountedOnce) {
  for (const Subject& subject : subjects()) {
    TierCounts tally;
    std::uint64_t cases = 0;
    for (int kind = 0; kind < generate::kNumKinds; ++kind) {
      Random random(kSeed);
      for (int i = 0; i < 200; ++i, ++cases) {
        subject.decide(random_operands(subject, static_cast<generate::Kind>(kind), random), &tally);
      }
    }
    std::uint64_t decided = 0;
    for (std::size_t tier = 0; tier < kNumTiers; ++tier) {
      decided += tally.decided[tier];
      const bool exists = subject.has_lattice || tier != static_cast<std::size_t>(Tier::kLattice);
      EXPECT_EQ(tally.decided[tier] > 0, exists) << subject.name << ", tier " << tier;
    }
    EXPECT_EQ(decided, cases) << subject.name;
  }
}

TEST(GeneratedPredicatesLaw, ExchangedArgumentsTurnOrKeepTheSign) {
  long checked = 0;
  on_random_operands(30, [&](const Subject& subject, const Operands& v, Random&) {
    for (const Law& law : subject.laws) {
      if (law.order.empty()) continue;
      Operands w{};
      for (std::size_t i = 0; i < law.order.size(); ++i) w[i] = v[law.order[i]];
      EXPECT_EQ(to_int(subject.decide(w, nullptr)),
                law.factor * to_int(subject.decide(v, nullptr)));
      ++checked;
    }
  });
  EXPECT_GT(checked, 0);
}

// Integers of at most 45 bits, moved by integers of at most 45 bits: exactly.
TEST(GeneratedPredicatesLaw, ATranslationKeepsTheSign) {
  long checked = 0;
  on_random_operands(30, [&](const Subject& subject, const Operands& v, Random& random) {
    Operands at{};
    for (std::size_t i = 0; i < subject.axes.size(); ++i) {
      at[i] = std::isfinite(v[i]) && std::abs(v[i]) < 0x1p45 ? std::trunc(v[i]) : 0;
    }
    const int bits = static_cast<int>(random.below(45));
    std::array<double, 3> shift;
    for (double& s : shift) {
      s = static_cast<double>(random.between(-(std::int64_t{1} << bits), std::int64_t{1} << bits));
    }
    for (const Law& law : subject.laws) {
      if (law.axes.empty()) continue;
      Operands w = at;
      for (std::size_t i = 0; i < law.axes.size(); ++i) {
        if (law.axes[i] >= 0) w[i] += shift[static_cast<std::size_t>(law.axes[i])];
      }
      EXPECT_EQ(subject.decide(w, nullptr), subject.decide(at, nullptr)) << text(subject, w);
      ++checked;
    }
  });
  EXPECT_GT(checked, 0);
}

TEST(GeneratedPredicatesLaw, ScalingByAPowerOfTwoKeepsTheSign) {
  long checked = 0;
  on_random_operands(30, [&](const Subject& subject, const Operands& v, Random& random) {
    const int exponent = static_cast<int>(random.between(-900, 900));
    if (!subject.has_lattice) return;
    Operands w{};
    for (std::size_t i = 0; i < subject.axes.size(); ++i) {
      w[i] = std::ldexp(v[i], exponent * subject.powers[i]);
      if (std::ldexp(w[i], -exponent * subject.powers[i]) != v[i]) return;  // not exact
    }
    EXPECT_EQ(subject.decide(w, nullptr), subject.decide(v, nullptr)) << text(subject, w);
    ++checked;
  });
  EXPECT_GT(checked, 1000);
}

}  // namespace
}  // namespace veritope::generated
