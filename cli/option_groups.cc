// SPDX-License-Identifier: LGPL-3.0-or-later
#include "cli/option_groups.h"

#include <algorithm>

#include "cli/did_you_mean.h"
#include "io/formats.h"
#include "robust/base/parallel.h"

namespace veritope::cli {
namespace {

constexpr unsigned kMostJobs = 1024;
constexpr char kJobsHelp[] = "threads (default: all of the machine)";
constexpr std::uint64_t kMostMebibytes = std::uint64_t{1} << 40;
constexpr std::uint64_t kMostFaces = (std::uint64_t{1} << 30) - 1;  // the limit of decide_validity

std::string wrong_files(const InputOptions& input) {
  const auto& files = input.files;
  const auto inputs = std::count(files.begin(), files.end(), "-");
  if (inputs > 0 && !input.reading.format) return "- is standard input and needs --format";
  if (inputs > 1) return "standard input can be read once only";
  if (std::find(files.begin(), files.end(), "") != files.end())
    return "a file name must not be empty";
  return "";
}

// The predicates of a list "a,b", in the order of all; or what is wrong with the list.
std::string take_predicates(const std::string& list, std::vector<const NamedPredicate*>& chosen) {
  const std::vector<const NamedPredicate*> all = hard_case_predicates();
  std::vector<std::string> known;
  for (const NamedPredicate* p : all) known.emplace_back(p->name);
  std::vector<bool> is_chosen(all.size(), false);
  for (std::size_t at = 0; at <= list.size();) {
    const std::size_t end = std::min(list.find(',', at), list.size());
    const std::string name = list.substr(at, end - at);
    const auto place = std::find(known.begin(), known.end(), name);
    if (place == known.end()) {
      return "must be names of predicates with commas between them, not " +
             (name.empty() ? "an empty name" : name) + did_you_mean(name, known);
    }
    is_chosen[static_cast<std::size_t>(place - known.begin())] = true;
    at = end + 1;
  }
  chosen.clear();
  for (std::size_t i = 0; i < all.size(); ++i)
    if (is_chosen[i]) chosen.push_back(all[i]);
  return "";
}

}  // namespace

int default_jobs() { return static_cast<int>(std::clamp(hardware_jobs(), 1u, kMostJobs)); }

void declare_files(OptionSet& set, InputOptions& input, const std::string& help) {
  set.operands("FILE", input.files, help);
}

void declare_file(OptionSet& set, const std::string& name, InputOptions& input,
                  const std::string& help) {
  const auto take = [&input](const std::string& path) -> std::string {
    input.files = {path};
    return "";
  };
  set.operand(name, take, help);
}

void declare_format(OptionSet& set, InputOptions& input) {
  const auto take = [&input](const std::string& name) -> std::string {
    const ModelFormat* const row = format_from_name(name);
    if (row == nullptr) {
      std::vector<std::string> names;
      for (const ModelFormat& known : model_formats()) names.emplace_back(known.name);
      return "must be " + format_names("or") + ", not " + name + did_you_mean(name, names);
    }
    input.reading.format = row->id;
    return "";
  };
  std::string names;  // with blanks only, so that they fit a line
  for (const ModelFormat& known : model_formats())
    names += (names.empty() ? "" : " ") + std::string(known.name);
  set.option("--format", "F", take, names);
  set.rule([&input] { return wrong_files(input); });
}

void declare_reading(OptionSet& set, ModelReadOptions& reading) {
  set.flag("--as-indexed", reading.as_indexed, "keep the file's vertex indices, merge none");
  ReadLimits& limits = reading.limits;
  set.number("--max-bytes", limits.max_bytes, {0, kMost64},
             "limit: bytes; --max-faces, --max-digits, --max-exponent N");
  set.number("--max-faces", limits.max_faces, {0, kMostFaces}, "limit: triangles (200000000)");
  set.hide("--max-faces");  // the help line above names it and the next two
  set.number("--max-digits", limits.max_digits, {1, kMost32}, "limit: digits of a number (1000)");
  set.hide("--max-digits");
  set.number("--max-exponent", limits.max_exponent, {0, kMost32},
             "limit: exponent of a number (4096)");
  set.hide("--max-exponent");
}

void declare_jobs(OptionSet& set, int& jobs) {
  set.number("-j,--jobs", jobs, {1, kMostJobs}, kJobsHelp);
}

void declare_jobs(OptionSet& set, std::optional<int>& jobs) {
  set.number("-j,--jobs", jobs, {1, kMostJobs}, kJobsHelp);
}

void declare_json(OptionSet& set, std::optional<std::string>& json, const std::string& what) {
  set.output("--json", json, what + " as JSON; - is standard output");
}

void declare_orientation(OptionSet& set, bool& is_auto, const std::string& what_is_reversed) {
  const auto take = [&is_auto](const std::string& how) -> std::string {
    if (how != "auto" && how != "keep")
      return "must be auto or keep, not " + how + did_you_mean(how, {"auto", "keep"});
    is_auto = how == "auto";
    return "";
  };
  set.option("--orient", "HOW", take,
             "auto: reverse " + what_is_reversed + " that do not fit; keep: none");
}

std::optional<std::uint64_t> LimitOptions::max_memory() const {
  if (!max_mebibytes) return std::nullopt;
  return *max_mebibytes << 20;
}

void declare_limits(OptionSet& set, LimitOptions& limits) {
  set.number("--max-memory", limits.max_mebibytes, {1, kMostMebibytes},
             "limit: MiB (half of the machine's); --max-cells N: cells");
  set.number("--max-cells", limits.max_cells, {1, kMost32},
             "limit: boxes tried (4000000), octree cells (2097152)");
  set.hide("--max-cells");  // the help line above names it
}

void declare_plain_file(OptionSet& set, const std::string& name, std::string& file,
                        const std::string& help) {
  set.operand(name, any_text(file), help);
  set.rule(
      [&file]() -> std::string { return file.empty() ? "a file name must not be empty" : ""; });
}

void declare_hard_cases(OptionSet& set, HardCaseOptions& cases) {
  set.number("--cases", cases.num_cases, {1, kMost64}, "cases in all (100000)");
  set.number("--seed", cases.seed, {0, kMost64}, "other cases (1)");
  const auto take = [&cases](const std::string& list) { return take_predicates(list, cases.only); };
  set.option("--only", "NAME,...", take, "cases of these predicates only");
}

HardCases HardCaseOptions::cases() const {
  return only.empty() ? HardCases(seed) : HardCases(seed, only);
}

}  // namespace veritope::cli
