// SPDX-License-Identifier: Apache-2.0 OR MIT
// geometry.h: exact integers, points, and the stab rule of docs/certificates/mesh.md, section 6.
//
// Bit budget. Coordinates are integers below 2^B in absolute value and are held in C limbs,
// B <= 64 C - 3. Products are as wide as their factors together, so only sums need room:
//   difference  < 2^(B+1)              C limbs       2x2 minor, normal  < 2^(2B+3)     2 C limbs
//   n x e       < 2^(3B+5)           3 C limbs       (n x e).x          < 2^(4B+7)     4 C limbs
//   n.(a - v)   < 2^(3B+6)           3 C limbs       2^32 determinants  < 2^(3B+35)    4 C limbs
//   d.x and g.(p - v), |d| and |g| <= 2^31           < 2^(B+34)       C + 1 limbs
//   n.d                                              < 2^(2B+36)    2 C + 1 limbs
// and the differences of two such values: each bound leaves a bit for that and one for the sign.
#pragma once
#include "mesh.h"
#include "../common/numbers.h"

template <int L>
struct Fixed {
  uint64_t d[L];  // least significant limb first
};

template <int L>
inline Fixed<L> fixed(int64_t v) {
  Fixed<L> r;
  for (int i = 0; i < L; ++i) r.d[i] = uint64_t(i == 0 ? v : -int64_t(v < 0));
  return r;
}
template <int L>
inline int sign(const Fixed<L>& a) {
  uint64_t any = 0;
  for (int i = 0; i < L; ++i) any |= a.d[i];
  return any == 0 ? 0 : a.d[L - 1] >> 63 != 0 ? -1 : 1;
}
// a += b & mask, or with flip = ~0 (complement and carry in) a -= b & mask; n limbs.
inline void add(uint64_t* a, const uint64_t* b, int n, uint64_t mask, uint64_t flip) {
  u128 carry = flip & 1;
  for (int i = 0; i < n; ++i, carry >>= 64) {
    carry += u128(a[i]) + ((b[i] & mask) ^ flip);
    a[i] = uint64_t(carry);
  }
}
template <int L>
inline Fixed<L> operator+(Fixed<L> a, const Fixed<L>& b) {
  add(a.d, b.d, L, ~uint64_t(0), 0);
  return a;
}
template <int L>
inline Fixed<L> operator-(Fixed<L> a, const Fixed<L>& b) {
  add(a.d, b.d, L, ~uint64_t(0), ~uint64_t(0));
  return a;
}
// Cannot overflow. The limbs are multiplied as unsigned numbers, which reads a negative operand of
// n limbs as 2^(64 n) too large; the other operand, shifted up by n limbs, is subtracted for it.
template <int A, int B>
inline Fixed<A + B> operator*(const Fixed<A>& a, const Fixed<B>& b) {
  Fixed<A + B> r = fixed<A + B>(0);
  for (int i = 0; i < A; ++i) {
    uint64_t carry = 0;
    for (int j = 0; j < B; ++j) {
      const u128 t = u128(a.d[i]) * b.d[j] + r.d[i + j] + carry;
      r.d[i + j] = uint64_t(t);
      carry = uint64_t(t >> 64);
    }
    r.d[i + B] = carry;
  }
  add(r.d + A, b.d, B, 0 - (a.d[A - 1] >> 63), ~uint64_t(0));
  add(r.d + B, a.d, A, 0 - (b.d[B - 1] >> 63), ~uint64_t(0));
  return r;
}

template <int L>
struct Vec {
  Fixed<L> x[3];
};
template <int L>
inline Vec<L> operator-(const Vec<L>& a, const Vec<L>& b) {
  return Vec<L>{{a.x[0] - b.x[0], a.x[1] - b.x[1], a.x[2] - b.x[2]}};
}
template <int A, int B>
inline Fixed<A + B> dot(const Vec<A>& a, const Vec<B>& b) {
  return a.x[0] * b.x[0] + a.x[1] * b.x[1] + a.x[2] * b.x[2];
}
template <int A, int B>
inline Vec<A + B> cross(const Vec<A>& a, const Vec<B>& b) {
  return Vec<A + B>{{a.x[1] * b.x[2] - a.x[2] * b.x[1], a.x[2] * b.x[0] - a.x[0] * b.x[2],
                     a.x[0] * b.x[1] - a.x[1] * b.x[0]}};
}
template <int L>
inline bool is_zero(const Vec<L>& a) {
  return sign(a.x[0]) == 0 && sign(a.x[1]) == 0 && sign(a.x[2]) == 0;
}

// Every coordinate of the referenced vertices is an integer times 2^(low - 1075), the integers
// below 2^bits in absolute value; low is the greatest such number.
struct Lattice {
  int low, bits;
  explicit Lattice(const Model& model);
  void add(int64_t key);  // a coordinate of a further point
};
template <int C>
inline Fixed<C> lattice_coordinate(int64_t key, int low) {
  Fixed<C> r = fixed<C>(0);
  if (key == 0) return r;
  const int zeros = __builtin_ctzll(key_mantissa(key));
  const uint64_t m = key_mantissa(key) >> zeros;
  const int up = key_exponent(key) + zeros - low;
  r.d[up / 64] = m << up % 64;
  if (up % 64 + bit_length(m) > 64) r.d[up / 64 + 1] = m >> (64 - up % 64);
  return key < 0 ? fixed<C>(0) - r : r;
}
template <int C>
inline Vec<C> lattice_point(const int64_t* key, int low) {  // in units of 2^(low - 1075)
  return Vec<C>{{lattice_coordinate<C>(key[0], low), lattice_coordinate<C>(key[1], low),
                 lattice_coordinate<C>(key[2], low)}};
}

// Whether the ray from v along axis u, upward or downward, stabs the triangle t: 1 yes, 0 no, -1: v
// lies in its plane. If the line stabs t, nu becomes the sign of component u of its normal.
template <int C>
inline int stab(const Vec<C>& v, const Vec<C>* t, int u, bool upwards, int* nu) {
  const int p = (u + 1) % 3, q = (u + 2) % 3;
  bool odd = false;
  for (int i = 0; i < 3; ++i) {
    const bool rises = sign(t[(i + 1) % 3].x[q] - t[i].x[q]) > 0;
    const Vec<C>&l = t[rises ? i : (i + 1) % 3], &h = t[rises ? (i + 1) % 3 : i];
    if (sign(v.x[q] - l.x[q]) < 0 || sign(h.x[q] - v.x[q]) <= 0) continue;
    odd ^= sign((h.x[p] - l.x[p]) * (v.x[q] - l.x[q]) - (h.x[q] - l.x[q]) * (v.x[p] - l.x[p])) > 0;
  }
  if (!odd) return 0;
  const Vec<2 * C> n = cross(t[1] - t[0], t[2] - t[0]);
  const int side = sign(dot(n, t[0] - v));
  *nu = sign(n.x[u]);
  return side == 0 ? -1 : (side == *nu) == upwards;
}

// The result of a check with the least number of limbs that holds `bits`.
static_assert(64 * 33 - 3 >= 53 + 2045 + 2, "all of binary64, and two bits more for quarters");
template <template <int> class Check, class Result, class... Arguments>
Result with_limbs(int bits, const Arguments&... arguments) {
  if (bits <= 64 * 1 - 3) return Check<1>(arguments...).result();
  if (bits <= 64 * 2 - 3) return Check<2>(arguments...).result();
  if (bits <= 64 * 5 - 3) return Check<5>(arguments...).result();
  if (bits <= 64 * 9 - 3) return Check<9>(arguments...).result();
  return Check<33>(arguments...).result();
}
