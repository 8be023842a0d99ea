// SPDX-License-Identifier: Apache-2.0 OR MIT
// verify/format/text_parts.h: what texts of certificates share. Internal to verify/format.
#pragma once
#include <algorithm>
#include <cstddef>
#include <functional>
#include <string>

namespace veritope::certificate::internal {

// The values of the flat object in their own order, one a line. Statements hold no escapes and no blanks outside
// strings; a character that is not printable, in a file that is no certificate, becomes '?'.
inline std::string statement_text(const std::string& line) {
  std::string out;
  bool in_string = false;
  for (char c : line) {
    if (c == '"') in_string = !in_string;
    if (!in_string && (c == '{' || c == '}')) continue;
    if (!in_string && c == ',') {
      out += '\n';
    } else if (c == ':' && !in_string) {
      out += ": ";
    } else if (c != '"') {
      out += c >= ' ' && c <= '~' ? c : '?';
    }
  }
  return out + "\n";
}

inline void append_list(std::string& out, const std::string& name, std::size_t size,
                        std::size_t max_items,
                        const std::function<std::string(std::size_t)>& item) {
  out += name + ": " + std::to_string(size) + "\n";
  for (std::size_t i = 0; i < std::min(size, max_items); ++i)
    out += "  " + std::to_string(i) + ": " + item(i) + "\n";
  if (size > max_items) out += "  ... and " + std::to_string(size - max_items) + " more\n";
}

}  // namespace veritope::certificate::internal
