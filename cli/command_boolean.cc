// SPDX-License-Identifier: LGPL-3.0-or-later
// veritope boolean.
#include <algorithm>
#include <array>
#include <filesystem>
#include <map>
#include <memory>
#include <system_error>
#include <utility>

#include "cli/box_option.h"
#include "cli/checker_process.h"
#include "cli/commands.h"
#include "cli/expression_operands.h"
#include "cli/output_plan.h"
#include "io/splines/spline_text_reader.h"
#include "report/boolean_report.h"
#include "report/decimal_text.h"
#include "report/text_style.h"
#include "robust/base/stopwatch.h"
#include "verify/certify/certify.h"
#include "verify/format/sha256.h"

namespace veritope::cli {
namespace {

struct BooleanOptions {
  InputOptions input;
  std::vector<std::string> words;  // EXPR, NAME=FILE...
  std::optional<std::string> output, json;
  std::optional<ExactBox<3>> box;
  bool no_check = false;
  int jobs = default_jobs();
};

void declare(OptionSet& set, BooleanOptions& o) {
  set.operands("EXPR [NAME=FILE]", o.words,
               "names and \"files\" with ! & + | - ( ), and the file of\neach name");
  set.output("-o,--output", o.output, "write the expression: a chain file, .json");
  set.option(
      "--box", "BOX", [&o](const std::string& t) { return take_box(t, o.box); },
      "X0,Y0,Z0,X1,Y1,Z1: !A is this box without A (the\noperands' box, three times as large)");
  declare_json(set, o.json, "write what was read");
  declare_jobs(set, o.jobs);
  set.flag("--no-check", o.no_check, "do not run veritope-check");
  declare_reading(set, o.input.reading);
}

bool ends_in_json(const std::string& path) { return path.ends_with(".json"); }

std::string contradiction(const BooleanOptions& o) {
  if (!o.output) return "-o OUT.json is required, the file of the expression";
  if (!ends_in_json(*o.output)) return "the name " + *o.output + " does not end in .json";
  return "";
}

// The file of each operand, in the order of the expression.
Result<std::vector<std::string>> files_of(const ExpressionText& expression,
                                          const std::vector<std::string>& words) {
  std::map<std::string, std::pair<std::string, bool>> files;  // by name; whether it is used
  for (std::size_t i = 1; i < words.size(); ++i) {
    const std::size_t at = words[i].find('=');
    const std::string name = words[i].substr(0, at);
    if (at == words[i].npos || at + 1 == words[i].size() || !is_operand_name(name))
      return bad_argument("write NAME=FILE, not " + words[i]);
    if (!files.emplace(name, std::pair(words[i].substr(at + 1), false)).second)
      return bad_argument("the name " + name + " has two files");
  }
  std::vector<std::string> out;
  for (const OperandName& operand : expression.operands) {
    if (operand.is_file) {
      out.push_back(operand.text);
      continue;
    }
    const auto found = files.find(operand.text);
    if (found == files.end())
      return bad_argument("EXPR: column " + std::to_string(operand.column) + ": the name " +
                          operand.text + " has no file: write " + operand.text + "=FILE");
    found->second.second = true;
    out.push_back(found->second.first);
  }
  for (const auto& [name, file] : files)
    if (!file.second) return bad_argument("EXPR does not use the name " + name);
  for (const std::string& file : out) {
    if (needs_copy(file)) return bad_argument("an operand is a file, not " + file);
    if (to_utf8(file) != file)
      return bad_argument("the name of the file " + file + " is not UTF-8");
  }
  return out;
}

// Files in quotes get names that no other operand has.
std::vector<std::string> names_of(const std::vector<OperandName>& operands) {
  std::vector<std::string> out;
  const auto is_taken = [&](const std::string& name) {
    return std::any_of(operands.begin(), operands.end(),
                       [&](const OperandName& o) { return !o.is_file && o.text == name; });
  };
  std::size_t number = 0;
  for (const OperandName& o : operands) {
    std::string name = o.text;
    if (o.is_file) do {
        name = "file" + std::to_string(++number);
      } while (is_taken(name));
    out.push_back(std::move(name));
  }
  return out;
}

// As far to each side again as the box is wide.
ExactBox<3> three_times(const ExactBox<3>& box) {
  ExactBox<3> out;
  for (std::size_t k = 0; k < 3; ++k) {
    const Rational width = box[k].width();
    out[k] = {box[k].lo - width, box[k].hi + width};
  }
  return out;
}

class BooleanRun {
 public:
  BooleanRun(const BooleanOptions& options, StandardOutput& out)
      : options_(options), out_(out), progress_(true) {}

  ExitCode run() {
    Result<ExpressionText> expression = read_expression(options_.words[0]);
    if (!expression) return refuse_text(expression.error());
    const Result<std::vector<std::string>> files = files_of(*expression, options_.words);
    if (!files) return fail(files.error());
    if (const Status status = check_outputs(*files); !status) return fail(status.error());
    std::string checker;
    if (!options_.no_check) {
      const Result<std::string> found = find_checker();
      if (!found) return complain(found.error().message), kExitUsage;
      checker = *found;
    }
    const std::vector<std::string> names = names_of(expression->operands);
    CertifySettings settings;
    settings.reading = options_.input.reading;
    settings.reading.jobs = options_.jobs;
    settings.certify.jobs = static_cast<unsigned>(options_.jobs);
    settings.checker = checker;
    ExpressionOperands loaded(settings, progress_);
    std::vector<ExpressionOperand> operands;
    for (std::size_t i = 0; i < names.size(); ++i) {
      const std::string label = expression->operands[i].is_file ? "operand" : "operand " + names[i];
      if (auto operand = loaded.load((*files)[i], label)) operands.push_back(std::move(*operand));
    }
    progress_.clear();
    if (loaded.exit() != kExitValid) return loaded.exit();
    const ExactBox<3> box = options_.box ? *options_.box : three_times(hull_of(operands));
    const Result<ExpressionOperand> whole =
        loaded.combine({&expression->tree, &operands, &names, box});
    if (!whole) return fail(whole.error());
    return write(*expression, *files, names, operands, *whole);
  }

 private:
  const std::string& path() const { return *options_.output; }

  static ExitCode refuse_text(const Error& error) {
    complain("EXPR: " + harmless(error.message));
    return error.code == Code::kOverLimit ? kExitUnreadable : kExitUsage;
  }

  Status check_outputs(const std::vector<std::string>& files) const {
    const Result<OutputPlan> plan = plan_outputs(files, std::nullopt, options_.json);
    if (!plan) return plan.error();
    if (const Status status = check_output("--output", path(), files, *plan, options_.json);
        !status)
      return status;
    return try_outputs(*plan, {options_.json, path()});
  }

  ExitCode write(const ExpressionText& expression, const std::vector<std::string>& files,
                 const std::vector<std::string>& names,
                 const std::vector<ExpressionOperand>& operands, const ExpressionOperand& whole) {
    ChainFile chain;
    chain.tool = tool_name();
    chain.tree = expression.tree;
    chain.box = whole.box;
    BooleanReport report;
    for (std::size_t i = 0; i < names.size(); ++i) {
      const ExpressionOperand& o = operands[i];
      chain.operands.push_back({names[i], from_output(files[i]), o.sha256, o.format});
      report.operands.push_back({names[i], files[i], o.sha256, o.format, o.bytes});
    }
    const std::string text = write_chain(chain);
    if (const Status status = write_output(path(), text, out_); !status)
      return fail(status.error());
    report.path = path();
    report.sha256 =
        to_hex(sha256({reinterpret_cast<const unsigned char*>(text.data()), text.size()}));
    report.bytes = text.size();
    report.expression = write_expression(chain.tree, names);
    report.normal_form = whole.formula.to_string();
    report.leaves = whole.size.leaves;
    report.depth = whole.size.depth;
    report.variables = whole.formula.variables().size();
    report.box = whole.box;
    report.seconds = watch_.lap();
    if (options_.json != "-")
      out_.write(fold("wrote  " + unbroken(harmless(path())) + "  " +
                          counted(report.leaves, "operand", "operands") + ", depth " +
                          std::to_string(report.depth) + ", " +
                          counted(report.variables, "different solid", "different solids") + "\n",
                      verdict_width()));
    if (!options_.json) return kExitValid;
    const Status status = write_output(*options_.json, boolean_json(report), out_);
    return status || *options_.json == "-" ? kExitValid : fail(status.error());
  }

  // The path of an operand as the chain file has it.
  std::string from_output(const std::string& file) const {
    std::error_code none;
    const std::filesystem::path folder = std::filesystem::path(path()).parent_path();
    const auto relative = std::filesystem::proximate(file, folder.empty() ? "." : folder, none);
    return relative.empty() ? file : relative.string();
  }

  const BooleanOptions& options_;
  StandardOutput& out_;
  Progress progress_;
  Stopwatch watch_;
};

}  // namespace

RunCommand declare_boolean(OptionSet& set) {
  const auto o = std::make_shared<BooleanOptions>();
  declare(set, *o);
  set.rule([o] { return contradiction(*o); });
  return [o](StandardOutput& out) { return BooleanRun(*o, out).run(); };
}

}  // namespace veritope::cli
