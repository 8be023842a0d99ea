// SPDX-License-Identifier: LGPL-3.0-or-later
#include "report/text_style.h"

#include <algorithm>

#include <stdlib.h>
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

}  // namespace

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
  constexpr std::size_t kWidth = 13;
  return "  " + std::string(name) + std::string(kWidth - std::min(kWidth - 1, name.size()), ' ') +
         value + "\n";
}

}  // namespace veritope::report
