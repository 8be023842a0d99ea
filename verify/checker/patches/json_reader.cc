// SPDX-License-Identifier: Apache-2.0 OR MIT
#include "json_reader.h"

namespace {

bool is_utf8(const std::string& s) {
  for (size_t i = 0; i < s.size();) {
    const uint8_t c = uint8_t(s[i++]);
    if (c < 0x80) continue;
    if (c < 0xc0 || c >= 0xf8) return false;
    const int more = c >= 0xf0 ? 3 : c >= 0xe0 ? 2 : 1;
    uint32_t v = c & (0x3fu >> more);
    for (int k = 0; k < more; ++k, ++i) {
      if (i == s.size() || uint8_t(s[i]) >> 6 != 2) return false;
      v = v << 6 | (uint8_t(s[i]) & 0x3f);
    }
    const uint32_t least = more == 3 ? 0x10000 : more == 2 ? 0x800 : 0x80;
    if (v < least || v > 0x10ffff || v >> 11 == 0x1b) return false;
  }
  return true;
}

}  // namespace

JsonReader::JsonReader(const std::string& file, size_t* begin) : text(file), at(*begin) {
  expect(is_utf8(file), "the file is not UTF-8");
}

uint32_t JsonReader::hexadecimal() {  // four digits
  uint32_t v = 0;
  for (int i = 0; i < 4; ++i, ++at) {
    const int c = at < text.size() ? tolower(uint8_t(text[at])) : 0;
    expect(isxdigit(c) != 0, "no four hexadecimal digits behind \\u");
    v = 16 * v + uint32_t(isdigit(c) != 0 ? c - '0' : c - 'a' + 10);
  }
  return v;
}

void JsonReader::escaped(std::string* to) {  // after a backslash
  static const std::string kFrom = "\"\\/bfnrt", kTo = "\"\\/\b\f\n\r\t";
  const char c = at < text.size() ? text[at++] : '\0';
  const size_t known = kFrom.find(c);
  if (known != kFrom.npos) return to->push_back(kTo[known]);
  expect(c == 'u', "an unknown escape in a string");
  uint32_t v = hexadecimal();
  if (v >> 10 == 0x36) {
    expect(text.compare(at, 2, "\\u") == 0, "half of a surrogate pair");
    at += 2;
    const uint32_t low = hexadecimal();
    expect(low >> 10 == 0x37, "half of a surrogate pair");
    v = 0x10000 + ((v & 0x3ff) << 10) + (low & 0x3ff);
  }
  expect(v >> 10 != 0x37, "half of a surrogate pair");
  const int more = v < 0x80 ? 0 : v < 0x800 ? 1 : v < 0x10000 ? 2 : 3;  // bytes after the first
  const uint32_t first[] = {0, 0xc0, 0xe0, 0xf0};
  to->push_back(char(first[more] | v >> 6 * more));
  for (int k = more; k-- > 0;) to->push_back(char(0x80 | (v >> 6 * k & 0x3f)));
}

std::string JsonReader::string() {
  std::string r;
  take('"');
  for (;;) {
    expect(at < text.size(), "a string does not end");
    const char c = text[at++];
    if (c == '"') return r;
    expect(uint8_t(c) >= 32, "a control character in a string");
    if (c == '\\')
      escaped(&r);
    else
      r += c;
  }
}
