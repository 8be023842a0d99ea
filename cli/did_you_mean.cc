// SPDX-License-Identifier: LGPL-3.0-or-later
#include "cli/did_you_mean.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace veritope::cli {
namespace {

constexpr std::size_t kMostLetters = 64;

std::size_t num_hyphens(std::string_view word) {
  return std::min(word.find_first_not_of('-'), word.size());
}

char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

// The optimal string alignment distance.
std::size_t distance(std::string_view a, std::string_view b) {
  using Row = std::array<std::size_t, kMostLetters + 1>;
  Row before{}, last{}, row{};
  for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    before = last, last = row;
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const bool is_equal = lower(a[i - 1]) == lower(b[j - 1]);
      row[j] = std::min({last[j] + 1, row[j - 1] + 1, last[j - 1] + (is_equal ? 0 : 1)});
      if (i > 1 && j > 1 && lower(a[i - 1]) == lower(b[j - 2]) &&
          lower(a[i - 2]) == lower(b[j - 1]))
        row[j] = std::min(row[j], before[j - 2] + 1);
    }
  }
  return row[b.size()];
}

// The only name that begins with the word.
std::optional<std::string> completed(std::string_view word, const std::vector<std::string>& names) {
  constexpr std::size_t kLeastPart = 4;
  if (word.size() - num_hyphens(word) < kLeastPart) return std::nullopt;
  const auto begins = [word](const std::string& name) {
    return name.size() > word.size() && distance(word, name.substr(0, word.size())) == 0;
  };
  const auto first = std::find_if(names.begin(), names.end(), begins);
  if (first == names.end() || std::any_of(first + 1, names.end(), begins)) return std::nullopt;
  return *first;
}

}  // namespace

std::optional<std::string> nearest_name(std::string_view word,
                                        const std::vector<std::string>& names) {
  const std::size_t letters = word.size() - num_hyphens(word);
  if (word.size() > kMostLetters || letters == 0) return std::nullopt;
  // One letter is near to itself in the other case only.
  std::size_t least = letters == 1 ? 1 : std::max<std::size_t>(1, word.size() / 4) + 1;
  std::optional<std::string> out;
  for (const std::string& name : names) {
    if (name.size() > kMostLetters) continue;
    const std::size_t d = distance(word, name);
    if (d < least) least = d, out = name;
  }
  return out ? out : completed(word, names);
}

std::vector<std::string> names_of_list(std::string_view list) {
  constexpr std::string_view kBetween = ", ";
  std::vector<std::string> out;
  for (;;) {
    const std::size_t at = list.find(kBetween);
    out.emplace_back(list.substr(0, at));
    if (at == list.npos) return out;
    list.remove_prefix(at + kBetween.size());
  }
}

std::string did_you_mean(std::string_view word, const std::vector<std::string>& names) {
  const auto name = nearest_name(word, names);
  return name ? "; did you mean " + *name + "?" : "";
}

}  // namespace veritope::cli
