// SPDX-License-Identifier: Apache-2.0 OR MIT
// numbers.h: decimals and binary64 numbers without floating-point values. A finite binary64 is held
// as its key: its sign times its other 63 bits. Keys compare like the numbers; both zeros are 0.
#pragma once
#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

__extension__ typedef unsigned __int128 u128;

inline int bit_length(uint64_t v) { return v == 0 ? 0 : 64 - __builtin_clzll(v); }
inline uint64_t magnitude(int64_t v) { return v < 0 ? 0 - uint64_t(v) : uint64_t(v); }

// The binary64 of a key is +-mantissa * 2^(exponent - 1075), mantissa < 2^53, exponent >= 1.
inline int key_exponent(int64_t key) { return std::max(1, int(magnitude(key) >> 52)); }
inline uint64_t key_mantissa(int64_t key) {
  return magnitude(key) - (uint64_t(key_exponent(key) - 1) << 52);
}

// The key of m * 2^x (plus less than 2^x if sticky; then m >= 2^54) rounded to nearest, ties to
// even; false if that is infinity.
inline bool round_to_key(uint64_t m, bool sticky, int64_t x, int64_t* key) {
  *key = 0;
  if (m == 0) return true;
  const int up = 64 - bit_length(m);
  m <<= up, x -= up;                                       // now m >= 2^63
  if (x > 960) return false;                               // at least 2^1024
  if (x < -1138) return true;                              // below 2^-1075
  const int drop = int(std::max<int64_t>(11, -1074 - x));  // keep 53 bits, or whole 2^-1074
  uint64_t kept = drop == 64 ? 0 : m >> drop;
  const uint64_t rest = drop == 64 ? m : m << (64 - drop), half = uint64_t(1) << 63;
  if (rest > half || (rest == half && (sticky || kept % 2 != 0))) ++kept;
  *key = int64_t(kept + (uint64_t(x + drop + 1074) << 52));  // also right if kept became 2^53
  return *key < int64_t(0x7ff) << 52;
}

typedef std::vector<uint32_t> Nat;  // least significant digit first, the last one is not 0

inline void multiply_add(Nat* a, uint32_t factor, uint32_t carry) {
  for (uint32_t& digit : *a) {
    const uint64_t t = uint64_t(digit) * factor + carry;
    digit = uint32_t(t);
    carry = uint32_t(t >> 32);
  }
  if (carry != 0) a->push_back(carry);
}
inline uint32_t divide(Nat* a, uint32_t by) {  // leaves the quotient, returns the remainder
  uint64_t rest = 0;
  for (size_t i = a->size(); i-- > 0; rest %= by) {
    rest = rest << 32 | (*a)[i];
    (*a)[i] = uint32_t(rest / by);
  }
  while (!a->empty() && a->back() == 0) a->pop_back();
  return uint32_t(rest);
}

inline Nat product(const Nat& a, const Nat& b) {
  Nat r(a.size() + b.size(), 0);
  for (size_t i = 0; i < a.size(); ++i) {
    uint64_t carry = 0;
    for (size_t j = 0; j < b.size(); ++j, carry >>= 32) {
      carry += uint64_t(a[i]) * b[j] + r[i + j];
      r[i + j] = uint32_t(carry);
    }
    r[i + b.size()] = uint32_t(carry);
  }
  while (!r.empty() && r.back() == 0) r.pop_back();
  return r;
}

// The key of a whole token `[+-]? (digits [. digits?] | . digits) ([eE] [+-]? digits)?`.
inline bool decimal_to_key(const std::string& token, int64_t* key) {
  const char *s = token.data(), *const end = s + token.size();
  const bool below = s != end && *s == '-';
  if (s != end && (*s == '+' || *s == '-')) ++s;
  Nat num;          // the digits; |value| = (num, plus less than one if sticky) * 10^ten
  int64_t ten = 0;  // `size` counts the digits after the leading zeros
  int size = 0;
  bool any = false, point = false, sticky = false;
  for (; s != end && ((*s >= '0' && *s <= '9') || (*s == '.' && !point)); ++s) {
    const uint32_t digit = uint32_t(*s - '0');
    point = point || *s == '.';
    if (*s == '.') continue;
    any = true;
    if (point) --ten;
    if (size == 0 && digit == 0) continue;
    if (size >= 800) ++ten, sticky = sticky || digit != 0;  // no tie has more than 768 digits
    if (size < 800) ++size, multiply_add(&num, 10, digit);
  }
  if (any && s != end && (*s == 'e' || *s == 'E')) {
    const bool down = ++s != end && *s == '-';
    if (s != end && (*s == '+' || *s == '-')) ++s;
    any = s != end;
    int64_t e = 0;
    for (; s != end && *s >= '0' && *s <= '9'; ++s)
      e = std::min<int64_t>(10 * e + (*s - '0'), int64_t(1) << 56);  // no token has 2^56 digits
    ten += down ? -e : e;
  }
  *key = 0;
  if (!any || s != end || (size != 0 && ten + size > 310)) return false;  // at least 10^310
  if (size == 0 || ten + size < -330) return true;                        // below 10^-330
  int64_t x = ten;  // |value| = num * 5^ten * 2^x
  if (ten < 0) num.insert(num.begin(), size_t(3 - ten * 3 / 32), 0), x -= 32 * (3 - ten * 3 / 32);
  for (int64_t left = ten < 0 ? -ten : ten; left > 0; left -= 13) {
    uint32_t power = 1;  // 5^min(left, 13) < 2^32
    for (int64_t i = 0; i < left && i < 13; ++i) power *= 5;
    if (ten < 0) sticky = divide(&num, power) != 0 || sticky;
    if (ten >= 0) multiply_add(&num, power, 0);
  }
  size_t low = 0;  // keep the three highest digits: more than 64 bits if anything follows them
  for (; low + 3 < num.size(); ++low) sticky = sticky || num[low] != 0;
  u128 q = 0;
  for (size_t i = num.size(); i-- > low;) q = q << 32 | num[i];
  const int high = bit_length(uint64_t(q >> 64));
  sticky = sticky || (q & ((u128(1) << high) - 1)) != 0;
  if (!round_to_key(uint64_t(q >> high), sticky, x + 32 * int64_t(low) + high, key)) return false;
  if (below) *key = -*key;
  return true;
}
