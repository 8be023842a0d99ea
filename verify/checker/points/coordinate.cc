// SPDX-License-Identifier: Apache-2.0 OR MIT
// coordinate.cc: tokens of docs/certificates/points.md, section 2, as rational numbers.
#include "coordinate.h"

#include <cstdlib>
#include <cstring>

namespace {

const size_t kLongest = 4096;        // bytes of a token
const int64_t kMostExponent = 4096;  // in absolute value
const int64_t kInfinity = int64_t(0x7ff) << 52;

// A token's digits: of the number without its point, and of the denominator. The number is
// digits / denominator times a power of ten, or of two for a hexadecimal number.
struct Token {
  enum { kDecimal, kHex, kFraction } kind = kDecimal;
  bool neg = false;
  std::string digits, denominator;
  int64_t exponent = 0;  // of ten or of two
};

std::string take_digits(const char** s, bool hex) {
  const char* const begin = *s;
  *s += std::strspn(begin, hex ? "0123456789abcdefABCDEF" : "0123456789");
  return std::string(begin, *s);
}
// The exponent after its letter; without digits, one that is over the limit.
int64_t take_exponent(const char** s) {
  const bool down = **s == '-';
  if (down || **s == '+') ++*s;
  const std::string digits = take_digits(s, false);
  int64_t e = digits.empty() ? kMostExponent + 1 : 0;
  for (char c : digits) e = std::min(10 * e + (c - '0'), kMostExponent + 1);
  return down ? -e : e;
}

// Whether the word is a token; a decimal is read as `exact` has it.
bool read_token(const std::string& word, Token* t) {
  const char* s = word.c_str();
  t->neg = *s == '-';
  if (*s == '-' || *s == '+') ++s;
  const bool hex = s[0] == '0' && (s[1] == 'x' || s[1] == 'X');
  if (hex) s += 2;
  t->digits = take_digits(&s, hex);
  int64_t places = 0;
  if (*s == '/') {
    ++s;
    t->kind = Token::kFraction;
    t->denominator = take_digits(&s, false);
    return !hex && !t->digits.empty() && t->denominator.find_first_not_of('0') != word.npos &&
           s == word.c_str() + word.size();
  }
  if (*s == '.') {
    const std::string after = take_digits(&++s, hex);
    t->digits += after;
    places = int64_t(after.size());
  }
  if (hex ? *s == 'p' || *s == 'P' : *s == 'e' || *s == 'E')
    t->exponent = take_exponent(&++s);
  else if (hex)
    return false;
  if (std::abs(t->exponent) > kMostExponent) return false;
  t->kind = hex ? Token::kHex : Token::kDecimal;
  t->exponent -= hex ? 4 * places : places;
  return !t->digits.empty() && s == word.c_str() + word.size();
}

Nat natural(const std::string& digits, bool hex) {
  Nat r;
  const size_t most = hex ? 7 : 9;  // as many digits as are always below 2^32
  for (size_t i = 0; i < digits.size();) {
    uint32_t power = 1, value = 0;
    for (const size_t end = std::min(i + most, digits.size()); i < end; ++i) {
      const char c = digits[i];
      power *= hex ? 16 : 10;
      value = value * (hex ? 16 : 10) + uint32_t(c <= '9' ? c - '0' : (c | 32) - 'a' + 10);
    }
    multiply_add(&r, power, value);
  }
  return r;
}
void multiply_by_fives(Nat* a, int64_t fives) {
  for (; fives > 0; fives -= 13) {
    uint32_t power = 1;  // 5^min(fives, 13) < 2^32
    for (int64_t i = 0; i < fives && i < 13; ++i) power *= 5;
    multiply_add(a, power, 0);
  }
}

// The key of the greatest finite binary64 number that is not above n / d 2^twos. REQUIRES n != 0.
int64_t key_below(Nat n, Nat d, int64_t twos, bool* exact) {
  const int64_t lead = bits(n) - bits(d);  // 2^(lead - 1) < n / d < 2^(lead + 1)
  *exact = false;
  if (lead + twos > 1024) return kInfinity - 1;
  if (lead + twos < -1075) return 0;
  if (lead >= -1)
    d = shifted(d, lead + 1);
  else
    n = shifted(n, -lead - 1);
  uint64_t m = 0;  // n / d is now between 1/4 and 1, and m becomes its first 56 bits
  for (int i = 0; i < 56; ++i) {
    multiply_add(&n, 2, 0);
    const bool fits = !is_less(n, d);
    if (fits) subtract(&n, d);
    m = 2 * m + uint64_t(fits);
  }
  const int64_t x = twos + lead - 55;  // m 2^x is the number, rounded down
  const int64_t drop = std::max<int64_t>(bit_length(m) - 53, -1074 - x);  // at most 56
  const uint64_t kept = m >> drop;
  const int64_t key = int64_t(kept + (uint64_t(x + drop + 1074) << 52));
  *exact = n.empty() && kept << drop == m && key < kInfinity;
  return std::min(key, kInfinity - 1);
}

// Fills in the keys of a number that is not 0.
void find_keys(Coordinate* c) {
  bool exact = false;
  c->below = key_below(c->n.m, c->d, c->twos, &exact);
  c->above = exact ? c->below : c->below + 1;
  if (c->n.neg) c->below = -c->below, c->above = -c->above, std::swap(c->below, c->above);
}

}  // namespace

bool is_coordinate(const std::string& word, bool nearest) {
  Token token;
  int64_t key = 0;
  if (word.size() > kLongest) return false;
  if (nearest && decimal_to_key(word, &key)) return true;
  return read_token(word, &token) && !(nearest && token.kind == Token::kDecimal);
}

Coordinate coordinate(const std::string& word, bool nearest) {
  int64_t key = 0;
  if (nearest && decimal_to_key(word, &key)) return coordinate_of(key);
  Token token;
  read_token(word, &token);
  const bool hex = token.kind == Token::kHex;
  Coordinate c;
  c.n.m = natural(token.digits, hex);
  if (c.n.m.empty()) return coordinate_of(0);
  c.n.neg = token.neg;
  c.d = token.kind == Token::kFraction ? natural(token.denominator, false) : Nat(1, 1);
  c.twos = token.exponent;
  if (token.kind == Token::kDecimal) {
    multiply_by_fives(&c.n.m, token.exponent);
    multiply_by_fives(&c.d, -token.exponent);
  }
  find_keys(&c);
  return c;
}
Coordinate coordinate_of(int64_t key) {
  Coordinate c;
  c.below = c.above = key;
  c.d = Nat(1, 1);
  c.n.m = {uint32_t(key_mantissa(key)), uint32_t(key_mantissa(key) >> 32)};
  drop_zeros(&c.n.m);
  c.n.neg = key < 0;
  c.twos = key_exponent(key) - 1075;
  return c;
}
Coordinate coordinate_of(const Integer& n, const Nat& d) {
  if (n.m.empty()) return coordinate_of(0);
  Coordinate c;
  c.n = n, c.d = d, c.twos = 0;
  find_keys(&c);
  return c;
}
