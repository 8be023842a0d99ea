// SPDX-License-Identifier: LGPL-3.0-or-later
#include "report/text_style.h"

#include <algorithm>

#include <stdlib.h>
#include <sys/ioctl.h>
#include <unistd.h>

namespace veritope::report {
namespace {

// Bytes of the UTF-8 character at the start, 0 if it is a control character (C0, DEL, C1) or no UTF-8. REQUIRES a byte.
std::size_t printable_size(std::string_view text) {
  const auto at = [text](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned char lead = at(0);
  if (lead < 0x80) return lead >= 0x20 && lead != 0x7f ? 1 : 0;
  const std::size_t size = lead >= 0xf0 ? 4 : (lead >= 0xe0 ? 3 : 2);
  if (lead < 0xc2 || lead > 0xf4 || text.size() < size) return 0;
  for (std::size_t i = 1; i < size; ++i) {
    if ((at(i) & 0xc0) != 0x80) return 0;
  }
  return lead == 0xc2 && at(1) < 0xa0 ? 0 : size;
}

constexpr char kUnbrokenSpace = '\x1f';  // harmless lets no control character into a text
constexpr std::size_t kNameWidth = 13;   // of a detail line

// The column at which the rest of a broken line starts.
std::size_t hanging_indent(std::string_view line) {
  const std::size_t start = std::min(line.find_first_not_of(' '), line.size());
  const std::size_t gap = line.find("  ", start);
  const std::size_t value = gap == line.npos ? gap : line.find_first_not_of(' ', gap);
  if (start == 2 && value != line.npos && value <= start + kNameWidth + 4) return value;
  return start == 2 + kNameWidth ? start : start + (start == 0 ? 4 : 2);
}

void append_folded(std::string_view line, std::size_t width, std::string& out) {
  const std::size_t indent = hanging_indent(line);
  std::size_t used = 0;
  bool is_first = true;
  while (!line.empty()) {
    // The next word with the spaces in front of it.
    const std::size_t word = std::min(line.find_first_not_of(' '), line.size());
    const std::size_t end = std::min(line.find(' ', word), line.size());
    const std::size_t size = columns(line.substr(0, end));
    if (!is_first && used + size > width && word < line.size()) {
      out += "\n" + std::string(indent, ' ');
      used = indent;
      line.remove_prefix(word);
      is_first = true;
      continue;
    }
    out += line.substr(0, end);
    used += size;
    line.remove_prefix(end);
    is_first = false;
  }
}

}  // namespace

std::optional<std::size_t> terminal_width(int descriptor) {
  constexpr std::size_t kLeast = 40;
  struct winsize size {};
  if (::ioctl(descriptor, TIOCGWINSZ, &size) != 0 || size.ws_col == 0) return std::nullopt;
  return std::max<std::size_t>(size.ws_col, kLeast);
}

std::size_t report_width() {
  constexpr std::size_t kMost = 100;
  return std::min(kMost, terminal_width(STDOUT_FILENO).value_or(kMost));
}

std::size_t verdict_width() { return terminal_width(STDOUT_FILENO).value_or(kNoWidth); }

std::size_t message_width() { return terminal_width(STDERR_FILENO).value_or(kNoWidth); }

std::size_t columns(std::string_view text) {
  std::size_t count = 0;
  bool is_in_colour = false;
  for (const char c : text) {
    if (c == '\033') is_in_colour = true;
    if (!is_in_colour && (static_cast<unsigned char>(c) & 0xc0) != 0x80) ++count;
    if (c == 'm') is_in_colour = false;
  }
  return count;
}

std::string unbroken(std::string text) {
  std::replace(text.begin(), text.end(), ' ', kUnbrokenSpace);
  return text;
}

std::string fold(std::string_view text, std::size_t width) {
  std::string out;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::string_view line = text.substr(0, end);
    if (columns(line) <= width)
      out += line;
    else
      append_folded(line, width, out);
    if (end < text.size()) out += '\n';
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  std::replace(out.begin(), out.end(), kUnbrokenSpace, ' ');
  return out;
}

Style style_of_stdout() {
  const char* const no_color = ::getenv("NO_COLOR");
  const char* const terminal = ::getenv("TERM");
  const bool is_refused = (no_color != nullptr && *no_color != '\0') ||
                          (terminal != nullptr && std::string_view(terminal) == "dumb");
  return Style{!is_refused && ::isatty(STDOUT_FILENO) != 0};
}

std::string harmless(std::string_view text) {
  constexpr std::string_view kHex = "0123456789abcdef";
  std::string out;
  while (!text.empty()) {
    const std::size_t size = printable_size(text);
    if (size > 0) {
      out += text.substr(0, size);
      text.remove_prefix(size);
      continue;
    }
    const auto byte = static_cast<unsigned char>(text[0]);
    out += "\\x";
    out += kHex[byte >> 4];
    out += kHex[byte & 15];
    text.remove_prefix(1);
  }
  return out;
}

std::string counted(std::uint64_t count, std::string_view one, std::string_view many) {
  return std::to_string(count) + " " + std::string(count == 1 ? one : many);
}

std::string detail_line(std::string_view name, const std::string& value) {
  return "  " + std::string(name) +
         std::string(kNameWidth - std::min(kNameWidth - 1, name.size()), ' ') + value + "\n";
}

}  // namespace veritope::report
