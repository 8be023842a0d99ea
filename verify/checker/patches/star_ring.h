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
  // Adds x times the lowest limbs of b to those of `to`.
  static void add_row(uint64_t* to, uint64_t x, const uint64_t* b, int limbs) {
    uint64_t carry = 0;
    for (int i = 0; i < limbs; ++i) {
      const u128 sum = u128(x) * b[i] + to[i] + carry;
      to[i] = uint64_t(sum);
      carry = uint64_t(sum >> 64);
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
  void add_product(Wide* to, const Wide& a, const Wide& b, int few) const {
    const auto at = [](const Shape& s, int i, int j) {
      return size_t(s.is_triangle ? s.at3(i, j) : s.at(i, j));
    };
    const bool tri = a.shape.is_triangle;
    const size_t w = size_t(width());
    for (int i = 0; i <= a.shape.p; ++i)
      for (int j = 0; j <= (tri ? a.shape.p - i : a.shape.q); ++j)
        for (int k = 0; k <= b.shape.p; ++k)
          for (int l = 0; l <= (tri ? b.shape.p - k : b.shape.q); ++l)
            add_product(&to->d[w * at(to->shape, i + k, j + l)], &a.d[w * at(a.shape, i, j)],
                        &b.d[w * at(b.shape, k, l)], few);
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
