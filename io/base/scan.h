// SPDX-License-Identifier: LGPL-3.0-or-later
// io/base/scan.h: blanks, line ends, tokens and integers of the reading rule, section 1.
// Every function may read up to 8 bytes after a line end: the text must be padded (io/base/byte_buffer.h).
#pragma once
#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <string_view>

namespace veritope {

inline constexpr std::uint8_t kBlankClass = 1, kEolClass = 2, kHashClass = 4;

inline constexpr std::array<std::uint8_t, 256> kCharClass = [] {
  std::array<std::uint8_t, 256> table{};
  for (const unsigned char c : {' ', '\t', '\v', '\f'}) table[c] = kBlankClass;
  for (const unsigned char c : {'\n', '\r'}) table[c] = kEolClass;
  table['#'] = kHashClass;
  return table;
}();

inline bool has_class(char c, std::uint8_t mask) {
  return (kCharClass[static_cast<unsigned char>(c)] & mask) != 0;
}
inline bool is_blank(char c) { return has_class(c, kBlankClass); }
inline bool is_eol(char c) { return has_class(c, kEolClass); }
inline bool is_digit(char c) { return static_cast<unsigned char>(c - '0') < 10; }

/// What may follow a token: in STL and PLY, and in OBJ and OFF, where # starts a comment.
inline constexpr std::uint8_t kTokenEnd = kBlankClass | kEolClass;
inline constexpr std::uint8_t kTokenEndOrComment = kTokenEnd | kHashClass;

inline const char* skip_blanks(const char* p) {
  while (is_blank(*p)) ++p;
  return p;
}
inline const char* skip_token(const char* p, std::uint8_t ends) {
  while (!has_class(*p, ends)) ++p;
  return p;
}
inline const char* find_eol(const char* p) {
  while (!is_eol(*p)) ++p;
  return p;
}
/// The first character after blanks and line ends; `end` if no other follows.
inline const char* skip_space(const char* p, const char* end) {
  while (p < end && has_class(*p, kTokenEnd)) ++p;
  return p;
}
/// The character after the line end at p; CR LF is one line end.
inline const char* skip_eol(const char* p, const char* end) {
  return p + (*p == '\r' && p + 1 < end && p[1] == '\n' ? 2 : 1);
}

inline std::uint64_t load8(const char* p) {
  static_assert(std::endian::native == std::endian::little, "digit tricks count from the low byte");
  std::uint64_t word;
  std::memcpy(&word, p, 8);
  return word;
}
/// Bit 7 of every byte that is not a digit (bytes above the lowest such byte may be wrong).
inline std::uint64_t non_digits(std::uint64_t word) {
  return (((word ^ 0x3030303030303030) + 0x7676767676767676) | word) & 0x8080808080808080;
}
/// The value of eight digits, the first one in the low byte. REQUIRES non_digits(word) == 0 in these bytes.
inline std::uint64_t eight_digits(std::uint64_t word) {
  word = (word & 0x0F0F0F0F0F0F0F0F) * 2561 >> 8;
  word = (word & 0x00FF00FF00FF00FF) * 6553601 >> 16;
  return (word & 0x0000FFFF0000FFFF) * 42949672960001 >> 32;
}

/// A whole-token integer `[+-]? digits`.
struct ScannedInteger {
  bool is_valid = false;
  bool is_negative = false;
  std::uint32_t num_digits = 0;
  std::uint64_t magnitude = 0;  ///< UINT64_MAX if larger

  /// REQUIRES is_valid. True if 0 <= value < bound.
  bool is_below(std::uint64_t bound) const {
    return (!is_negative || magnitude == 0) && magnitude < bound;
  }
};

/// Reads any number of digits, at `p` after the sign; moves p past them.
ScannedInteger scan_integer_slowly(const char*& p);

/// Moves p past the digits; the caller tests what follows them.
inline ScannedInteger scan_integer(const char*& p) {
  const char* digits = p;
  ScannedInteger result;
  result.is_negative = *digits == '-';
  digits += (*digits == '-' || *digits == '+') ? 1 : 0;
  const std::uint64_t word = load8(digits);
  const std::uint64_t stop = non_digits(word);
  if (stop == 0) {
    const bool negative = result.is_negative;
    p = digits;
    result = scan_integer_slowly(p);
    result.is_negative = negative;
    return result;
  }
  const int length = std::countr_zero(stop) / 8;
  result.is_valid = length > 0;
  result.num_digits = static_cast<std::uint32_t>(length);
  // Zero bytes read as digits 0 in front: no digit is lost.
  result.magnitude = length == 0 ? 0 : eight_digits(word << (64 - 8 * length));
  p = digits + length;
  return result;
}

/// Equal up to the case of ASCII letters. `word` is in lower case.
bool is_word(std::string_view token, std::string_view word);

}  // namespace veritope
