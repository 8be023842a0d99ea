// SPDX-License-Identifier: LGPL-3.0-or-later
// cli/option_set.h: the options of one command, and the command line that is parsed with those of all commands.
// CLI11 does the work. A unit that includes it takes seconds longer to compile, so option_set.cc alone does.
#pragma once
#include <cstdint>
#include <deque>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace veritope::cli {

/// Takes the text of an option. Returns nothing, or what is wrong with the text, in words that follow the name of the
/// option ("must be auto or keep, not x").
using TakeText = std::function<std::string(const std::string& text)>;

/// Takes any text as it is, for a string or an optional one that lives until the line is parsed.
template <typename Text>
TakeText any_text(Text& target) {
  return [&target](const std::string& text) -> std::string {
    target = text;
    return "";
  };
}

/// Returns nothing, or what is wrong with the options of a command as a whole, as a sentence.
using OptionRule = std::function<std::string()>;

constexpr std::uint64_t kMost64 = std::numeric_limits<std::uint64_t>::max();
constexpr std::uint64_t kMost32 = std::numeric_limits<std::uint32_t>::max();

/// The range of numbers that an option accepts, both ends included.
struct NumberRange {
  std::uint64_t least = 0, most = kMost64;
};

/// The help lists options in the order of their declaration. Names are those of CLI11: "-j,--jobs".
/// REQUIRES that every target lives until the line is parsed.
class OptionSet {
 public:
  explicit OptionSet(CLI::App& command) : command_(&command) {}

  void flag(const std::string& name, bool& target, const std::string& help);
  /// Accepts any text that is not empty.
  void text(const std::string& name, std::optional<std::string>& target, const std::string& help,
            const std::string& type = "F");
  /// A file to write, "-" for standard output, also under its names /dev/stdout and the like.
  void output(const std::string& name, std::optional<std::string>& target, const std::string& help);
  /// Accepts decimal digits only.
  template <typename T>
  void number(const std::string& name, T& target, NumberRange range, const std::string& help) {
    add_number(name, range, help,
               [&target](std::uint64_t value) { target = static_cast<T>(value); });
  }
  /// Accepts a decimal, a fraction or a hexadecimal number, and rounds it to the nearest binary64 number, which is from
  /// 1e-300 to 1e300, so that products stay finite after a few roundings. Messages call it `what`.
  template <typename T>
  void length(const std::string& name, const std::string& type, T& target, const std::string& help,
              const std::string& what = "a length") {
    add_length(name, type, help, what, [&target](double value) { target = value; });
  }
  /// Accepts whatever `take` accepts; the help shows `type` for the value.
  void option(const std::string& name, const std::string& type, TakeText take,
              const std::string& help);
  /// An option that may be given several times, each time with one value, which `take` accepts in their order.
  void repeatable(const std::string& name, const std::string& type, TakeText take,
                  const std::string& help);

  /// One argument without a name; the name is for the help.
  void operand(const std::string& name, TakeText take, const std::string& help);
  void optional_operand(const std::string& name, TakeText take, const std::string& help);
  /// Exactly `count` such arguments; 0: one or more.
  void operands(const std::string& name, std::vector<std::string>& target, const std::string& help,
                int count = 0);

  /// Omits an option from the help, because another line there names it.
  void hide(const std::string& name);
  void excludes(const std::string& name, const std::string& other);
  void needs(const std::string& name, const std::string& other);
  /// Rules are tested after parsing, in the order of their declaration. The first complaint is
  /// reported.
  void rule(OptionRule rule) { rules_.push_back(std::move(rule)); }

  /// One of the verbs of a command, exactly one of which must be given after its name, with options of its own:
  /// "veritope dms eval". A command with verbs has no options. The set lives as long as this one.
  OptionSet& verb(const std::string& name, const std::string& summary);
  /// The number of the verb that was given, in the order of verb(); nothing before parsing.
  std::optional<std::size_t> chosen_verb() const;

 private:
  friend class CommandLine;

  void add_number(const std::string& name, NumberRange range, const std::string& help,
                  std::function<void(std::uint64_t)> store);
  void add_length(const std::string& name, const std::string& type, const std::string& help,
                  const std::string& what, std::function<void(double)> store);
  std::string contradiction() const;

  CLI::App* command_;
  std::vector<OptionRule> rules_;
  std::vector<std::unique_ptr<OptionSet>> verbs_;
};

/// What the arguments ask for: a command, or a text to print (help, version), or neither: wrong usage.
struct ParsedLine {
  std::optional<std::size_t> command;  ///< its number, in the order of add_command
  std::string text;                    ///< to print on standard output
  std::string error;                   ///< one sentence
};

class CommandLine {
 public:
  /// @param version  what --version prints
  /// @param footer   the last lines of the help of the program
  CommandLine(const std::string& title, const std::string& version, const std::string& footer);
  /// Other last lines for the list of commands, which has no list of options then: the footer names them. To be called
  /// after all of them were added.
  void set_list_footer(const std::string& footer);
  ~CommandLine();

  /// The set lives as long as this object.
  OptionSet& add_command(const std::string& name, const std::string& summary);
  ParsedLine parse(int argc, const char* const* argv);

 private:
  ParsedLine chosen() const;
  std::string help() const;
  ParsedLine help_about(const std::vector<std::string>& commands) const;
  std::vector<std::string> command_names() const;
  std::vector<std::string> commands_with(const std::string& option) const;
  const CLI::App* find(const std::string& name) const;  // null: no command
  // The command, or the verb of it; the program itself before a command.
  const CLI::App& named() const;
  std::string unknown_command(const std::string& word) const;
  std::string unknown_option() const;
  std::string wrong_count(const std::string& said) const;
  std::string wrong_arguments(const std::string& said, bool has_extras) const;

  std::string version_;
  std::unique_ptr<CLI::App> app_;
  std::deque<OptionSet> sets_;
};

}  // namespace veritope::cli
