// SPDX-License-Identifier: LGPL-3.0-or-later
// veritope corpus.
#include <memory>
#include <string>

#include "cli/commands.h"
#include "named_predicates/hard_cases.h"

namespace veritope::cli {

namespace {

ExitCode run_corpus(const HardCaseOptions& options, StandardOutput& out) {
  constexpr std::size_t kFull = std::size_t{1} << 16;
  std::string text = "# veritope corpus --cases " + std::to_string(options.num_cases) + " --seed " +
                     std::to_string(options.seed) +
                     "\n# predicate, operands, exact sign\n";
  HardCases cases(options.seed);
  for (std::uint64_t i = 0; i < options.num_cases; ++i) {
    const HardCase c = cases.next();
    text += std::string(c.predicate->name) + operands_text(c) + " " +
            std::to_string(to_int(c.predicate->decide_by_formula(c.operands))) + "\n";
    if (text.size() < kFull) continue;
    out.write(text);
    text.clear();
  }
  out.write(text);
  return kExitValid;
}

}  // namespace

RunCommand declare_corpus(OptionSet& set) {
  const auto o = std::make_shared<HardCaseOptions>();
  declare_hard_cases(set, *o);
  return [o](StandardOutput& out) { return run_corpus(*o, out); };
}

}  // namespace veritope::cli
