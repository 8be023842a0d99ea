// SPDX-License-Identifier: LGPL-3.0-or-later
// io/points/row_text_internal.h: lines of numbers, as section 2 of docs/certificates/points.md has them.
#pragma once
#include <cstddef>
#include <span>
#include <string>
#include <string_view>

#include "io/base/decimal.h"
#include "io/base/read_limits.h"

namespace veritope::internal {

inline constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";

struct RowParts {
  std::size_t count = 0;    ///< of all tokens, also beyond those that were wanted
  std::size_t fault = 0;    ///< the column of a mark without a token before or after it; 0: none
  std::size_t surplus = 0;  ///< the column of the first token too many
};

/// The first tokens of a line. Between two tokens are gaps with at most one mark.
RowParts split_row(std::string_view line, std::span<std::string_view> tokens);

/// A line that can only be a heading: printable words that begin with a letter, or with a quotation mark and a letter,
/// and that are not names for NaN or infinity. @param tokens  the first ones; an empty one ends them
bool is_row_heading(std::string_view line, std::span<const std::string_view> tokens,
                    const RowParts& parts);

/// The token in quotation marks, shortened.
std::string quoted_token(std::string_view token);
/// What is wrong with a number.
std::string number_fault_text(DecimalFault fault, std::string_view token, const ReadLimits& limits);
/// "0x10" without an exponent is a hexadecimal number elsewhere, but not for the checkers.
bool lacks_exponent(std::string_view token);

}  // namespace veritope::internal
