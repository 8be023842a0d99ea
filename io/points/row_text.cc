// SPDX-License-Identifier: LGPL-3.0-or-later
#include <string>

#include "io/base/exact_number.h"
#include "io/points/row_text_internal.h"

namespace veritope::internal {
namespace {

bool is_gap(char c) { return c == ' ' || c == '\t'; }
bool is_mark(char c) { return c == ',' || c == ';'; }

}  // namespace

RowParts split_row(std::string_view line, std::span<std::string_view> tokens) {
  RowParts out;
  std::size_t i = 0;
  bool needs_token = false;
  for (;;) {
    while (i < line.size() && is_gap(line[i])) ++i;
    if (i == line.size()) break;
    if (is_mark(line[i])) {
      if (out.count == 0 || needs_token) {
        out.fault = i + 1;
        return out;
      }
      needs_token = true;
      ++i;
      continue;
    }
    const std::size_t begin = i;
    while (i < line.size() && !is_gap(line[i]) && !is_mark(line[i])) ++i;
    if (out.count < tokens.size()) tokens[out.count] = line.substr(begin, i - begin);
    if (out.count == tokens.size()) out.surplus = begin + 1;
    ++out.count;
    needs_token = false;
  }
  if (needs_token) out.fault = line.size();
  return out;
}

std::string quoted_token(std::string_view token) {
  constexpr std::size_t kMostShown = 40;
  std::string out = "'" + std::string(token.substr(0, kMostShown));
  return out + (token.size() > kMostShown ? "...'" : "'");
}

std::string number_fault_text(DecimalFault fault, std::string_view token,
                              const ReadLimits& limits) {
  switch (fault) {
    case DecimalFault::kNotFinite: return quoted_token(token) + " is not finite";
    case DecimalFault::kDigits:
      return quoted_token(token) + " has more digits than --max-digits " +
             std::to_string(limits.max_digits);
    case DecimalFault::kExponent:
      return quoted_token(token) + " has an exponent over --max-exponent " +
             std::to_string(limits.max_exponent);
    default:
      return quoted_token(token) +
             " is neither a decimal, nor a fraction, nor a hexadecimal number";
  }
}

bool lacks_exponent(std::string_view token) {
  if (token.starts_with('+') || token.starts_with('-')) token.remove_prefix(1);
  return (token.starts_with("0x") || token.starts_with("0X")) &&
         token.find_first_of("pP") == token.npos;
}

bool is_row_heading(std::string_view line, std::span<const std::string_view> tokens,
                    const RowParts& parts) {
  const auto is_letter = [](char c) {
    return ('a' <= c && c <= 'z') || ('A' <= c && c <= 'Z') || c == '_';
  };
  for (const char c : line)
    if (static_cast<unsigned char>(c) < ' ' && !is_gap(c)) return false;
  for (std::string_view word : tokens) {
    if (word.empty()) break;
    if (word.starts_with('"') || word.starts_with('\'')) word.remove_prefix(1);
    if (word.empty() || !is_letter(word.front())) return false;
    Rational unused;
    if (read_exact_decimal(word, {}, unused) == DecimalFault::kNotFinite) return false;
  }
  return parts.count > 0 && parts.fault == 0;
}

}  // namespace veritope::internal
