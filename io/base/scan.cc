// SPDX-License-Identifier: LGPL-3.0-or-later
#include "io/base/scan.h"

namespace veritope {

ScannedInteger scan_integer_slowly(const char*& p) {
  ScannedInteger result;
  const char* first = p;
  for (; is_digit(*p); ++p) {
    const auto digit = static_cast<std::uint64_t>(*p - '0');
    const bool fits = result.magnitude <= (UINT64_MAX - digit) / 10;
    result.magnitude = fits ? result.magnitude * 10 + digit : UINT64_MAX;
  }
  result.is_valid = p > first;
  const auto length = static_cast<std::uint64_t>(p - first);
  result.num_digits = length < UINT32_MAX ? static_cast<std::uint32_t>(length) : UINT32_MAX;
  return result;
}

bool is_word(std::string_view token, std::string_view word) {
  if (token.size() != word.size()) return false;
  for (std::size_t i = 0; i < word.size(); ++i) {
    const char c = token[i];
    if ((c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c) != word[i]) return false;
  }
  return true;
}

}  // namespace veritope
