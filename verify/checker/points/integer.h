// SPDX-License-Identifier: Apache-2.0 OR MIT
// integer.h: integers of any size, sign and magnitude. Schoolbook arithmetic: O(n m) for factors of n and m digits.
#pragma once
#include "../common/numbers.h"

struct Integer {
  bool neg = false;  // false if m is 0
  Nat m;
};

inline int sign(const Integer& a) { return a.m.empty() ? 0 : a.neg ? -1 : 1; }
inline int64_t bits(const Nat& a) {  // REQUIRES a != 0
  return 32 * int64_t(a.size()) - 32 + bit_length(a.back());
}
inline bool is_less(const Nat& a, const Nat& b) {
  if (a.size() != b.size()) return a.size() < b.size();
  return std::lexicographical_compare(a.rbegin(), a.rend(), b.rbegin(), b.rend());
}
inline void drop_zeros(Nat* a) {
  while (!a->empty() && a->back() == 0) a->pop_back();
}
inline Nat shifted(const Nat& a, int64_t up) {  // a 2^up; REQUIRES up >= 0
  Nat r(size_t(up / 32), 0);
  r.insert(r.end(), a.begin(), a.end());
  multiply_add(&r, uint32_t(1) << up % 32, 0);
  drop_zeros(&r);  // if a is 0
  return r;
}
inline void add(Nat* a, const Nat& b) {
  a->resize(std::max(a->size(), b.size()) + 1, 0);
  uint64_t carry = 0;
  for (size_t i = 0; i < a->size(); ++i, carry >>= 32) {
    carry += uint64_t((*a)[i]) + (i < b.size() ? b[i] : 0);
    (*a)[i] = uint32_t(carry);
  }
  drop_zeros(a);
}
inline void subtract(Nat* a, const Nat& b) {  // REQUIRES a >= b
  uint64_t borrow = 0;
  for (size_t i = 0; i < a->size(); ++i) {
    const uint64_t t = uint64_t((*a)[i]) - (i < b.size() ? b[i] : 0) - borrow;
    (*a)[i] = uint32_t(t);
    borrow = t >> 63;
  }
  drop_zeros(a);
}
inline Nat operator*(const Nat& a, const Nat& b) { return product(a, b); }

inline Integer operator-(Integer a) {
  a.neg = !a.neg && !a.m.empty();
  return a;
}
inline Integer operator+(const Integer& a, const Integer& b) {
  const bool swaps = is_less(a.m, b.m);
  Integer r = swaps ? b : a;
  const Integer& other = swaps ? a : b;
  if (a.neg == b.neg)
    add(&r.m, other.m);
  else
    subtract(&r.m, other.m);
  r.neg = r.neg && !r.m.empty();
  return r;
}
inline Integer operator-(const Integer& a, const Integer& b) { return a + -b; }
inline Integer operator*(const Integer& a, const Integer& b) {
  Integer r;
  r.m = a.m * b.m;
  r.neg = a.neg != b.neg && !r.m.empty();
  return r;
}
