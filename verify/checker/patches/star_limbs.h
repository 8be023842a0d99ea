// SPDX-License-Identifier: Apache-2.0 OR MIT
// star_limbs.h: halves and quarters of blocks of numbers, all of one width (star_node.h says which).
#pragma once
#include "star.h"

// a + b + *carry, where *carry is 0 or 1, and becomes that of the sum.
inline uint64_t sum_with_carry(uint64_t a, uint64_t b, unsigned char* carry) {
#ifdef __x86_64__  // one instruction, to which g++ 12 does not turn the lines below
  unsigned long long sum;
  *carry = __builtin_ia32_addcarryx_u64(*carry, a, b, &sum);
  return sum;
#else
  const uint64_t first = a + b, sum = first + *carry;
  *carry = (first < a) | (sum < first);
  return sum;
#endif
}
#ifdef __clang__  // which unrolls short loops itself
#define UNROLLED
#else
#define UNROLLED _Pragma("GCC unroll 6")
#endif

// Limbs of a number: N, or, if N is 0, n.
template <int N>
struct Limbs {
  static void add(uint64_t* a, const uint64_t* b, int numbers, int n) {
    const int width = N != 0 ? N : n;
    for (int k = 0; k < numbers; ++k, a += width, b += width) {
      unsigned char carry = 0;
      UNROLLED for (int i = 0; i < width; ++i) a[i] = sum_with_carry(a[i], b[i], &carry);
    }
  }
  static void subtract(uint64_t* a, const uint64_t* b, int numbers, int n) {
    const int width = N != 0 ? N : n;
    for (int k = 0; k < numbers; ++k, a += width, b += width) {
      unsigned char carry = 1;
      UNROLLED for (int i = 0; i < width; ++i) a[i] = sum_with_carry(a[i], ~b[i], &carry);
    }
  }
  static void shift(uint64_t* a, int numbers, int n, int up) {
    const int width = N != 0 ? N : n;
    for (int k = 0; k < numbers && up > 0; ++k, a += width) {
      UNROLLED for (int i = width - 1; i > 0; --i) a[i] = a[i] << up | a[i - 1] >> (64 - up);
      a[0] <<= up;
    }
  }

  // Both halves of a row of p + 1 points at `high`, each of `numbers` numbers, `step` limbs apart, times 2^p: the first
  // at `low`, the second at `high`.
  static void halve(uint64_t* low, uint64_t* high, int p, size_t step, int numbers, int n) {
    const size_t point = size_t(numbers) * size_t(N != 0 ? N : n);
    for (int s = 0; s <= p; ++s) {
      std::copy(high, high + point, low + step * size_t(s));
      shift(low + step * size_t(s), numbers, n, p - s);
      for (int i = 0; i < p - s; ++i)
        add(high + step * size_t(i), high + step * size_t(i + 1), numbers, n);
    }
    for (int i = 1; i <= p; ++i) shift(high + step * size_t(i), numbers, n, i);
  }
  static void halve_all(const Shape& s, int axis, int numbers, int n, uint64_t* low, uint64_t* high) {
    const size_t point = size_t(numbers) * size_t(n);
    const size_t step = point * size_t(axis == 0 ? s.q + 1 : 1);
    for (int k = 0; k <= (axis == 0 ? s.q : s.p); ++k) {
      const size_t row = point * size_t(axis == 0 ? s.at(0, k) : s.at(k, 0));
      halve(low + row, high + row, axis == 0 ? s.p : s.q, step, numbers, n);
    }
  }

  // Replaces the corner `to` of a triangle's net by its midpoint with the corner `from`; points of
  // index r in `to` are multiplied by 2^r.
  static void replace(const Shape& s, int from, int to, uint64_t* a, int numbers, int n) {
    const size_t point = size_t(numbers) * size_t(n);
    for (int m = 1; m <= s.p; ++m)  // the rows with from + to = m
      for (int step = 1; step <= m; ++step)
        for (int r = m; r >= step; --r) {
          int i[3], j[3];
          i[to] = r, i[from] = m - r, i[3 - from - to] = s.p - m;
          j[to] = r - 1, j[from] = m - r + 1, j[3 - from - to] = s.p - m;
          add(a + point * size_t(s.at3(i[1], i[2])), a + point * size_t(s.at3(j[1], j[2])), numbers,
              n);
        }
  }
  // The corner triangle at corner c, times 2^p.
  static void corner(const Shape& s, int c, uint64_t* a, int numbers, int n) {
    replace(s, c, (c + 1) % 3, a, numbers, n);
    replace(s, c, (c + 2) % 3, a, numbers, n);
    const size_t point = size_t(numbers) * size_t(n);
    for (int j = 0; j <= s.p; ++j)
      for (int k = 0; j + k <= s.p; ++k)
        shift(a + point * size_t(s.at3(j, k)), numbers, n, c == 0 ? s.p - j - k : c == 1 ? j : k);
  }
  // From the corner triangle (m1, m0, c2) the middle one, (m0, m1, m2): m2 = m1 + m0 - c2, and the
  // point of index r in m2 is the r-th step of de Casteljau's scheme.
  static void middle(const Shape& s, uint64_t* a, int numbers, int n) {
    const size_t point = size_t(numbers) * size_t(n);
    std::vector<uint64_t> d(a, a + point * size_t(s.count()));
    for (int r = 0; r <= s.p; ++r) {
      const Shape now = {true, s.p - r, s.p - r}, next = {true, s.p - r - 1, s.p - r - 1};
      for (int j = 0; j <= s.p - r; ++j)  // j: second index, that of m0; index of m1: p - r - j
        std::copy(&d[point * size_t(now.at3(j, 0))], &d[point * size_t(now.at3(j, 0))] + point,
                  a + point * size_t(s.at3(s.p - r - j, r)));
      // In place: the targets of a row come before their sources.
      for (int row = 0; row <= next.p && r < s.p; ++row)
        for (int k = 0; k <= row; ++k) {
          const int j = row - k;
          uint64_t* const to = &d[point * size_t(next.at3(j, k))];
          std::vector<uint64_t> sum(to, to + point);  // the index of m1 raised: the same place
          add(sum.data(), &d[point * size_t(now.at3(j + 1, k))], numbers, n);
          subtract(sum.data(), &d[point * size_t(now.at3(j, k + 1))], numbers, n);
          std::copy(sum.begin(), sum.end(), to);
        }
    }
  }
};

#define WITH_LIMBS(n, call)        \
  switch (n) {                     \
    case 1: Limbs<1>::call; break; \
    case 2: Limbs<2>::call; break; \
    case 3: Limbs<3>::call; break; \
    case 4: Limbs<4>::call; break; \
    case 5: Limbs<5>::call; break; \
    case 6: Limbs<6>::call; break; \
    default: Limbs<0>::call;       \
  }
