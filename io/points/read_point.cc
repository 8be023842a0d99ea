// SPDX-License-Identifier: LGPL-3.0-or-later
#include "io/points/read_point.h"

#include <algorithm>
#include <utility>

#include "io/base/exact_number.h"

namespace veritope {
namespace {

constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";

bool is_gap(char c) { return c == ' ' || c == '\t'; }
bool is_mark(char c) { return c == ',' || c == ';'; }

struct Split {
  std::array<std::string_view, 6> tokens;
  std::size_t count = 0;    ///< of all tokens, also beyond those of a point
  std::size_t fault = 0;    ///< the column of a mark without a token before or after it; 0: none
  std::size_t surplus = 0;  ///< the column of the first token too many
};

// Between two tokens: gaps with at most one mark.
Split split(std::string_view line, std::size_t most) {
  Split out;
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
    if (out.count < most) out.tokens[out.count] = line.substr(begin, i - begin);
    if (out.count == most) out.surplus = begin + 1;
    ++out.count;
    needs_token = false;
  }
  if (needs_token) out.fault = line.size();
  return out;
}

std::string quoted(std::string_view token) {
  constexpr std::size_t kMostShown = 40;
  std::string out = "'" + std::string(token.substr(0, kMostShown));
  return out + (token.size() > kMostShown ? "...'" : "'");
}

std::string sentence(DecimalFault fault, std::string_view token, const ReadLimits& limits) {
  switch (fault) {
    case DecimalFault::kNotFinite: return quoted(token) + " is not finite";
    case DecimalFault::kDigits:
      return quoted(token) + " has more digits than --max-digits " +
             std::to_string(limits.max_digits);
    case DecimalFault::kExponent:
      return quoted(token) + " has an exponent over --max-exponent " +
             std::to_string(limits.max_exponent);
    default:
      return quoted(token) + " is neither a decimal, nor a fraction, nor a hexadecimal number";
  }
}

bool is_decimal(std::string_view token) { return token.find_first_of("xX/") == token.npos; }

// "0x10" without an exponent is a hexadecimal number elsewhere, but not for the checkers.
bool lacks_exponent(std::string_view token) {
  if (token.starts_with('+') || token.starts_with('-')) token.remove_prefix(1);
  return (token.starts_with("0x") || token.starts_with("0X")) &&
         token.find_first_of("pP") == token.npos;
}

// A line that can only be a heading: printable words that begin with a letter, or with a quotation mark and a letter,
// and that are not names for NaN or infinity.
bool is_heading(std::string_view line, const Split& parts) {
  const auto is_letter = [](char c) {
    return ('a' <= c && c <= 'z') || ('A' <= c && c <= 'Z') || c == '_';
  };
  for (const char c : line)
    if (static_cast<unsigned char>(c) < ' ' && !is_gap(c)) return false;
  for (std::string_view word : parts.tokens) {
    if (word.empty()) break;
    if (word.starts_with('"') || word.starts_with('\'')) word.remove_prefix(1);
    if (word.empty() || !is_letter(word.front())) return false;
    Rational unused;
    if (read_exact_decimal(word, {}, unused) == DecimalFault::kNotFinite) return false;
  }
  return parts.count > 0 && parts.fault == 0;
}

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
    return why = quoted(token) + " is longer than " + std::to_string(kMostTokenBytes) + " bytes",
           false;
  if (lacks_exponent(token))
    return why = quoted(token) + " lacks the exponent of a hexadecimal number, as in 0x1p0", false;
  if (decimals_ == Decimals::kNearest && is_decimal(token)) {
    double x = 0;
    const char* p = token.data();
    if (!reader_.read_fast(p, x) || p != token.data() + token.size()) {
      DecimalFault fault = reader_.read_slowly(token, x);
      Rational unused;  // it knows the words for NaN and infinity
      if (fault == DecimalFault::kSyntax) fault = read_exact_decimal(token, limits_, unused);
      if (fault != DecimalFault::kNone) return why = sentence(fault, token, limits_), false;
    }
    value = x;
    return true;
  }
  Rational x;
  const DecimalFault fault = read_exact_number(token, exact_limits_, x);
  if (fault != DecimalFault::kNone) return why = sentence(fault, token, exact_limits_), false;
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
  if (is_first && line.starts_with(kByteOrderMark)) line.remove_prefix(kByteOrderMark.size());
  const Split parts = split(line, dimension_);
  if (is_first && is_heading(line, parts)) return std::nullopt;
  Numbers out{parts.tokens, {}};
  for (std::size_t k = 0; k < std::min(parts.count, dimension_); ++k) {
    std::string why;
    if (!read_token(parts.tokens[k], out.values[k], why) && !fault)
      fault = PointFault{static_cast<std::size_t>(parts.tokens[k].data() - line.data()) + 1,
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
