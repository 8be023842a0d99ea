// SPDX-License-Identifier: LGPL-3.0-or-later
// veritope predicate.
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <system_error>

#include "cli/commands.h"
#include "cli/did_you_mean.h"
#include "cli/line_reader.h"
#include "named_predicates/case_reader.h"
#include "named_predicates/named_predicate.h"
#include "report/text_style.h"

namespace veritope::cli {

using namespace report;
namespace {

struct PredicateOptions {
  const NamedPredicate* predicate = nullptr;  ///< null: each line names its own
  std::string file;
  bool expect = false, tiers = false;
};

void declare(OptionSet& set, PredicateOptions& o) {
  const auto take_name = [&o](const std::string& name) -> std::string {
    o.predicate = predicate_from_name(name);
    if (o.predicate != nullptr || name == "any") return "";
    if (name.empty()) return "must not be empty";
    std::error_code none;
    if (std::filesystem::exists(name, none))
      return "comes before FILE; " + name + " is a file: veritope predicate NAME " + name;
    if (const auto meant = nearest_name(name, names_of_list(predicate_names())))
      return "there is no predicate " + name + "; did you mean " + *meant + "?";
    return "there is no predicate " + name + "; veritope selftest --verbose lists all";
  };
  set.operand(
      "NAME", take_name,
      "orient2d, orient3d, in_circle, in_sphere,\nside_of_plane, compare_along, on implicit "
      "points:\norient3d_lpi, ...; any: each line names its own");
  declare_plain_file(
      set, "FILE", o.file,
      "one case a line: the coordinates as decimals or\nas 0x1.8p-3; # comments; - is "
      "standard input");
  set.flag("--expect", o.expect,
           "the last column is the sign that is expected:\nreport disagreements");
  set.flag("--tiers", o.tiers, "say on standard error which tiers decided");
}

class CaseRun {
 public:
  CaseRun(const PredicateOptions& options, StandardOutput& out)
      : has_expected_(options.expect),
        name_(options.file == "-" ? "standard input" : harmless(options.file)),
        cases_(options.predicate, options.expect),
        out_(out) {}

  /// Decides up to the end of the file, or to the first line that cannot be read. Answers before that line are printed.
  Status decide_all(LineReader& lines) {
    Status status = decide_lines(lines);
    flush();
    return status;
  }

  ExitCode summarise() {
    if (!has_expected_) return kExitValid;
    out_.write(std::to_string(num_cases_) + " cases, " + std::to_string(num_disagreements_) +
               " disagreements\n");
    return num_disagreements_ == 0 ? kExitValid : kExitInvalid;
  }

  const TierCounts& tiers() const { return tiers_; }

 private:
  static constexpr std::size_t kFull = std::size_t{1} << 16;

  Status decide_lines(LineReader& lines) {
    for (;;) {
      // A program that writes the cases one by one may wait for an answer before it writes the
      // next.
      if (pending_.size() >= kFull || lines.must_read()) flush();
      const Result<std::optional<std::string_view>> line = lines.next();
      if (!line) return line.error();
      if (!line->has_value()) return ok_status();
      const Result<std::optional<PredicateCase>> found = cases_.read(**line);
      if (!found) return at_line(lines.line(), found.error());
      if (found->has_value()) decide(**found, lines.line());
    }
  }

  void decide(const PredicateCase& c, std::uint64_t line) {
    const Sign sign = c.predicate->decide(c.operands, &tiers_);
    ++num_cases_;
    const std::string answer = std::to_string(to_int(sign));
    if (!has_expected_) {
      pending_ += answer + "\n";
    } else if (sign != c.expected) {
      ++num_disagreements_;
      pending_ += name_ + ":" + std::to_string(line) + ": expected " +
                  std::to_string(to_int(c.expected)) + ", found " + answer + "\n";
    }
  }

  Error at_line(std::uint64_t line, Error error) const {
    error.place.file = name_;
    error.place.line = line;
    return error;
  }

  void flush() {
    out_.write(pending_);
    pending_.clear();
  }

  bool has_expected_;
  std::string name_;
  CaseReader cases_;
  StandardOutput& out_;
  std::string pending_;
  TierCounts tiers_;
  std::uint64_t num_cases_ = 0, num_disagreements_ = 0;
};

// FILE:LINE: as compilers print it, so that programs can go there.
std::string placed_text(const Error& error) {
  if (!error.place.line) return to_string(error);
  return error.place.file + ":" + std::to_string(*error.place.line) + ": " + error.message;
}

ExitCode fail_at_line(const Error& error) {
  complain(harmless(placed_text(error)));
  return kExitUnreadable;
}

ExitCode run(const PredicateOptions& options, StandardOutput& out) {
  Result<LineReader> lines = LineReader::open(options.file);
  if (!lines) return fail_at_line(lines.error());
  CaseRun cases(options, out);
  if (const Status status = cases.decide_all(*lines); !status) return fail_at_line(status.error());
  if (options.tiers) complain("decided by " + tiers_text(cases.tiers()));
  return cases.summarise();
}

}  // namespace

RunCommand declare_predicate(OptionSet& set) {
  const auto o = std::make_shared<PredicateOptions>();
  declare(set, *o);
  return [o](StandardOutput& out) { return run(*o, out); };
}

}  // namespace veritope::cli
