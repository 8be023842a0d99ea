// SPDX-License-Identifier: LGPL-3.0-or-later
#include "io/splines/spline_text_reader.h"

#include <algorithm>

#include "io/base/read_limits.h"

namespace veritope {
namespace {

// The length of a well-formed UTF-8 sequence at i (RFC 3629), or 0.
std::size_t utf8_length(std::string_view s, std::size_t i) {
  const auto byte = [&](std::size_t k) {
    return i + k < s.size() ? static_cast<unsigned char>(s[i + k]) : 0u;
  };
  const auto is_tail = [&](std::size_t k) { return (byte(k) & 0xC0u) == 0x80u; };
  const unsigned b = byte(0);
  if (b < 0x80) return 1;
  if (b >= 0xC2 && b < 0xE0) return is_tail(1) ? 2 : 0;
  if (b >= 0xE0 && b < 0xF0) {
    if (!is_tail(1) || !is_tail(2)) return 0;
    if ((b == 0xE0 && byte(1) < 0xA0) || (b == 0xED && byte(1) >= 0xA0)) return 0;
    return 3;
  }
  if (b >= 0xF0 && b < 0xF5) {
    if (!is_tail(1) || !is_tail(2) || !is_tail(3)) return 0;
    if ((b == 0xF0 && byte(1) < 0x90) || (b == 0xF4 && byte(1) >= 0x90)) return 0;
    return 4;
  }
  return 0;
}

bool is_utf8(std::string_view text) {
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t length = utf8_length(text, i);
    if (length == 0) return false;
    i += length;
  }
  return true;
}

bool is_json_space(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }

}  // namespace

std::string to_utf8(std::string_view text) {
  if (is_utf8(text)) return std::string(text);
  std::string out;
  for (const char c : text) {
    const auto b = static_cast<unsigned char>(c);
    if (b < 0x80) {
      out += c;
    } else {
      out += {static_cast<char>(0xC0 | (b >> 6)), static_cast<char>(0x80 | (b & 0x3F))};
    }
  }
  return out;
}

std::uint64_t SplineTextReader::line_of(const char* at) {
  if (counted_ == nullptr || at < counted_) {
    counted_ = source_.begin;
    line_ = 1;
  }
  for (; counted_ < at; ++counted_) {
    const bool crlf = *counted_ == '\r' && counted_ + 1 < source_.end && counted_[1] == '\n';
    line_ += *counted_ == '\n' || (*counted_ == '\r' && !crlf) ? 1 : 0;
  }
  return line_;
}

Place SplineTextReader::place_of(const char* at) {
  Place place;
  place.file = *source_.name;
  place.line = line_of(at);
  place.entity = entity_;
  return place;
}

SplineEntity SplineTextReader::begin_entity(const char* at) {
  entity_ = model_.entities.size();
  return {ExactCurve({KnotAxis<Rational>{1, bezier_knots(1)}}, 0, false, {}), {}, {}, place_of(at)};
}

bool SplineTextReader::end_entity(SplineEntity entity) {
  model_.entities.push_back(std::move(entity));
  entity_.reset();
  return true;
}

bool SplineTextReader::fail(const char* at, Code code, std::string message) {
  if (!error_) error_ = Error{code, place_of(at), std::move(message)};
  return false;
}

bool SplineTextReader::fail_expected(const std::string& expected) {
  skip();
  const std::string_view token = peek();
  return fail(p_, token.empty() ? Code::kTruncated : Code::kSyntax,
              expected + " expected, but there is " +
                  (token.empty() ? std::string("the end of the file") : quoted(token)));
}

Error SplineTextReader::take_error() { return std::move(*error_); }

void SplineTextReader::skip() {
  for (;;) {
    while (p_ < source_.end && (is_json_ ? is_json_space(*p_) : has_class(*p_, kTokenEnd))) ++p_;
    if (!has_comments_ || p_ >= source_.end || *p_ != '#') return;
    p_ = find_eol(p_);
    if (p_ > source_.end) p_ = source_.end;
  }
}

std::string_view SplineTextReader::peek() {
  skip();
  if (p_ >= source_.end) return {};
  // skip() stops at VT and FF in JSON: each of them is a token that nothing expects.
  if (own_tokens_.find(*p_) != own_tokens_.npos || has_class(*p_, kTokenEnd)) return {p_, 1};
  const char* last = p_;
  while (last < source_.end && !has_class(*last, ends_) &&
         own_tokens_.find(*last) == own_tokens_.npos)
    ++last;
  return {p_, static_cast<std::size_t>(last - p_)};
}

ReadLimits SplineTextReader::within_default(ReadLimits limits) {
  limits.max_digits = std::min(limits.max_digits, ReadLimits().max_digits);
  limits.max_exponent = std::min(limits.max_exponent, ReadLimits().max_exponent);
  return limits;
}

Error SplineTextReader::limit_error(const char* at, std::string_view token, DecimalFault fault,
                                    const ReadLimits& limits) {
  const std::string limit = std::to_string(limits.max_exponent);
  const std::string what =
      fault == DecimalFault::kDigits
          ? over_limit("digits in a number", "--max-digits", limits.max_digits)
          : "an exponent larger than " + limit + " (--max-exponent " + limit + ")";
  return {Code::kOverLimit, place_of(at), what + ": " + quoted(token)};
}

void SplineTextReader::note_long(const char* at, std::string_view token,
                                 DecimalFault (*read)(std::string_view, const ReadLimits&,
                                                      Rational&)) {
  const bool are_known =
      known_.max_digits == limits_.max_digits && known_.max_exponent == limits_.max_exponent;
  if (are_known || beyond_default_limits_) return;
  Rational ignored;
  const DecimalFault fault = read(token, known_, ignored);
  if (fault == DecimalFault::kDigits || fault == DecimalFault::kExponent)
    beyond_default_limits_ = limit_error(at, token, fault, known_);
}

bool SplineTextReader::read_token(const char* at, std::string_view token, Rational& value,
                                  DecimalFault (*read)(std::string_view, const ReadLimits&,
                                                       Rational&)) {
  // 10^e has more than 3 e bits, so a larger exponent exceeds the budget before it is written out.
  ReadLimits limits = limits_;
  const std::uint64_t affordable = budget_.left() * 8 / 3 + 1;
  limits.max_exponent =
      static_cast<std::uint32_t>(std::min<std::uint64_t>(limits.max_exponent, affordable));
  const auto over_budget = [&] {
    return fail(at, Code::kOverLimit, budget_.message() + ": " + quoted(token));
  };
  const DecimalFault fault = read(token, limits, value);
  switch (fault) {
    case DecimalFault::kNone:
      note_long(at, token, read);
      return budget_.spend(value) || over_budget();
    case DecimalFault::kSyntax: break;
    case DecimalFault::kNotFinite:
      return fail(at, Code::kNotFinite, "the number " + quoted(token) + " is not finite");
    case DecimalFault::kDigits:
    case DecimalFault::kExponent:
      if (fault == DecimalFault::kExponent && limits.max_exponent < limits_.max_exponent)
        return over_budget();
      if (!error_) error_ = limit_error(at, token, fault, limits_);
      return false;
  }
  return fail(at, Code::kSyntax, "a number expected, but there is " + quoted(token));
}

bool SplineTextReader::read_number(Rational& value) {
  const std::string_view token = peek();
  if (token.empty()) return fail_expected("a number");
  if (!read_token(p_, token, value, read_exact_decimal)) return false;
  p_ += token.size();
  return true;
}

bool SplineTextReader::read_all(std::vector<Rational>& into) {
  for (Rational& x : into)
    if (!read_number(x)) return false;
  return true;
}

bool SplineTextReader::charge(const char* at, const Rational& value) {
  return budget_.spend(value) ||
         fail(at, Code::kOverLimit, budget_.message() + ", with those made of them");
}

bool SplineTextReader::multiply(const char* at, Rational& x, const Rational& factor) {
  budget_.give_back(NumberBudget::bytes_of(x));
  x *= factor;
  return charge(at, x);
}

bool SplineTextReader::charge_repeated(const char* at, const std::vector<Rational>& points,
                                       std::span<const bool> is_periodic) {
  std::uint64_t copies = 1;
  for (const bool is : is_periodic) copies *= is ? 2 : 1;
  for (std::uint64_t i = 1; i < copies; ++i)
    for (const Rational& x : points)
      if (!charge(at, x)) return false;
  return true;
}

bool SplineTextReader::read_integer(const char* what, std::int64_t& value) {
  const std::string_view token = peek();
  const char* q = p_;
  if (token.empty()) return fail_expected(what);
  const ScannedInteger scanned = scan_integer(q);
  if (!scanned.is_valid || q != token.data() + token.size()) return fail_expected(what);
  if (scanned.magnitude > std::uint64_t{1} << 62)
    return fail(p_, Code::kOverLimit, std::string(what) + " is too large: " + quoted(token));
  value = static_cast<std::int64_t>(scanned.magnitude);
  if (scanned.is_negative) value = -value;
  p_ = q;
  return true;
}

bool SplineTextReader::read_count(const char* what, std::uint64_t least, std::uint64_t most,
                                  std::uint64_t& value) {
  skip();
  const char* const at = p_;
  std::int64_t number = 0;
  if (!read_integer(what, number)) return false;
  if (number < 0 || static_cast<std::uint64_t>(number) < least ||
      static_cast<std::uint64_t>(number) > most)
    return fail(
        at,
        number > 0 && static_cast<std::uint64_t>(number) > most ? Code::kOverLimit : Code::kSyntax,
        std::string(what) + " must be from " + std::to_string(least) + " to " +
            std::to_string(most) + ", not " + std::to_string(number));
  value = static_cast<std::uint64_t>(number);
  return true;
}

bool SplineTextReader::check_announced(std::uint64_t count, const char* what) {
  if (count <= bytes_left() / 2 + 1) return true;
  return fail(p_, Code::kTruncated,
              std::to_string(count) + " " + what + " are announced, but only " +
                  std::to_string(bytes_left()) + " bytes follow");
}

void SplineTextReader::leave_out(std::string what, std::string reason, bool is_geometry,
                                 std::uint64_t count) {
  const auto [at, is_new] = left_out_index_.emplace(std::pair{what, reason}, left_out_.size());
  if (is_new) left_out_.push_back({std::move(what), std::move(reason), is_geometry, 0});
  left_out_[at->second].count += count;
}

}  // namespace veritope
