// SPDX-License-Identifier: LGPL-3.0-or-later
#include "cli/text_style.h"

#include <stdlib.h>
#include <unistd.h>

namespace veritope::cli {

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
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte >= 32 && byte != 127) {
      out += c;
    } else {
      out += "\\x";
      out += kHex[byte >> 4];
      out += kHex[byte & 15];
    }
  }
  return out;
}

std::string counted(std::uint64_t count, std::string_view one, std::string_view many) {
  return std::to_string(count) + " " + std::string(count == 1 ? one : many);
}

}  // namespace veritope::cli
