// SPDX-License-Identifier: LGPL-3.0-or-later
#include "io/points/read_row.h"

#include <algorithm>
#include <string>
#include <utility>

#include "io/base/exact_number.h"
#include "io/points/row_text_internal.h"

namespace veritope {
namespace {

// What is wrong with the number; nothing if it was read.
std::string read_token(std::string_view token, const ReadLimits& limits, Rational& value) {
  if (token.size() > kMostTokenBytes)
    return internal::quoted_token(token) + " is longer than " + std::to_string(kMostTokenBytes) +
           " bytes";
  if (internal::lacks_exponent(token))
    return internal::quoted_token(token) +
           " lacks the exponent of a hexadecimal number, as in 0x1p0";
  const DecimalFault fault = read_exact_number(token, limits, value);
  return fault == DecimalFault::kNone ? "" : internal::number_fault_text(fault, token, limits);
}

}  // namespace

RowLines::RowLines(std::size_t least, std::size_t most, const ReadLimits& limits)
    : least_(least), most_(most), limits_(limits), tokens_(most) {
  limits_.max_exponent = std::min(limits.max_exponent, kMostPointExponent);
}

std::optional<PointFault> RowLines::count_fault(std::size_t count, std::size_t surplus,
                                                std::size_t end) const {
  const std::string found = ", but there are " + std::to_string(count);
  if (columns_ > 0 && count != columns_)
    return PointFault{
        end, "each line has as many numbers as the first one, " + std::to_string(columns_) + found};
  if (count < least_)
    return PointFault{end, "a line has at least " + std::to_string(least_) + " numbers" + found};
  if (count > most_)
    return PointFault{surplus, "a line has at most " + std::to_string(most_) + " numbers" + found};
  return std::nullopt;
}

std::optional<std::vector<Rational>> RowLines::read(std::string_view line,
                                                    std::optional<PointFault>& fault) {
  const std::size_t start = line.find_first_not_of(" \t");
  if (start == line.npos || line[start] == '#') return std::nullopt;
  const bool is_first = std::exchange(is_first_, false);
  if (is_first && line.starts_with(internal::kByteOrderMark))
    line.remove_prefix(internal::kByteOrderMark.size());
  std::fill(tokens_.begin(), tokens_.end(), std::string_view());
  const internal::RowParts parts = internal::split_row(line, tokens_);
  if (is_first && internal::is_row_heading(line, tokens_, parts)) return std::nullopt;
  std::vector<Rational> row(std::min(parts.count, most_));
  for (std::size_t k = 0; k < row.size() && !fault; ++k)
    if (std::string why = read_token(tokens_[k], limits_, row[k]); !why.empty())
      fault =
          PointFault{static_cast<std::size_t>(tokens_[k].data() - line.data()) + 1, std::move(why)};
  if (!fault && parts.fault != 0)
    fault = PointFault{parts.fault, "a number is missing beside this mark"};
  if (!fault) fault = count_fault(parts.count, parts.surplus, line.size() + 1);
  if (fault) return std::nullopt;
  columns_ = parts.count;
  return row;
}

}  // namespace veritope
