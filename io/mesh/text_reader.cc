// SPDX-License-Identifier: LGPL-3.0-or-later
#include "io/mesh/text_reader.h"

namespace veritope {
namespace {

// Words that other programs print for NaN and infinity; the error then says what they mean.
bool names_no_finite_number(std::string_view token) {
  if (token.starts_with('-') || token.starts_with('+')) token.remove_prefix(1);
  return is_word(token, "nan") || is_word(token, "inf") || is_word(token, "infinity") ||
         is_word(token, "nan(ind)") || is_word(token, "1.#ind") || is_word(token, "1.#inf") ||
         is_word(token, "1.#qnan");
}

// "1,5": digits on both sides of one comma.
bool has_decimal_comma(std::string_view token) {
  constexpr std::string_view kDigits = "0123456789";
  if (token.starts_with('-') || token.starts_with('+')) token.remove_prefix(1);
  const std::size_t comma = token.find(',');
  if (comma == token.npos || comma == 0 || comma + 1 == token.size()) return false;
  return token.find_first_not_of(kDigits) == comma &&
         token.find_first_not_of(kDigits, comma + 1) == token.npos;
}

}  // namespace

bool TextReader::fail(const char* at, Code code, std::string message) {
  fault_ = Fault{anchor_ != nullptr ? anchor_ : at, code, std::move(message)};
  return false;
}

Error TextReader::take_error() {
  return error_at_line(source_, fault_->at, fault_->code, std::move(fault_->message));
}

bool TextReader::fail_expected(const char* at, const std::string& expected) {
  const Code code = at >= text_end_ ? Code::kTruncated : Code::kSyntax;
  return fail(at, code, expected + " expected, but there is " + quoted_token(at, text_end_));
}

bool TextReader::fail_faces(const char* at) {
  return fail(at, Code::kOverLimit, over_limit("faces", "--max-faces", limits_.max_faces));
}

bool TextReader::fail_vertices(const char* at) {
  return fail(at, Code::kOverLimit, "more than " + std::to_string(kMaxVertices) + " vertices");
}

bool TextReader::fail_integer(const char* token, const ScannedInteger& value) {
  if (value.is_valid && value.num_digits > limits_.max_digits) {
    return fail(token, Code::kOverLimit,
                over_limit("digits in a number", "--max-digits", limits_.max_digits) + ": " +
                    quoted_token(token, text_end_));
  }
  return fail_expected(token, "an integer");
}

bool TextReader::read_decimal_slowly(const char*& p, double& value) {
  const char* const last = skip_token(p, ends_);
  const std::string_view token(p, static_cast<std::size_t>(last - p));
  const auto over = [&](const char* what, const char* flag, std::uint64_t limit) {
    return fail(p, Code::kOverLimit, over_limit(what, flag, limit) + ": " + quoted(token));
  };
  switch (decimals_.read_slowly(token, value)) {
    case DecimalFault::kNone: p = last; return true;
    case DecimalFault::kSyntax: break;
    case DecimalFault::kNotFinite:
      return fail(p, Code::kNotFinite, "the coordinate " + quoted(token) + " is not finite");
    case DecimalFault::kDigits:
      return over("digits in a number", "--max-digits", limits_.max_digits);
    case DecimalFault::kExponent: {
      const std::string limit = std::to_string(limits_.max_exponent);
      return fail(
          p, Code::kOverLimit,
          "an exponent larger than " + limit + " (--max-exponent " + limit + "): " + quoted(token));
    }
  }
  if (token.empty()) return fail_expected(p, "a decimal number");
  if (names_no_finite_number(token)) {
    return fail(p, Code::kNotFinite, "the coordinate " + quoted(token) + " is not finite");
  }
  return fail(p, Code::kSyntax,
              "a decimal number expected, but there is " + quoted(token) +
                  (has_decimal_comma(token) ? " (a decimal comma?)" : ""));
}

}  // namespace veritope
