// SPDX-License-Identifier: Apache-2.0 OR MIT
#include "star_rounded.h"

#include "star_poly.h"

namespace {

__extension__ typedef __int128 i128;

const int kBits = 61;

// floor(a / 2^drop), of n limbs; drop may be negative. REQUIRES that it is below 2^126 in absolute value.
i128 highest(const uint64_t* a, int n, int64_t drop) {
  const uint64_t above = 0 - (a[n - 1] >> 63);
  const auto limb = [&](int64_t i) { return i < 0 ? 0 : i < n ? a[i] : above; };
  const int64_t first = drop >= 0 ? drop / 64 : -((63 - drop) / 64);
  const int low = int(drop - 64 * first);
  const u128 x = u128(limb(first + 1)) << 64 | limb(first);
  return i128(low == 0 ? x : x >> low | u128(limb(first + 2)) << (128 - low));
}
i128 floor_divided(i128 a, int64_t b) {
  const i128 q = a / b;
  return q - (q * b > a);
}

int64_t midpoint(int64_t a, int64_t b) { return (a + b) >> 1; }

// Both halves of a row come from n rounds of midpoints: the second half from those with the next number, the first half
// from those with the one before. rows: of `width` numbers each, `step` apart.
void halve(int64_t* rows, int n, int64_t step, int width) {
  for (int round = 1; round <= n; ++round)
    for (int i = 0; i <= n - round; ++i) {
      int64_t* const row = rows + i * step;
      for (int k = 0; k < width; ++k) row[k] = midpoint(row[k], row[k + step]);
    }
}
void take_quarter(const Shape& s, int child, std::vector<int64_t>* c) {
  const int64_t along = s.q + 1;
  if (child / 2 == 0)
    halve(c->data() + s.p * along, s.p, -along, s.q + 1);
  else
    halve(c->data(), s.p, along, s.q + 1);
  for (int i = 0; i <= s.p; ++i) {
    int64_t* const row = c->data() + i * along;
    if (child % 2 == 0)
      halve(row + s.q, s.q, -1, 1);
    else
      halve(row, s.q, 1, 1);
  }
}

// Replaces the corner `to` of a triangle's net by its midpoint with the corner `from`.
void replace(const Shape& s, int from, int to, int64_t* c) {
  for (int m = 1; m <= s.p; ++m)  // the rows with from + to = m
    for (int step = 1; step <= m; ++step)
      for (int r = m; r >= step; --r) {
        int i[3], j[3];
        i[to] = r, i[from] = m - r, i[3 - from - to] = s.p - m;
        j[to] = r - 1, j[from] = m - r + 1, j[3 - from - to] = s.p - m;
        int64_t* const x = &c[s.at3(i[1], i[2])];
        *x = midpoint(*x, c[s.at3(j[1], j[2])]);
      }
}
void take_corner(const Shape& s, int corner, int64_t* c) {
  replace(s, corner, (corner + 1) % 3, c);
  replace(s, corner, (corner + 2) % 3, c);
}
// The middle triangle (m0, m1, m2), m0 between the corners 1 and 2. After k steps at m2 the coefficients with the third
// index k are on the side from m1 to m0 of the corner triangle (m1, m0, c2).
void take_middle(const Shape& s, std::vector<int64_t>* c) {
  std::vector<int64_t> net = *c, corner;
  for (int k = 0; k <= s.p; ++k) {
    const int n = s.p - k;
    corner = net;
    take_corner(Shape{true, n, n}, 2, corner.data());
    for (int j = 0; j <= n; ++j) (*c)[size_t(s.at3(j, k))] = corner[size_t(s.at3(n - j, 0))];
    for (int row = 0; row < n; ++row)
      for (int i = 0; i <= row; ++i) {
        int64_t* const x = &net[size_t(s.at3(row - i, i))];
        *x = midpoint(*x, net[size_t(s.at3(row - i + 1, i))]);
      }
  }
}

}  // namespace

Rounded rounded(const Shape& s, const Block& b) {
  const int bits = std::min(kBits, 125 - bits_of_binomials(s));  // all numbers below 2^126 before they are divided
  int64_t most = 0;
  each_pair_of_binomials(s, [&](size_t i, int64_t one, int64_t other) {
    const int divided = bit_length(uint64_t(one)) + bit_length(uint64_t(other)) - 2;  // 2^this is at most one * other
    most = std::max(most, int64_t(bits_of(b.number(i), b.n) - divided));
  });
  Rounded r = {std::vector<int64_t>(size_t(s.count())), 1};
  each_pair_of_binomials(s, [&](size_t i, int64_t one, int64_t other) {
    const i128 x = highest(b.number(i), b.n, most - bits);
    const bool fits = bit_length(uint64_t(one)) + bit_length(uint64_t(other)) < 64;
    r.c[i] = int64_t(fits ? floor_divided(x, one * other) : floor_divided(floor_divided(x, one), other));
  });
  return r;
}

Rounded quarter(const Shape& s, const Rounded& r, int child) {
  Rounded to = {r.c, r.error + (s.is_triangle ? s.p + 1 : s.p + s.q + 1) / 2};  // a midpoint adds at most 1/2
  if (!s.is_triangle)
    take_quarter(s, child, &to.c);
  else if (child < 3)
    take_corner(s, child, to.c.data());
  else
    take_middle(s, &to.c);
  return to;
}

int sign_of(const Rounded& r) {
  bool any[3] = {false, false, false};  // surely negative, unknown, surely positive
  for (int64_t x : r.c) any[x > r.error ? 2 : x < -r.error ? 0 : 1] = true;
  if (any[0] && any[2]) return 0;
  return any[1] ? kUnknown : any[2] ? 1 : -1;
}
