// SPDX-License-Identifier: LGPL-3.0-or-later
// veritope corpus.
#include <algorithm>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "cli/commands.h"
#include "cli/new_folder.h"
#include "hard_models/corpus_files.h"
#include "named_predicates/hard_cases.h"
#include "report/text_style.h"

namespace veritope::cli {

namespace {

using hard_models::CorpusFolder;

struct CorpusOptions {
  HardCaseOptions cases;
  std::optional<std::string> meshes, patches;  ///< folders
};

ExitCode print_cases(const HardCaseOptions& options, StandardOutput& out) {
  constexpr std::size_t kFull = std::size_t{1} << 16;
  std::string text = "# veritope corpus --cases " + std::to_string(options.num_cases) + " --seed " +
                     std::to_string(options.seed);
  for (const NamedPredicate* predicate : options.only)
    text += (predicate == options.only.front() ? " --only " : ",") + std::string(predicate->name);
  text += "\n# predicate, operands, exact sign\n";
  HardCases cases = options.cases();
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

Status write_models(const std::string& path, CorpusFolder folder, StandardOutput& out) {
  std::vector<NamedBytes> files;
  for (hard_models::CorpusFile& file : folder.files)
    files.push_back({std::move(file.name), std::move(file.bytes)});
  if (Status status = write_folder(path, files); !status) return status;
  out.write("wrote  " + report::harmless(path) + "  " +
            std::to_string(folder.num_valid + folder.num_invalid) +
            " models: " + std::to_string(folder.num_valid) + " valid, " +
            std::to_string(folder.num_invalid) + " invalid; index.tsv says which\n");
  return ok_status();
}

// Both folders are tested before any work begins.
Status write_folders(const CorpusOptions& options, StandardOutput& out) {
  for (const auto& path : {options.meshes, options.patches})
    if (path)
      if (Status status = try_folder(*path); !status) return status;
  if (options.meshes && options.patches && same_folder(*options.meshes, *options.patches))
    return bad_argument("--meshes and --patches name the same folder");
  const std::uint64_t seed = options.cases.seed;
  if (options.meshes)
    if (Status status = write_models(*options.meshes, hard_models::mesh_corpus(seed), out); !status)
      return status;
  if (options.patches) return write_models(*options.patches, hard_models::patch_corpus(seed), out);
  return ok_status();
}

ExitCode run_corpus(const CorpusOptions& options, StandardOutput& out) {
  if (!options.meshes && !options.patches) return print_cases(options.cases, out);
  const Status status = write_folders(options, out);
  return status ? kExitValid : fail(status.error());
}

}  // namespace

RunCommand declare_corpus(OptionSet& set) {
  const auto o = std::make_shared<CorpusOptions>();
  declare_hard_cases(set, o->cases);
  set.text("--meshes", o->meshes, "write hard meshes into the new folder DIR instead", "DIR");
  set.text("--patches", o->patches, "write hard spline models into the new folder DIR", "DIR");
  for (const char* folder : {"--meshes", "--patches"})
    for (const char* option : {"--cases", "--only"}) set.excludes(folder, option);
  return [o](StandardOutput& out) { return run_corpus(*o, out); };
}

}  // namespace veritope::cli
