// SPDX-License-Identifier: Apache-2.0 OR MIT
// json_reader.h: JSON as docs/formats/spline-json.md and docs/formats/chain-files.md use it: strings, lists, objects
// with known keys, a few words. What it does not expect is refused.
#pragma once
#include "star_model.h"

struct JsonReader {
  const std::string& text;
  size_t& at;

  // The text is UTF-8, or refused; at *begin starts what is read.
  JsonReader(const std::string& file, size_t* begin);
  char next() {
    for (; at < text.size(); ++at)
      if (text[at] != ' ' && text[at] != '\n' && text[at] != '\t' && text[at] != '\r')
        return text[at];
    return '\0';
  }
  bool take_if(char c) {
    const bool is = next() == c;
    at += is;
    return is;
  }
  void take(char c) {
    if (!take_if(c)) throw Refused{std::string("expected '") + c + "'"};
  }
  std::string string();
  std::string word() {  // true, false, null, an integer
    next();
    const size_t begin = at;
    while (at < text.size() && (isalnum(uint8_t(text[at])) != 0 || text[at] == '-')) ++at;
    return text.substr(begin, at - begin);
  }
  static bool is_integer(const std::string& w) {
    const size_t sign = !w.empty() && w[0] == '-';
    return w.size() <= kMostWord && is_natural(w.substr(sign));
  }
  int64_t integer() {
    const std::string w = word();
    expect(is_integer(w), "expected an integer");
    return std::stoll(w);
  }
  bool boolean() {
    const std::string w = word();
    expect(w == "true" || w == "false", "expected true or false");
    return w == "true";
  }
  template <class Item>
  void list(Item item) {
    take('[');
    if (take_if(']')) return;
    do item();
    while (take_if(','));
    take(']');
  }
  // Calls value(i) to read the value of keys[i]. The last `optional` keys may be missing.
  template <class Value>
  void object(std::initializer_list<const char*> keys, Value value, size_t optional = 0) {
    uint64_t seen = 0;  // a bit for each key
    take('{');
    if (next() != '}') do {
        next();
        const std::string key = string();
        const size_t i = size_t(std::find(keys.begin(), keys.end(), key) - keys.begin());
        expect(i < keys.size() && (seen >> i & 1) == 0, "a key is unknown or occurs twice");
        seen |= uint64_t(1) << i;
        take(':');
        value(i);
      } while (take_if(','));
    take('}');
    const uint64_t required = (uint64_t(1) << (keys.size() - optional)) - 1;
    expect((seen & required) == required, "a key is missing");
  }

 private:
  uint32_t hexadecimal();
  void escaped(std::string* to);

  static constexpr size_t kMostWord = 15;  // characters of an integer
};
