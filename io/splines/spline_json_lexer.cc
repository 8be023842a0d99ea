// SPDX-License-Identifier: LGPL-3.0-or-later
#include "io/splines/spline_json_lexer.h"

#include <algorithm>
#include <cstdint>

namespace veritope {

bool SplineJsonLexer::take_char(char c) {
  if (!is_next(c)) return fail_expected(quoted(std::string_view(&c, 1)));
  ++p_;
  return true;
}

bool SplineJsonLexer::take_null() {
  if (peek() != "null") return false;
  p_ += 4;
  return true;
}

bool SplineJsonLexer::read_hex4(unsigned& code) {
  code = 0;
  for (int i = 0; i < 4; ++i, ++p_) {
    const char c = p_ < source_.end ? *p_ : '\0';
    const int low = c | 0x20;
    const bool is_hex = is_digit(c) || (low >= 'a' && low <= 'f');
    if (!is_hex) return fail(p_, Code::kSyntax, "four hexadecimal digits expected behind \\u");
    code = code * 16 + static_cast<unsigned>(is_digit(c) ? c - '0' : low - 'a' + 10);
  }
  return true;
}

// Reads an escape after its backslash.
bool SplineJsonLexer::read_escape(std::string& text) {
  constexpr std::string_view kFrom = "\"\\/bfnrt", kTo = "\"\\/\b\f\n\r\t";
  if (p_ >= source_.end) return fail(p_, Code::kTruncated, "a string does not end");
  const char c = *p_++;
  if (const std::size_t i = kFrom.find(c); i != kFrom.npos) return text += kTo[i], true;
  unsigned code = 0;
  if (c != 'u') return fail(p_ - 1, Code::kSyntax, "an unknown escape in a string");
  if (!read_hex4(code)) return false;
  if (code >= 0xD800 && code < 0xDC00) {
    unsigned low = 0;
    if (p_ + 1 >= source_.end || p_[0] != '\\' || p_[1] != 'u')
      return fail(p_, Code::kSyntax, "half of a surrogate pair");
    p_ += 2;
    if (!read_hex4(low)) return false;
    if (low < 0xDC00 || low > 0xDFFF) return fail(p_, Code::kSyntax, "half of a surrogate pair");
    code = 0x10000 + ((code - 0xD800) << 10) + (low - 0xDC00);
  } else if (code >= 0xDC00 && code < 0xE000) {
    return fail(p_, Code::kSyntax, "half of a surrogate pair");
  }
  const auto tail = [&](int shift) { return static_cast<char>(0x80 | ((code >> shift) & 0x3F)); };
  if (code < 0x80) {
    text += static_cast<char>(code);
  } else if (code < 0x800) {
    text += {static_cast<char>(0xC0 | (code >> 6)), tail(0)};
  } else if (code < 0x10000) {
    text += {static_cast<char>(0xE0 | (code >> 12)), tail(6), tail(0)};
  } else {
    text += {static_cast<char>(0xF0 | (code >> 18)), tail(12), tail(6), tail(0)};
  }
  return true;
}

bool SplineJsonLexer::read_string(std::string& text) {
  if (!is_next('"')) return fail_expected("a string");
  const char* const start = p_++;
  text.clear();
  bool is_ascii = true;
  for (;;) {
    const char* const run = p_;
    for (; p_ < source_.end && *p_ != '"' && *p_ != '\\' && static_cast<unsigned char>(*p_) >= 0x20;
         ++p_)
      is_ascii &= static_cast<unsigned char>(*p_) < 0x80;
    text.append(run, p_);
    if (p_ >= source_.end) return fail(start, Code::kTruncated, "a string does not end");
    const char c = *p_++;
    if (c == '"') break;
    if (c != '\\') return fail(p_ - 1, Code::kSyntax, "a control character in a string");
    if (!read_escape(text)) return false;
  }
  if (!is_ascii && to_utf8(text) != text)
    return fail(start, Code::kSyntax, "a string is not UTF-8");
  return true;
}

bool SplineJsonLexer::read_bool(bool& value) {
  const std::string_view token = peek();
  if (token != "true" && token != "false") return fail_expected("true or false");
  value = token == "true";
  p_ += token.size();
  return true;
}

bool SplineJsonLexer::read_exact(Rational& value) {
  skip();
  const char* const at = p_;
  std::string text;
  if (!read_string(text)) return false;
  return read_token(at, text, value, read_exact_number);
}

bool SplineJsonLexer::read_natural(const char* what, std::uint64_t most, std::uint64_t& value,
                                   std::uint64_t least) {
  constexpr std::size_t kMostDigits = 18;
  const std::string_view token = peek();
  const bool is_integer = !token.empty() && std::all_of(token.begin(), token.end(), is_digit) &&
                          (token.size() == 1 || token[0] != '0');
  const std::string range = std::string(what) + " must be an integer from " +
                            std::to_string(least) + " to " + std::to_string(most) + ", not ";
  if (token.empty()) return fail_expected(what);
  if (!is_integer) return fail(p_, Code::kSyntax, range + quoted(token));
  value = 0;
  if (token.size() <= kMostDigits)
    for (const char c : token) value = 10 * value + static_cast<std::uint64_t>(c - '0');
  if (token.size() > kMostDigits || value > most)
    return fail(p_, Code::kOverLimit, range + quoted(token));
  p_ += token.size();
  return true;
}

}  // namespace veritope
