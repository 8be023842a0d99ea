// SPDX-License-Identifier: Apache-2.0 OR MIT
// verify/format/statement_line_internal.h: where the statement of a certificate ends.
#pragma once
#include <algorithm>
#include <cstddef>
#include <optional>
#include <span>
#include <string>

namespace veritope::certificate::internal {

// The first line of `bytes` without its line feed; nullopt, with the reason in `why`, if no line feed follows the
// longest statement that is allowed.
inline std::optional<std::string> statement_line(std::span<const unsigned char> bytes,
                                                 std::string& why) {
  constexpr std::size_t kMaxStatement = 64 << 10;
  const auto head = bytes.first(std::min(bytes.size(), kMaxStatement + 1));
  const auto end = std::find(head.begin(), head.end(), static_cast<unsigned char>('\n'));
  if (end != head.end()) return std::string(head.begin(), end);
  why = "no line feed in the first 64 KiB: a certificate starts with one line of JSON";
  return std::nullopt;
}

}  // namespace veritope::certificate::internal
