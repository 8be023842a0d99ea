// SPDX-License-Identifier: LGPL-3.0-or-later
// cli/did_you_mean.h: the name that was probably meant where another one was typed.
#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace veritope::cli {

/// The name that is reached from the word by the fewest insertions, deletions, replacements and exchanges of
/// neighbours, the first of several: if these are at most a quarter of the word's length, and one for two letters and
/// more; upper case counts as lower case. Otherwise the only name that begins with the word, if that has four letters.
/// Hyphens in front are not letters. Nothing if there is no such name.
/// @cost  the product of the lengths, for each name; words of over 64 letters have no such name
std::optional<std::string> nearest_name(std::string_view word,
                                        const std::vector<std::string>& names);

/// The names of a list such as "a, b, c".
std::vector<std::string> names_of_list(std::string_view list);

/// "; did you mean --quiet?", or nothing.
std::string did_you_mean(std::string_view word, const std::vector<std::string>& names);

}  // namespace veritope::cli
