// SPDX-License-Identifier: LGPL-3.0-or-later
// veritope selftest.
#include <algorithm>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "cli/commands.h"
#include "named_predicates/hard_cases.h"
#include "named_predicates/named_predicate.h"
#include "report/text_style.h"
#include "robust/base/fp_guard.h"

namespace veritope::cli {

using namespace report;
namespace {

constexpr std::uint64_t kMostShown = 20;
constexpr std::size_t kNameWidth = 25;

struct Tally {
  std::uint64_t num_cases = 0, num_zeros = 0, num_disagreements = 0;
  TierCounts tiers;
};

class SelfTest {
 public:
  explicit SelfTest(StandardOutput& out) : out_(out) {}

  void run_case(const HardCase& hard_case, Tally& tally) {
    const NamedPredicate& predicate = *hard_case.predicate;
    const Sign found = predicate.decide(hard_case.operands, &tally.tiers);
    const Sign exact = predicate.decide_by_formula(hard_case.operands);
    ++tally.num_cases;
    tally.num_zeros += exact == Sign::kZero ? 1 : 0;
    if (found == exact) return;
    ++tally.num_disagreements;
    if (num_shown_++ >= kMostShown) return;
    out_.write(std::string(predicate.name) + ": expected " + std::to_string(to_int(exact)) +
               ", found " + std::to_string(to_int(found)) + ":" + operands_text(hard_case) + "\n");
  }

 private:
  StandardOutput& out_;
  std::uint64_t num_shown_ = 0;
};

std::string summary(const NamedPredicate& predicate, const Tally& tally) {
  std::string name(predicate.name);
  name.resize(std::max<std::size_t>(name.size(), kNameWidth), ' ');
  return name + "  " + std::to_string(tally.num_cases) + " cases, " +
         std::to_string(tally.num_zeros) + " exact zeros, " +
         std::to_string(tally.num_disagreements) + " disagreements; decided by " +
         tiers_text(tally.tiers) + "\n";
}

struct SelfTestOptions {
  HardCaseOptions cases;
  bool verbose = false;
};

ExitCode run_selftest(const SelfTestOptions& o, StandardOutput& out) {
  const HardCaseOptions& options = o.cases;
  const Status environment = check_fp();
  if (!environment)
    out.write(environment.error().message + "; integers decide\n");
  else if (o.verbose)
    out.write("floating point is as the filters need it\n");
  HardCases cases = options.cases();
  const std::size_t num_tested = cases.predicates().size();
  std::vector<Tally> tallies(num_tested);
  SelfTest test(out);
  for (std::uint64_t i = 0; i < options.num_cases; ++i)
    test.run_case(cases.next(), tallies[i % num_tested]);
  std::uint64_t num_disagreements = 0;
  for (std::size_t i = 0; i < num_tested; ++i) {
    num_disagreements += tallies[i].num_disagreements;
    if (o.verbose) out.write(fold(summary(*cases.predicates()[i], tallies[i]), verdict_width()));
  }
  out.write(std::to_string(options.num_cases) + " cases, " + std::to_string(num_disagreements) +
            " disagreements; seed " + std::to_string(options.seed) + "\n");
  return num_disagreements == 0 ? kExitValid : kExitBug;
}

}  // namespace

RunCommand declare_selftest(OptionSet& set) {
  const auto o = std::make_shared<SelfTestOptions>();
  declare_hard_cases(set, o->cases);
  set.flag("--verbose", o->verbose, "say for each predicate which tiers decided");
  return [o](StandardOutput& out) { return run_selftest(*o, out); };
}

}  // namespace veritope::cli
