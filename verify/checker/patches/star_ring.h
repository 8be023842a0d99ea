// SPDX-License-Identifier: Apache-2.0 OR MIT
// star_ring.h: polynomials over integers of n limbs. Sums and products are right modulo 2^(64 n), so a result is right
// if it fits into n limbs with its sign, even if sums before it do not.
#pragma once
#include "star_limbs.h"
#include "star_node.h"

__extension__ typedef __int128 i128;

// A polynomial: Bernstein coefficients times binomials, one after the other, n limbs each.
struct Wide {
  Shape shape;
  std::vector<uint64_t> d;
};

// Numbers of N limbs, or, if N is 0, of n.
template <int N>
struct Ring {
  int n;

  int width() const { return N != 0 ? N : n; }
  // Adds x times the lowest limbs of b to those of `to`, or subtracts it.
  static void add_row(uint64_t* to, uint64_t x, const uint64_t* b, int limbs) {
    uint64_t carry = 0;
    UNROLLED for (int i = 0; i < limbs; ++i) {
      const u128 sum = u128(x) * b[i] + to[i] + carry;
      to[i] = uint64_t(sum);
      carry = uint64_t(sum >> 64);
    }
  }
  static void subtract_row(uint64_t* to, uint64_t x, const uint64_t* b, int limbs) {
    uint64_t carry = 0;
    UNROLLED for (int i = 0; i < limbs; ++i) {
      const u128 product = u128(x) * b[i] + carry;
      carry = uint64_t(product >> 64) + (to[i] < uint64_t(product));
      to[i] -= uint64_t(product);
    }
  }
  // REQUIRES that all limbs of a from `few` on are equal, and that a is negative iff limb few - 1 has its highest bit.
  void add_product(uint64_t* to, const uint64_t* a, const uint64_t* b, int few) const {
    const int w = width();
    for (int i = 0; i < few; ++i) add_row(to + i, a[i], b, w - i);
    if (a[few - 1] >> 63 == 0) return;
    unsigned char carry = 1;  // minus b 2^(64 few)
    for (int j = 0; few + j < width(); ++j) to[few + j] = sum_with_carry(to[few + j], ~b[j], &carry);
  }
  // REQUIRES |f| < 2^63: then sums stay below 2^127, and what is carried below 2^63, in absolute value.
  void add_multiple(uint64_t* to, const uint64_t* a, int64_t f) const {
    i128 carry = 0;
    for (int i = 0; i < width(); ++i, carry >>= 64) {
      carry += i128(a[i]) * f + i128(to[i]);
      to[i] = uint64_t(carry);
    }
  }
  int sign(const uint64_t* a) const {
    if (int64_t(a[width() - 1]) < 0) return -1;
    for (int i = 0; i < width(); ++i)
      if (a[i] != 0) return 1;
    return 0;
  }
  // Adds x times each of `count` numbers at b to those at `to`.
  void add_products(uint64_t* to, const uint64_t* x, const uint64_t* b, int count, int few) const {
    const size_t w = size_t(width());
    if (N == 0 || few > 1) {
      for (int i = 0; i < count; ++i) add_product(to + w * size_t(i), x, b + w * size_t(i), few);
    } else if (*x >> 63 == 0) {
      for (int i = 0; i < count; ++i, to += w, b += w) add_row(to, *x, b, N);
    } else {
      for (int i = 0; i < count; ++i, to += w, b += w) subtract_row(to, 0 - *x, b, N);
    }
  }
  void add_product(Wide* to, const Wide& a, const Wide& b, int few) const {
    const Shape &s = a.shape, &t = b.shape, &sum = to->shape;
    const size_t w = size_t(width());
    const uint64_t* x = a.d.data();
    if (s.is_triangle) {  // coefficients of which the first index is the same lie side by side
      for (int i = 0; i <= s.p; ++i)
        for (int k = 0; k <= i; ++k, x += w)
          for (int j = 0; j <= t.p; ++j)
            add_products(&to->d[w * size_t(sum.at3(i + j - k, k))], x, &b.d[w * size_t(t.at3(j, 0))], j + 1, few);
    } else {
      for (int i = 0; i <= s.p; ++i)
        for (int k = 0; k <= s.q; ++k, x += w)
          for (int j = 0; j <= t.p; ++j)
            add_products(&to->d[w * size_t(sum.at(i + j, k))], x, &b.d[w * size_t(t.at(j, 0))], t.q + 1, few);
    }
  }
};

// To `to`, of n limbs: the number a of the block times 2^up.
inline void put(const Block& b, size_t a, int64_t up, uint64_t* to, int n) {
  const uint64_t *const from = b.number(a), above = 0 - (from[b.n - 1] >> 63);
  const int64_t limbs = up / 64;
  const int low = int(up % 64);
  uint64_t below = 0;
  for (int64_t k = 0; k < n; ++k) {
    const uint64_t x = k < limbs ? 0 : k - limbs < b.n ? from[k - limbs] : above;
    to[k] = low == 0 ? x : x << low | below >> (64 - low);
    below = x;
  }
}
