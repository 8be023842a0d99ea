// SPDX-License-Identifier: LGPL-3.0-or-later
// report/text_style.h: what makes a text pleasant on a terminal and harmless anywhere.
#pragma once
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>

namespace veritope::report {

/// Colours, or nothing.
struct Style {
  bool is_coloured = false;

  std::string bold(std::string_view text) const { return wrap("1", text); }
  std::string green(std::string_view text) const { return wrap("1;32", text); }
  std::string red(std::string_view text) const { return wrap("1;31", text); }
  std::string yellow(std::string_view text) const { return wrap("1;33", text); }
  std::string dim(std::string_view text) const { return wrap("2", text); }

 private:
  std::string wrap(const char* code, std::string_view text) const {
    if (!is_coloured) return std::string(text);
    return std::string("\033[") + code + "m" + std::string(text) + "\033[0m";
  }
};

/// Coloured if standard output is a terminal, NO_COLOR is unset or empty, and TERM is not "dumb".
Style style_of_stdout();

/// Names and messages from elsewhere: control characters and what is no UTF-8 become \xNN, so that no
/// file can drive the terminal.
std::string harmless(std::string_view text);

/// The columns of the terminal that a stream is, at least 40; nothing: it is no terminal, or hides its size.
std::optional<std::size_t> terminal_width(int descriptor);

/// The columns of reports on standard output: 100, or those of a terminal that has fewer.
std::size_t report_width();

constexpr std::size_t kNoWidth = std::numeric_limits<std::size_t>::max();  ///< lines are not broken

/// The columns of lines on standard output that other programs read: those of a terminal, elsewhere kNoWidth.
std::size_t verdict_width();

/// The columns of messages on standard error, likewise.
std::size_t message_width();

/// The columns that a text takes: its characters, without the sequences that colour it. (Wide characters count as one.)
std::size_t columns(std::string_view text);

/// Marks the spaces of a text, for instance of a path, so that fold does not break it.
std::string unbroken(std::string text);

/// Breaks the lines that take more than `width` columns at spaces. A continuation starts below the value of
/// detail_line, or two columns to the right of the line that it continues. A word without spaces stays whole however
/// long it is. Colours take no columns.
std::string fold(std::string_view text, std::size_t width);

/// "1 face", "2 faces".
std::string counted(std::uint64_t count, std::string_view one, std::string_view many);

/// A line of a report: indented, the name in a column of its own.
std::string detail_line(std::string_view name, const std::string& value);

}  // namespace veritope::report
