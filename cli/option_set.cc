// SPDX-License-Identifier: LGPL-3.0-or-later
#include "cli/option_set.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <string_view>

#include "cli/did_you_mean.h"

namespace veritope::cli {
namespace {

constexpr std::size_t kHelpColumn = 23;

// Error messages call the option `shown`.
CLI::Option* add(CLI::App* command, const std::string& name, const std::string& shown,
                 TakeText take, const std::string& help) {
  const auto check = [shown, take = std::move(take)](const std::string& text) {
    const std::string wrong = take(text);
    if (!wrong.empty()) throw CLI::ValidationError(shown, wrong);
  };
  return command->add_option_function<std::string>(name, check, help);
}

template <typename Number>
std::optional<Number> whole_text(const std::string& text) {
  Number value = 0;
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc() || stop != end) return std::nullopt;
  return value;
}

// CLI11 leaves an empty line where hidden options would be.
std::string without_gap(std::string help) {
  if (const auto at = help.find("\n\n\n"); at != help.npos) help.erase(at, 1);
  return help;
}

// CLI11 says "--json: 1 required F missing".
std::string missing_value(const std::string& said) {
  constexpr std::string_view kMiddle = ": 1 required ", kEnd = " missing";
  const std::size_t at = said.find(kMiddle);
  if (at == said.npos || !said.ends_with(kEnd)) return said;
  const std::size_t begin = at + kMiddle.size();
  return said.substr(0, at) + " needs a value: " + said.substr(0, at) + " " +
         said.substr(begin, said.size() - kEnd.size() - begin);
}

}  // namespace

void OptionSet::flag(const std::string& name, bool& target, const std::string& help) {
  command_->add_flag(name, target, help);
}

void OptionSet::text(const std::string& name, std::optional<std::string>& target,
                     const std::string& help, const std::string& type) {
  const auto take = [&target](const std::string& text) -> std::string {
    if (text.empty()) return "needs a name";
    target = text;
    return "";
  };
  option(name, type, take, help);
}

void OptionSet::add_number(const std::string& name, NumberRange range, const std::string& help,
                           std::function<void(std::uint64_t)> store) {
  const auto take = [range, store = std::move(store)](const std::string& text) -> std::string {
    const auto value = whole_text<std::uint64_t>(text);
    if (!value || *value < range.least || *value > range.most)
      return "must be a number from " + std::to_string(range.least) + " to " +
             std::to_string(range.most) + ", not " + text;
    store(*value);
    return "";
  };
  const std::string long_name = name.substr(name.rfind("--"));
  add(command_, name, long_name, take, help)->type_name("N");
}

void OptionSet::add_length(const std::string& name, const std::string& type,
                           const std::string& help, std::function<void(double)> store) {
  const auto take = [store = std::move(store)](const std::string& text) -> std::string {
    const auto value = whole_text<double>(text);
    if (!value || !(*value >= 1e-300 && *value <= 1e300))
      return "must be a length from 1e-300 to 1e300, not " + text;
    store(*value);
    return "";
  };
  option(name, type, take, help);
}

void OptionSet::option(const std::string& name, const std::string& type, TakeText take,
                       const std::string& help) {
  add(command_, name, name, std::move(take), help)->type_name(type);
}

void OptionSet::operand(const std::string& name, TakeText take, const std::string& help) {
  add(command_, name, name, std::move(take), help)->required()->type_name("");
}

void OptionSet::optional_operand(const std::string& name, TakeText take, const std::string& help) {
  option(name, "", std::move(take), help);
}

void OptionSet::operands(const std::string& name, std::vector<std::string>& target,
                         const std::string& help, int count) {
  CLI::Option* const all = command_->add_option(name, target, help)->required()->type_name("");
  if (count != 0) all->expected(count);
}

void OptionSet::hide(const std::string& name) { command_->get_option(name)->group(""); }

void OptionSet::excludes(const std::string& name, const std::string& other) {
  command_->get_option(name)->excludes(command_->get_option(other));
}

void OptionSet::needs(const std::string& name, const std::string& other) {
  command_->get_option(name)->needs(command_->get_option(other));
}

std::string OptionSet::contradiction() const {
  for (const OptionRule& rule : rules_)
    if (std::string wrong = rule(); !wrong.empty()) return wrong;
  return "";
}

CommandLine::CommandLine(const std::string& title, const std::string& version,
                         const std::string& footer)
    : version_(version), app_(std::make_unique<CLI::App>(title, "veritope")) {
  app_->set_version_flag("-V,--version", version);
  app_->require_subcommand(1);
  app_->footer(footer);
  app_->get_formatter()->column_width(kHelpColumn);
}

CommandLine::~CommandLine() = default;

OptionSet& CommandLine::add_command(const std::string& name, const std::string& summary) {
  return sets_.emplace_back(*app_->add_subcommand(name, summary));
}

ParsedLine CommandLine::parse(int argc, const char* const* argv) {
  if (argc == 1) return {std::nullopt, help(), ""};
  const std::string first = argv[1];
  if (first == "help") return help_about(argc == 2 ? nullptr : argv[2]);
  if (!first.starts_with('-') && find(first) == nullptr)
    return {std::nullopt, "", "unknown command: " + first + did_you_mean(first, command_names())};
  try {
    app_->parse(argc, argv);
    return chosen();
  } catch (const CLI::CallForHelp&) {
    return {std::nullopt, help(), ""};
  } catch (const CLI::CallForVersion&) {
    return {std::nullopt, version_ + "\n", ""};
  } catch (const CLI::ArgumentMismatch& error) {
    return {std::nullopt, "", missing_value(error.what())};
  } catch (const CLI::ParseError& error) {
    const std::string unknown = unknown_option();
    return {std::nullopt, "", unknown.empty() ? error.what() : unknown};
  }
}

const CLI::App* CommandLine::find(const std::string& name) const {
  const auto set = std::find_if(sets_.begin(), sets_.end(),
                                [&](const OptionSet& s) { return s.command_->get_name() == name; });
  return set == sets_.end() ? nullptr : set->command_;
}

std::vector<std::string> CommandLine::command_names() const {
  std::vector<std::string> out{"help"};
  for (const OptionSet& set : sets_) out.push_back(set.command_->get_name());
  return out;
}

ParsedLine CommandLine::help_about(const char* name) const {
  if (name == nullptr) return {std::nullopt, help(), ""};
  const CLI::App* const command = find(name);
  if (command != nullptr) return {std::nullopt, without_gap(command->help("veritope")), ""};
  return {std::nullopt, "",
          std::string("unknown command: ") + name + did_you_mean(name, command_names())};
}

// "certify has no option --quite; did you mean --quiet?"; empty if every argument that looks like an option is one.
std::string CommandLine::unknown_option() const {
  const auto named = app_->get_subcommands();
  const CLI::App* const app = named.empty() ? app_.get() : named.front();
  for (const std::string& argument : app->remaining()) {
    if (argument.size() < 2 || argument[0] != '-') continue;
    const std::string option = argument.substr(0, argument.find('='));
    std::vector<std::string> names;
    for (const CLI::Option* known : app->get_options()) {
      for (const std::string& name : known->get_lnames()) names.push_back("--" + name);
      for (const std::string& name : known->get_snames()) names.push_back("-" + name);
    }
    return app->get_name() + " has no option " + option + did_you_mean(option, names);
  }
  return "";
}

// REQUIRES that parsing succeeded: then exactly one command was named.
ParsedLine CommandLine::chosen() const {
  const CLI::App* const named = app_->get_subcommands().front();
  const auto is_chosen = [named](const OptionSet& set) { return set.command_ == named; };
  const auto set = std::find_if(sets_.begin(), sets_.end(), is_chosen);
  ParsedLine out;
  out.error = set->contradiction();
  if (out.error.empty()) out.command = static_cast<std::size_t>(set - sets_.begin());
  return out;
}

std::string CommandLine::help() const {
  const auto named = app_->get_subcommands();
  return without_gap(named.empty() ? app_->help() : named.front()->help("veritope"));
}

}  // namespace veritope::cli
