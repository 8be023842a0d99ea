// SPDX-License-Identifier: LGPL-3.0-or-later
// io/splines/spline_json_lexer.h: JSON as our exact text form uses it: strings, lists, objects with known keys; numbers
// as strings.
#pragma once
#include <algorithm>
#include <cstdint>
#include <functional>
#include <initializer_list>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "io/splines/spline_text_reader.h"

namespace veritope {

/// Functions return false after they set the error; take_null returns false without one.
class SplineJsonLexer : public SplineTextReader {
 public:
  SplineJsonLexer(const Source& source, const ReadLimits& limits)
      : SplineTextReader(source, limits) {
    own_tokens_ = "{}[],:\"";
    is_json_ = true;
  }

 protected:
  bool is_next(char c) { return peek() == std::string_view(&c, 1); }
  bool take_char(char c);
  /// Reads a null; false if the next token is something else.
  bool take_null();
  bool read_string(std::string& text);
  /// Adds the character after a backslash, which has been read.
  bool read_escape(std::string& text);
  bool read_bool(bool& value);
  /// Reads a number that consists of digits, up to `most`; `what` names it in messages: "a degree". What is below
  /// `least` is left to the caller; messages name it.
  bool read_natural(const char* what, std::uint64_t most, std::uint64_t& value,
                    std::uint64_t least = 0);
  /// Reads a string that contains a number.
  bool read_exact(Rational& value);
  /// [item, item, ...]
  template <typename Item>
  bool read_list(Item item);
  /// A list of exactly `count` items; item(i) reads item i. `what` names the list in messages: "a knot".
  template <typename Item>
  bool read_counted(const char* what, std::size_t count, Item item);
  /// Reads {"key": value, ...}; value(i) reads the value of keys[i]. All of `keys`, but for the last num_optional ones,
  /// must occur, once each, in any order.
  template <typename Value>
  bool read_object(std::initializer_list<std::string_view> keys, Value value,
                   std::size_t num_optional = 0);
  /// Reads {"key": value, ...}; value(key, at) reads the value of a key whose text is at `at`. No key may occur twice.
  template <typename Value>
  bool read_members(Value value);

 private:
  bool read_hex4(unsigned& code);
};

// ---- bodies

template <typename Item>
bool SplineJsonLexer::read_list(Item item) {
  if (!take_char('[')) return false;
  if (is_next(']')) return ++p_, true;
  for (;;) {
    if (!item()) return false;
    if (is_next(']')) return ++p_, true;
    if (!take_char(',')) return false;
  }
}

template <typename Item>
bool SplineJsonLexer::read_counted(const char* what, std::size_t count, Item item) {
  skip();
  const char* const at = p_;
  std::size_t i = 0;
  const auto wrong = [&](const std::string& has) {
    return fail(at, Code::kSyntax,
                std::string(what) + " must have " + std::to_string(count) + " items, not " + has);
  };
  const bool ok = read_list([&] { return i == count ? wrong("more") : item(i++); });
  return ok && (i == count || wrong(std::to_string(i)));
}

template <typename Value>
bool SplineJsonLexer::read_members(Value value) {
  if (!take_char('{')) return false;
  std::set<std::string, std::less<>> seen;
  for (bool is_first = true; !is_next('}'); is_first = false) {
    if (!is_first && !take_char(',')) return false;
    skip();
    const char* const at = p_;
    std::string key;
    if (!read_string(key) || !take_char(':')) return false;
    if (!seen.insert(key).second)
      return fail(at, Code::kSyntax, "the key " + quoted(key) + " occurs twice");
    if (!value(key, at)) return false;
  }
  return ++p_, true;
}

template <typename Value>
bool SplineJsonLexer::read_object(std::initializer_list<std::string_view> keys, Value value,
                                  std::size_t num_optional) {
  skip();
  const char* const start = p_;
  std::vector<bool> seen(keys.size());
  const bool ok = read_members([&](const std::string& key, const char* at) {
    const auto found = std::find(keys.begin(), keys.end(), key);
    if (found == keys.end()) return fail(at, Code::kSyntax, "unknown key " + quoted(key));
    const auto i = static_cast<std::size_t>(found - keys.begin());
    seen[i] = true;
    return value(i);
  });
  if (!ok) return false;
  for (std::size_t i = 0; i + num_optional < seen.size(); ++i)
    if (!seen[i])
      return fail(start, Code::kSyntax, "the key " + quoted(keys.begin()[i]) + " is missing");
  return true;
}

}  // namespace veritope
