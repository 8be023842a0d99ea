// SPDX-License-Identifier: LGPL-3.0-or-later
#include "cli/option_set.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <filesystem>
#include <string_view>
#include <system_error>

#include "cli/did_you_mean.h"
#include "cli/output.h"
#include "io/base/exact_number.h"

namespace veritope::cli {
namespace {

constexpr std::size_t kHelpColumn = 23;
// CLI11 says "Could not convert: --quiet = maybe".
constexpr std::string_view kConversion = "Could not convert: ";

// Error messages call the option `shown`.
CLI::Option* add(CLI::App* command, const std::string& name, const std::string& shown,
                 TakeText take, const std::string& help) {
  const auto check = [shown, take = std::move(take)](const std::string& text) {
    const std::string wrong = take(text);
    if (!wrong.empty()) throw CLI::ValidationError(shown, wrong);
  };
  return command->add_option_function<std::string>(name, check, help);
}

std::optional<std::uint64_t> whole_number(const std::string& text) {
  std::uint64_t value = 0;
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc() || stop != end) return std::nullopt;
  return value;
}

bool has_comma(const std::string& text) { return text.find(',') != text.npos; }

// CLI11 leaves an empty line where hidden options would be.
std::string without_gap(std::string help) {
  if (const auto at = help.find("\n\n\n"); at != help.npos) help.erase(at, 1);
  return help;
}

std::string needs_value(const std::string& name, const std::string& type) {
  return name + " needs a value: " + name + " " + type;
}

// CLI11 says "--json: 1 required F missing".
std::string missing_value(const std::string& said) {
  constexpr std::string_view kMiddle = ": 1 required ", kEnd = " missing";
  const std::size_t at = said.find(kMiddle);
  if (at == said.npos || !said.ends_with(kEnd)) return said;
  const std::size_t begin = at + kMiddle.size();
  return needs_value(said.substr(0, at), said.substr(begin, said.size() - kEnd.size() - begin));
}

// What is wrong with "--json=": CLI11 would take the next argument for the value. `command` may be null.
std::string empty_value(const CLI::App* command, const std::vector<std::string>& words) {
  for (const std::string& word : words) {
    if (command == nullptr || word == "--") return "";
    if (!word.starts_with("--") || word.find('=') != word.size() - 1) continue;
    const std::string name = word.substr(0, word.size() - 1);
    const CLI::Option* const option = command->get_option_no_throw(name);
    if (option != nullptr && option->get_items_expected_max() > 0)
      return needs_value(name, option->get_type_name());
  }
  return "";
}

// "dms eval" of a verb.
std::string full_name(const CLI::App& command) {
  const CLI::App* const parent = command.get_parent();
  const bool is_verb = parent != nullptr && parent->get_parent() != nullptr;
  return (is_verb ? parent->get_name() + " " : "") + command.get_name();
}

std::vector<std::string> verb_names(const CLI::App& command) {
  std::vector<std::string> names;
  for (const CLI::App* verb : command.get_subcommands({})) names.push_back(verb->get_name());
  return names;
}

// Null: it has no such verb.
const CLI::App* verb_of(const CLI::App& command, const std::string& name) {
  for (const CLI::App* verb : command.get_subcommands({}))
    if (verb->get_name() == name) return verb;
  return nullptr;
}

// "veritope convert IN OUT"
std::string syntax_of(const CLI::App& command) {
  std::string out = "veritope " + full_name(command);
  for (const CLI::Option* option : command.get_options()) {
    if (!option->get_positional()) continue;
    const std::string name = option->get_name();
    const bool has_many = option->get_items_expected_max() > 2;
    out += option->get_required() ? " " + name + (has_many ? "..." : "") : " [" + name + "]";
  }
  return out;
}

// What is wrong with the word after a command that has verbs; empty if it has none.
std::string unknown_verb(const CLI::App& command, const std::vector<std::string>& words) {
  const std::vector<std::string> verbs = verb_names(command);
  if (verbs.empty()) return "";
  std::string list;
  for (const std::string& verb : verbs) list += (list.empty() ? "" : ", ") + verb;
  if (words.size() < 2) return command.get_name() + " needs one of: " + list;
  if (words[1].starts_with('-') || std::find(verbs.begin(), verbs.end(), words[1]) != verbs.end())
    return "";
  return command.get_name() + " has no " + words[1] + ", but: " + list +
         did_you_mean(words[1], verbs);
}

// "a, b and c"; REQUIRES a name.
std::string and_list(const std::vector<std::string>& names) {
  std::string out = names.front();
  for (std::size_t i = 1; i < names.size(); ++i)
    out += (i + 1 < names.size() ? ", " : " and ") + names[i];
  return out;
}

}  // namespace

void OptionSet::flag(const std::string& name, bool& target, const std::string& help) {
  command_->add_flag(name, target, help);
}

void OptionSet::text(const std::string& name, std::optional<std::string>& target,
                     const std::string& help, const std::string& type) {
  const auto take = [&target, type](const std::string& text) -> std::string {
    if (text.empty()) return type == "F" ? "needs a name" : "needs a " + type;
    target = text;
    return "";
  };
  option(name, type, take, help);
}

void OptionSet::output(const std::string& name, std::optional<std::string>& target,
                       const std::string& help) {
  const auto take = [&target](const std::string& text) -> std::string {
    if (text.empty()) return "needs a name";
    target = output_name(text);
    return "";
  };
  option(name, "F", take, help);
}

void OptionSet::add_number(const std::string& name, NumberRange range, const std::string& help,
                           std::function<void(std::uint64_t)> store) {
  const auto take = [range, store = std::move(store)](const std::string& text) -> std::string {
    const auto value = whole_number(text);
    if (!value || *value < range.least || *value > range.most)
      return "must be a number from " + std::to_string(range.least) + " to " +
             (range.most == kMost64 ? "2^64 - 1" : std::to_string(range.most)) + ", not " + text +
             (has_comma(text) ? " (digits only)" : "");
    store(*value);
    return "";
  };
  const std::string long_name = name.substr(name.rfind("--"));
  add(command_, name, long_name, take, help)->type_name("N");
}

void OptionSet::add_length(const std::string& name, const std::string& type,
                           const std::string& help, const std::string& what,
                           std::function<void(double)> store) {
  const auto take = [what, store = std::move(store)](const std::string& text) -> std::string {
    Rational exact;
    const bool is_number = read_exact_number(text, {}, exact) == DecimalFault::kNone;
    const double value = is_number ? nearest_double(exact) : 0;
    if (!(value >= 1e-300 && value <= 1e300))
      return "must be " + what + " from 1e-300 to 1e300, not " + text +
             (has_comma(text) ? " (a decimal comma?)" : "");
    store(value);
    return "";
  };
  option(name, type, take, help);
}

void OptionSet::option(const std::string& name, const std::string& type, TakeText take,
                       const std::string& help) {
  add(command_, name, name, std::move(take), help)->type_name(type);
}

void OptionSet::repeatable(const std::string& name, const std::string& type, TakeText take,
                           const std::string& help) {
  constexpr int kMost = 1000;
  const auto check = [name, take = std::move(take)](const std::vector<std::string>& texts) {
    for (const std::string& text : texts)
      if (const std::string wrong = take(text); !wrong.empty())
        throw CLI::ValidationError(name, wrong);
  };
  command_->add_option_function<std::vector<std::string>>(name, check, help)
      ->type_name(type)
      ->expected(1, kMost)
      ->allow_extra_args(false);
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

OptionSet& OptionSet::verb(const std::string& name, const std::string& summary) {
  command_->require_subcommand(1);
  return *verbs_.emplace_back(
      std::make_unique<OptionSet>(*command_->add_subcommand(name, summary)));
}

std::optional<std::size_t> OptionSet::chosen_verb() const {
  for (std::size_t i = 0; i < verbs_.size(); ++i)
    if (verbs_[i]->command_->parsed()) return i;
  return std::nullopt;
}

std::string OptionSet::contradiction() const {
  for (const OptionRule& rule : rules_)
    if (std::string wrong = rule(); !wrong.empty()) return wrong;
  const auto verb = chosen_verb();
  return verb ? verbs_[*verb]->contradiction() : "";
}

CommandLine::CommandLine(const std::string& title, const std::string& version,
                         const std::string& footer)
    : version_(version), app_(std::make_unique<CLI::App>(title, "veritope")) {
  app_->set_version_flag("-V,--version", version);
  app_->require_subcommand(1);
  app_->footer(footer);
  app_->get_formatter()->column_width(kHelpColumn);
}

void CommandLine::set_list_footer(const std::string& footer) {
  app_->footer(footer);
  // An option without a group is not listed.
  app_->get_help_ptr()->group("");
  app_->get_version_ptr()->group("");
}

CommandLine::~CommandLine() = default;

OptionSet& CommandLine::add_command(const std::string& name, const std::string& summary) {
  return sets_.emplace_back(*app_->add_subcommand(name, summary));
}

ParsedLine CommandLine::parse(int argc, const char* const* argv) {
  const std::vector<std::string> words(argv + std::min(argc, 1), argv + argc);
  if (words.empty()) return {std::nullopt, help(), ""};
  if (words.front() == "help") return help_about({words.begin() + 1, words.end()});
  const CLI::App* const command = find(words.front());
  if (command == nullptr && !words.front().starts_with('-'))
    return {std::nullopt, "", unknown_command(words.front())};
  const CLI::App* const verb =
      command == nullptr || words.size() < 2 ? nullptr : verb_of(*command, words[1]);
  if (std::string wrong = empty_value(verb != nullptr ? verb : command, words); !wrong.empty())
    return {std::nullopt, "", std::move(wrong)};
  if (command != nullptr)
    if (std::string wrong = unknown_verb(*command, words); !wrong.empty())
      return {std::nullopt, "", std::move(wrong)};
  try {
    app_->parse(argc, argv);
    return chosen();
  } catch (const CLI::CallForHelp&) {
    return {std::nullopt, help(), ""};
  } catch (const CLI::CallForVersion&) {
    return {std::nullopt, version_ + "\n", ""};
  } catch (const CLI::ArgumentMismatch& error) {
    return {std::nullopt, "", wrong_count(error.what())};
  } catch (const CLI::ExtrasError& error) {
    return {std::nullopt, "", wrong_arguments(error.what(), true)};
  } catch (const CLI::ParseError& error) {
    return {std::nullopt, "", wrong_arguments(error.what(), false)};
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

std::vector<std::string> CommandLine::commands_with(const std::string& option) const {
  std::vector<std::string> out;
  const auto add = [&](const CLI::App& command) {
    if (command.get_option_no_throw(option) != nullptr) out.push_back(full_name(command));
  };
  for (const OptionSet& set : sets_) {
    add(*set.command_);
    for (const auto& verb : set.verbs_) add(*verb->command_);
  }
  return out;
}

const CLI::App& CommandLine::named() const {
  const CLI::App* at = app_.get();
  for (auto below = at->get_subcommands(); !below.empty(); below = at->get_subcommands())
    at = below.front();
  return *at;
}

ParsedLine CommandLine::help_about(const std::vector<std::string>& commands) const {
  if (commands.empty()) return {std::nullopt, help(), ""};
  if (commands.size() > 1)
    return {std::nullopt, "", "help takes one command: veritope help " + commands.front()};
  const CLI::App* const command = find(commands.front());
  if (command == nullptr) return {std::nullopt, "", unknown_command(commands.front())};
  return {std::nullopt, without_gap(command->help("veritope")), ""};
}

std::string CommandLine::unknown_command(const std::string& word) const {
  std::error_code none;
  const std::string meant = did_you_mean(word, command_names());
  if (meant.empty() && std::filesystem::exists(word, none))
    return "unknown command: " + word + "; to decide about this file: veritope certify " + word;
  return "unknown command: " + word + meant;
}

// "certify has no option --quite; did you mean --quiet?"; empty if every argument that looks like an option is one.
std::string CommandLine::unknown_option() const {
  for (const std::string& argument : named().remaining()) {
    if (argument.size() < 2 || argument[0] != '-' || argument == "--") continue;
    const std::string option = argument.substr(0, argument.find('='));
    const std::string said = full_name(named()) + " has no option " + option;
    if (const auto others = commands_with(option); !others.empty())
      return said + "; it is one of " + and_list(others);
    std::vector<std::string> names;
    for (const CLI::Option* known : named().get_options()) {
      for (const std::string& name : known->get_lnames()) names.push_back("--" + name);
      for (const std::string& name : known->get_snames()) names.push_back("-" + name);
    }
    return said + did_you_mean(option, names);
  }
  return "";
}

// Replaces what CLI11 says about an option without its value, one that is given twice, or too few files.
std::string CommandLine::wrong_count(const std::string& said) const {
  for (const CLI::Option* option : named().get_options()) {
    const std::size_t count = option->count();
    const auto most = static_cast<std::size_t>(option->get_items_expected_max());
    const auto least = static_cast<std::size_t>(option->get_items_expected_min());
    const bool is_flag = most == 0;
    if (is_flag || count == 0 || (count >= least && count <= most)) continue;
    if (!option->get_positional())
      return "--" + option->get_lnames().at(0) + " is given " + std::to_string(count) + " times";
    return syntax_of(named()) + " takes " + std::to_string(least) + " files, and there " +
           (count == 1 ? "is 1" : "are " + std::to_string(count));
  }
  return missing_value(said);
}

std::string CommandLine::wrong_arguments(const std::string& said, bool has_extras) const {
  if (std::string unknown = unknown_option(); !unknown.empty()) return unknown;
  if (&named() == app_.get()) return "a command is needed: veritope certify FILE";
  if (has_extras)
    return "the argument " + named().remaining().front() +
           " is one too many: " + syntax_of(named());
  if (said.starts_with(kConversion)) {
    const std::size_t begin = kConversion.size();
    return said.substr(begin, said.find(" = ") - begin) + " takes no value";
  }
  return said.ends_with(" is required") ? said + ": " + syntax_of(named()) : said;
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
  const auto commands =
      app_->get_subcommands();  // the help of one is that of its verb, if it has one
  return without_gap(commands.empty() ? app_->help() : commands.front()->help("veritope"));
}

}  // namespace veritope::cli
