// SPDX-License-Identifier: LGPL-3.0-or-later
// veritope selftest.
#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <string>

#include "cli/commands.h"
#include "cli/hard_points.h"
#include "cli/named_predicate.h"
#include "robust/base/fp_guard.h"

namespace veritope::cli {
namespace {

constexpr std::size_t kNumTested = 4;  ///< of named_predicates(): those on points alone
constexpr std::uint64_t kMostShown = 20;

struct Tally {
  std::uint64_t num_cases = 0, num_zeros = 0, num_disagreements = 0;
  TierCounts tiers;
};

// Half of the cases from the kinds that are made to be exactly zero, the others from all kinds.
generate::Kind random_kind(const NamedPredicate& predicate, Random& random) {
  using generate::Kind;
  if (random.below(2) == 0) return static_cast<Kind>(random.below(generate::kNumKinds));
  const bool is_scaled = random.below(2) == 0;
  if (predicate.name.starts_with("orient")) return is_scaled ? Kind::kScaledFlat : Kind::kFlat;
  return is_scaled ? Kind::kScaledRound : Kind::kRound;
}

Operands random_operands(const NamedPredicate& predicate, Random& random) {
  Operands operands{};
  double* next = operands.data();
  for (const Vec3d& p : generate::points(random_kind(predicate, random), random)) {
    for (int axis = 0; axis < predicate.dimension; ++axis) *next++ = p[axis];
  }
  return operands;
}

// A line that veritope predicate reads.
std::string operands_text(const Operands& operands, std::size_t count) {
  std::string text;
  for (std::size_t i = 0; i < count; ++i) {
    char number[32];
    std::snprintf(number, sizeof number, " %a", operands[i]);
    text += number;
  }
  return text;
}

class SelfTest {
 public:
  SelfTest(std::uint64_t seed, StandardOutput& out) : random_(seed), out_(out) {}

  void run_case(const NamedPredicate& predicate, Tally& tally) {
    const Operands operands = random_operands(predicate, random_);
    const Sign found = predicate.decide(operands, &tally.tiers);
    const Sign exact = predicate.decide_by_formula(operands);
    ++tally.num_cases;
    tally.num_zeros += exact == Sign::kZero ? 1 : 0;
    if (found == exact) return;
    ++tally.num_disagreements;
    if (num_shown_++ >= kMostShown) return;
    out_.write(std::string(predicate.name) + ": expected " + std::to_string(to_int(exact)) +
               ", found " + std::to_string(to_int(found)) + ":" +
               operands_text(operands, predicate.num_operands) + "\n");
  }

 private:
  Random random_;
  StandardOutput& out_;
  std::uint64_t num_shown_ = 0;
};

std::string summary(const NamedPredicate& predicate, const Tally& tally) {
  std::string name(predicate.name);
  name.resize(std::max<std::size_t>(name.size(), 9), ' ');
  return name + "  " + std::to_string(tally.num_cases) + " cases, " +
         std::to_string(tally.num_zeros) + " exact zeros, " +
         std::to_string(tally.num_disagreements) + " disagreements; decided by " +
         tiers_text(tally.tiers) + "\n";
}

}  // namespace

ExitCode run_selftest(const Options& options, StandardOutput& out) {
  const Status environment = check_fp();
  out.write(environment ? "floating point is as the filters need it\n"
                        : environment.error().message + "; integers decide\n");
  std::array<Tally, kNumTested> tallies;
  SelfTest test(options.seed, out);
  for (std::uint64_t i = 0; i < options.num_cases; ++i) {
    test.run_case(named_predicates()[i % kNumTested], tallies[i % kNumTested]);
  }
  std::uint64_t num_disagreements = 0;
  for (std::size_t i = 0; i < kNumTested; ++i) {
    num_disagreements += tallies[i].num_disagreements;
    out.write(summary(named_predicates()[i], tallies[i]));
  }
  out.write(std::to_string(options.num_cases) + " cases, " + std::to_string(num_disagreements) +
            " disagreements; seed " + std::to_string(options.seed) + "\n");
  return num_disagreements == 0 ? kExitValid : kExitBug;
}

}  // namespace veritope::cli
