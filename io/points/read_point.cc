// SPDX-License-Identifier: LGPL-3.0-or-later
#include "io/points/read_point.h"

#include <algorithm>
#include <array>
#include <span>
#include <string>
#include <utility>

#include "io/base/exact_number.h"
#include "io/points/row_text_internal.h"

namespace veritope {
namespace {

using internal::RowParts;

bool is_decimal(std::string_view token) { return token.find_first_of("xX/") == token.npos; }

std::string needs_text(std::size_t dimension) {
  if (dimension == 6) return "a segment has six coordinates, three of each end";
  return std::string("a point has ") + (dimension == 3 ? "three" : "two") + " coordinates";
}

Rational exact_number(std::variant<double, Rational> number) {
  if (const double* const x = std::get_if<double>(&number)) return Rational::from_double(*x);
  return std::get<Rational>(std::move(number));
}

}  // namespace

PointLines::PointLines(Decimals decimals, const ReadLimits& limits, std::size_t dimension)
    : decimals_(decimals),
      dimension_(dimension),
      limits_(limits),
      exact_limits_(limits),
      reader_(limits) {
  exact_limits_.max_exponent = std::min(limits.max_exponent, kMostPointExponent);
}

bool PointLines::read_token(std::string_view token, Number& value, std::string& why) const {
  if (token.size() > kMostTokenBytes)
    return why = internal::quoted_token(token) + " is longer than " +
                 std::to_string(kMostTokenBytes) + " bytes",
           false;
  if (internal::lacks_exponent(token))
    return why = internal::quoted_token(token) +
                 " lacks the exponent of a hexadecimal number, as in 0x1p0",
           false;
  if (decimals_ == Decimals::kNearest && is_decimal(token)) {
    double x = 0;
    const char* p = token.data();
    if (!reader_.read_fast(p, x) || p != token.data() + token.size()) {
      DecimalFault fault = reader_.read_slowly(token, x);
      Rational unused;  // it knows the words for NaN and infinity
      if (fault == DecimalFault::kSyntax) fault = read_exact_decimal(token, limits_, unused);
      if (fault != DecimalFault::kNone)
        return why = internal::number_fault_text(fault, token, limits_), false;
    }
    value = x;
    return true;
  }
  Rational x;
  const DecimalFault fault = read_exact_number(token, exact_limits_, x);
  if (fault != DecimalFault::kNone)
    return why = internal::number_fault_text(fault, token, exact_limits_), false;
  const double near = nearest_double(x);
  if (near - near == 0 && Rational::from_double(near) == x)
    value = near;
  else
    value = std::move(x);
  return true;
}

std::optional<PointLines::Numbers> PointLines::read_numbers(std::string_view line,
                                                            std::optional<PointFault>& fault) {
  const std::size_t start = line.find_first_not_of(" \t");
  if (start == line.npos || line[start] == '#') return std::nullopt;
  const bool is_first = std::exchange(is_first_, false);
  if (is_first && line.starts_with(internal::kByteOrderMark))
    line.remove_prefix(internal::kByteOrderMark.size());
  Numbers out;
  const RowParts parts = internal::split_row(line, std::span(out.tokens).first(dimension_));
  if (is_first && internal::is_row_heading(line, out.tokens, parts)) return std::nullopt;
  for (std::size_t k = 0; k < std::min(parts.count, dimension_); ++k) {
    std::string why;
    if (!read_token(out.tokens[k], out.values[k], why) && !fault)
      fault = PointFault{static_cast<std::size_t>(out.tokens[k].data() - line.data()) + 1,
                         std::move(why)};
  }
  if (!fault && parts.fault != 0)
    fault = PointFault{parts.fault, "a number is missing beside this mark"};
  if (!fault && parts.count != dimension_)
    fault = PointFault{parts.count > dimension_ ? parts.surplus : line.size() + 1,
                       needs_text(dimension_) + ", but there are " + std::to_string(parts.count)};
  if (fault) return std::nullopt;
  return out;
}

std::optional<ReadPoint> PointLines::read(std::string_view line, std::optional<PointFault>& fault) {
  std::optional<Numbers> numbers = read_numbers(line, fault);
  if (!numbers) return std::nullopt;
  auto& values = numbers->values;
  ReadPoint out;
  std::copy_n(numbers->tokens.begin(), 3, out.tokens.begin());
  const auto is_double = [&](std::size_t k) { return std::holds_alternative<double>(values[k]); };
  if (is_double(0) && is_double(1) && is_double(2)) {
    out.point = Vec3d{std::get<double>(values[0]), std::get<double>(values[1]),
                      std::get<double>(values[2])};
    return out;
  }
  ExactPoint exact;
  for (std::size_t k = 0; k < 3; ++k) exact[k] = exact_number(std::move(values[k]));
  out.point = std::move(exact);
  return out;
}

std::optional<std::array<ExactPoint, 2>> PointLines::read_segment(
    std::string_view line, std::optional<PointFault>& fault) {
  std::optional<Numbers> numbers = read_numbers(line, fault);
  if (!numbers) return std::nullopt;
  std::array<ExactPoint, 2> out;
  for (std::size_t k = 0; k < 6; ++k)
    out[k / 3][k % 3] = exact_number(std::move(numbers->values[k]));
  return out;
}

}  // namespace veritope
