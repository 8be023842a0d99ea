// SPDX-License-Identifier: LGPL-3.0-or-later
// veritope explain.
#include <algorithm>
#include <cctype>
#include <memory>
#include <optional>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "cli/commands.h"
#include "cli/did_you_mean.h"
#include "cli/patch_explanations.h"
#include "cli/reason_explanations.h"
#include "cli/rule_pictures.h"
#include "report/text_style.h"
#include "solids/polyhedron/rules.h"

namespace veritope::cli {

using namespace report;
namespace {

struct ExplainOptions {
  std::optional<std::string> rule;
};

constexpr std::size_t kWidth = 78;
constexpr std::size_t kLeastWord = 4;  // characters: a shorter one is no word of a title

// Words in lines of at most kWidth characters, each line indented.
std::string wrapped(std::string_view text, std::string_view indent) {
  std::string out, line;
  while (!text.empty()) {
    const std::size_t space = std::min(text.find(' '), text.size());
    const std::string_view word = text.substr(0, space);
    if (!line.empty() && indent.size() + line.size() + 1 + word.size() > kWidth) {
      out += std::string(indent) + line + "\n";
      line.clear();
    }
    line += (line.empty() ? "" : " ") + std::string(word);
    text.remove_prefix(std::min(space + 1, text.size()));
  }
  return line.empty() ? out : out + std::string(indent) + line + "\n";
}

std::string indented(std::string_view lines) {
  std::string out = "  ";
  for (const char c : lines) {
    out += c;
    if (c == '\n') out += "  ";
  }
  return out + "\n";
}

std::string rule_page(const RuleText& text, std::string_view picture, const Style& style) {
  const auto section = [&](const char* title, std::string_view words) {
    return style.bold(title) + "\n" + wrapped(words, "  ");
  };
  return style.bold(std::string(text.id) + "  " + std::string(text.name)) + "\n" +
         wrapped(text.meaning, "  ") + indented(picture) +
         section("Where it comes from", text.causes) + section("What helps", text.remedy) +
         section("What others call it", text.crosswalk);
}

std::string reason_page(const ReasonText& text, const Style& style) {
  const auto section = [&](const char* title, std::string_view words) {
    return style.bold(title) + "\n" + wrapped(words, "  ");
  };
  return style.bold(std::string(text.code) + "  " + std::string(text.name)) + "\n" +
         wrapped(text.meaning, "  ") + section("Where it comes from", text.causes) +
         section("What helps", text.remedy);
}

// The names of the pages, then the words of their titles.
std::vector<std::string> all_names() {
  std::vector<std::string> out, words;
  const auto add = [&](std::string_view id, std::string_view name) {
    out.emplace_back(id);
    std::istringstream title{std::string(name)};
    for (std::string word; title >> word;)
      if (word.size() >= kLeastWord) words.push_back(word);
  };
  for (std::size_t i = 0; i < kNumMeshRules; ++i)
    add(rule_text(rule_at(i)).id, rule_text(rule_at(i)).name);
  for (const PatchExplanation& e : patch_explanations()) add(e.text.id, e.text.name);
  for (const ReasonText& r : reason_texts()) add(r.code, r.name);
  out.insert(out.end(), words.begin(), words.end());
  return out;
}

std::string rule_list(const Style& style) {
  std::string out;
  for (std::size_t i = 0; i < kNumMeshRules; ++i) {
    const RuleText& text = rule_text(rule_at(i));
    out += style.bold(text.id) + "  " + std::string(text.name) + "\n";
  }
  out += "A mesh bounds a solid if it breaks none of these. More: veritope explain M1\n\n";
  for (const PatchExplanation& e : patch_explanations())
    out += style.bold(e.text.id) + "  " + std::string(e.text.name) + "\n";
  out += "Answers about patches of spline files. More: veritope explain side-open\n\n";
  for (const ReasonText& r : reason_texts())
    out += style.bold(r.code) + "  " + std::string(r.name) + "\n";
  return out + "Why there is no answer, or no file. More: veritope explain undecided\n";
}

std::string lower(std::string_view text) {
  std::string out(text);
  for (char& c : out) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return out;
}

// "m10"
bool is_number_of_rule(const std::string& name) {
  return name.size() > 1 && lower(name)[0] == 'm' &&
         name.find_first_not_of("0123456789", 1) == name.npos;
}

// The page with this name in any case; empty: there is no such page.
std::string page_of(const std::string& name, const Style& style) {
  if (const std::optional<MeshRule> rule = rule_from_id(name))
    return rule_page(rule_text(*rule), rule_picture(*rule), style);
  if (const PatchExplanation* const patches = patch_explanation(lower(name)))
    return rule_page(patches->text, patches->picture, style);
  if (const ReasonText* const reason = reason_text(lower(name))) return reason_page(*reason, style);
  return "";
}

struct PageName {
  std::string_view id, name;
};

// Pages whose titles have the word, such as "boundary".
std::vector<PageName> pages_about(const std::string& word) {
  std::vector<PageName> out;
  const auto consider = [&](std::string_view id, std::string_view name) {
    if (lower(name).find(lower(word)) != std::string::npos) out.push_back({id, name});
  };
  for (std::size_t i = 0; i < kNumMeshRules; ++i)
    consider(rule_text(rule_at(i)).id, rule_text(rule_at(i)).name);
  for (const PatchExplanation& e : patch_explanations()) consider(e.text.id, e.text.name);
  for (const ReasonText& r : reason_texts()) consider(r.code, r.name);
  return out;
}

// The one page about a word, or the names of several.
std::string pages_text(const std::vector<PageName>& pages, const Style& style) {
  if (pages.size() == 1) return page_of(std::string(pages.front().id), style);
  std::string out;
  for (const PageName& p : pages) out += style.bold(p.id) + "  " + std::string(p.name) + "\n";
  return out;
}

ExitCode run(const ExplainOptions& options, StandardOutput& out) {
  const Style style = style_of_stdout();
  const bool is_of_all =
      !options.rule || lower(*options.rule) == "valid" || lower(*options.rule) == "invalid";
  if (is_of_all) {
    out.write(rule_list(style));
    return kExitValid;
  }
  if (const std::string page = page_of(*options.rule, style); !page.empty()) {
    out.write(page);
    return kExitValid;
  }
  const std::vector<PageName> pages = pages_about(*options.rule);
  if (options.rule->size() >= kLeastWord && !pages.empty()) {
    out.write(pages_text(pages, style));
    return kExitValid;
  }
  if (is_number_of_rule(*options.rule)) {
    complain("there is no rule " + *options.rule + "; the rules are M1 to M" +
             std::to_string(kNumMeshRules));
    return kExitUsage;
  }
  if (const auto meant = nearest_name(*options.rule, all_names())) {
    complain("there is no page about " + harmless(*options.rule) + "; did you mean " + *meant +
             "?");
    return kExitUsage;
  }
  complain("there is no page about " + harmless(*options.rule) +
           "; veritope explain lists the rules, answers and reasons that have one");
  return kExitUsage;
}

}  // namespace

RunCommand declare_explain(OptionSet& set) {
  const auto o = std::make_shared<ExplainOptions>();
  set.optional_operand("RULE", any_text(o->rule), "M1 to M9, side-open, ..., or a word: boundary");
  set.rule([o] { return o->rule == "" ? "RULE must not be empty" : ""; });
  return [o](StandardOutput& out) { return run(*o, out); };
}

}  // namespace veritope::cli
