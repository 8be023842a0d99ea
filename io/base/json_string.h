// SPDX-License-Identifier: LGPL-3.0-or-later
// io/base/json_string.h: texts as strings of JSON.
#pragma once
#include <string>
#include <string_view>

namespace veritope {

/// Appends the text in quotes, with quotes, backslashes and control characters escaped. REQUIRES UTF-8.
void append_json_string(std::string_view text, std::string& out);

}  // namespace veritope
