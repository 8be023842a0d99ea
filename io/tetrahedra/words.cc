// SPDX-License-Identifier: LGPL-3.0-or-later
#include "io/tetrahedra/words.h"

#include <charconv>
#include <utility>

#include "io/base/exact_number.h"
#include "io/base/scan.h"

namespace veritope {

Words::Words(const Source& source, const ReadLimits& limits)
    : source_(source), limits_(limits), at_(skip_byte_order_mark(source)), stop_(at_) {}

bool Words::has_word() {
  if (is_failed_) return false;
  if (at_ != stop_) return true;
  for (at_ = skip_space(at_, source_.end); at_ < source_.end && *at_ == '#';)
    at_ = skip_space(find_eol(at_), source_.end);
  stop_ = at_ < source_.end ? skip_token(at_, kTokenEndOrComment) : at_;
  return at_ < source_.end;
}

bool Words::has_word_in_line() {
  if (is_failed_) return false;
  if (at_ != stop_) return true;
  at_ = skip_blanks(at_);
  stop_ = at_;
  if (at_ >= source_.end || has_class(*at_, kEolClass | kHashClass)) return false;
  stop_ = skip_token(at_, kTokenEndOrComment);
  return true;
}

void Words::skip_line() {
  if (!is_failed_ && at_ < source_.end) at_ = stop_ = find_eol(at_);
}

bool Words::fail(Code code, std::string message) {
  if (!is_failed_) error_ = error_at_line(source_, at_, code, std::move(message));
  is_failed_ = true;
  return false;
}

bool Words::need_word(const char* what) {
  if (has_word()) return true;
  return fail(Code::kTruncated, std::string("the file ends where ") + what + " is expected");
}

bool Words::skip_words(std::uint64_t count) {
  for (; count > 0; --count) {
    if (!need_word("another number")) return false;
    skip_word();
  }
  return true;
}

bool Words::take_integer(const char* what, std::uint64_t least, std::uint64_t most,
                         std::uint64_t& value) {
  if (!need_word(what)) return false;
  const auto [end, error] = std::from_chars(at_, stop_, value);
  if (end != stop_ || (error != std::errc() && error != std::errc::result_out_of_range))
    return fail(Code::kSyntax,
                std::string(what) + " is a number without sign, not " + quoted(word()));
  if (error != std::errc() || value < least || value > most)
    return fail(Code::kIndexOutOfRange, std::string(what) + " must be from " +
                                            std::to_string(least) + " to " + std::to_string(most) +
                                            ", not " + escaped(word()));
  skip_word();
  return true;
}

bool Words::take_number(const char* what, Rational& value) {
  if (!need_word(what)) return false;
  switch (read_exact_decimal(word(), limits_, value)) {
    case DecimalFault::kNone: break;
    case DecimalFault::kNotFinite:
      return fail(Code::kNotFinite, std::string(what) + " is not finite: " + quoted(word()));
    case DecimalFault::kDigits:
      return fail(Code::kOverLimit, over_limit("digits", "--max-digits", limits_.max_digits));
    case DecimalFault::kExponent:
      return fail(Code::kOverLimit, "an exponent beyond " + std::to_string(limits_.max_exponent) +
                                        " (--max-exponent " + std::to_string(limits_.max_exponent) +
                                        ")");
    default:
      return fail(Code::kSyntax, std::string(what) + " must be a number, not " + quoted(word()));
  }
  skip_word();
  return true;
}

bool Words::take_point(std::array<Rational, 3>& point) {
  return take_number("a coordinate", point[0]) && take_number("a coordinate", point[1]) &&
         take_number("a coordinate", point[2]);
}

}  // namespace veritope
