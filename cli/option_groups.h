// SPDX-License-Identifier: LGPL-3.0-or-later
// cli/option_groups.h: options that several commands share. A command declares its options in the order of its help.
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "cli/option_set.h"
#include "io/model_file.h"
#include "named_predicates/hard_cases.h"
#include "report/exit_code.h"

namespace veritope::cli {

using namespace report;

/// The number of threads of this machine, at most what --jobs accepts.
int default_jobs();

/// Files of models, and how they are read.
struct InputOptions {
  InputOptions() { reading.jobs = default_jobs(); }

  std::vector<std::string> files;
  ModelReadOptions reading;
};

/// One or more files.
void declare_files(OptionSet& set, InputOptions& input, const std::string& help);
/// Exactly one file.
void declare_file(OptionSet& set, const std::string& name, InputOptions& input,
                  const std::string& help);
/// --format, and the rules that connect it with the files.
void declare_format(OptionSet& set, InputOptions& input);
/// --as-indexed and the limits.
void declare_reading(OptionSet& set, ModelReadOptions& reading);
/// -j,--jobs
void declare_jobs(OptionSet& set, int& jobs);
void declare_jobs(OptionSet& set, std::optional<int>& jobs);  ///< nothing: not given

/// --json. `what` begins the help: "write the report".
void declare_json(OptionSet& set, std::optional<std::string>& json, const std::string& what);
/// --orient; `is_auto` becomes true if what does not fit is to be reversed.
void declare_orientation(OptionSet& set, bool& is_auto, const std::string& what_is_reversed);

/// Bounds on what a search may take; nothing: its own.
struct LimitOptions {
  std::optional<std::uint64_t> max_cells, max_mebibytes;
  std::optional<std::uint64_t> max_memory() const;  ///< in bytes
};
/// --max-cells, --max-memory
void declare_limits(OptionSet& set, LimitOptions& limits);

/// One file that is not a model.
void declare_plain_file(OptionSet& set, const std::string& name, std::string& file,
                        const std::string& help);

/// Generated cases with hard signs.
struct HardCaseOptions {
  std::uint64_t num_cases = 100000;
  std::uint64_t seed = 1;
  /// These predicates only, each once, in the order of hard_case_predicates(); empty: all.
  std::vector<const NamedPredicate*> only;

  HardCases cases() const;
};
/// --cases, --seed, --only
void declare_hard_cases(OptionSet& set, HardCaseOptions& cases);

}  // namespace veritope::cli
