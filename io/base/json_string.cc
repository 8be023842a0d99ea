// SPDX-License-Identifier: LGPL-3.0-or-later
#include "io/base/json_string.h"

namespace veritope {

void append_json_string(std::string_view text, std::string& out) {
  constexpr char kHex[] = "0123456789abcdef";
  out += '"';
  for (const char c : text) {
    const auto b = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\') out += '\\';
    if (b < 0x20 || b == 0x7F) {
      out += "\\u00";
      out += {kHex[b >> 4], kHex[b & 15]};
    } else {
      out += c;
    }
  }
  out += '"';
}

}  // namespace veritope
