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

int64_t middle(int64_t a, int64_t b) { return (a + b) >> 1; }

// Both halves of a row come from n rounds of midpoints: the second half from those with the next number, the first half
// from those with the one before. rows: of `width` numbers each, `step` apart.
void halve(int64_t* rows, int n, int64_t step, int width) {
  for (int round = 1; round <= n; ++round)
    for (int i = 0; i <= n - round; ++i) {
      int64_t* const row = rows + i * step;
      for (int k = 0; k < width; ++k) row[k] = middle(row[k], row[k + step]);
    }
}
void quarter_tensor(const Shape& s, int child, std::vector<int64_t>* c) {
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

// A vertex of a child of a triangle: the midpoint of two corners, or a corner twice.
struct Vertex {
  int a, b;
};
// One step of de Casteljau's scheme at the vertex: from the net of degree n, that of degree n - 1.
std::vector<int64_t> step(const std::vector<int64_t>& net, int n, const Vertex& v) {
  const Shape s = {true, n, n}, to = {true, n - 1, n - 1};
  std::vector<int64_t> r(size_t(to.count()));
  for (int j = 0; j < n; ++j)
    for (int k = 0; j + k < n; ++k) {
      const auto next = [&](int corner) { return net[size_t(s.at3(j + (corner == 1), k + (corner == 2)))]; };
      r[size_t(to.at3(j, k))] = middle(next(v.a), next(v.b));
    }
  return r;
}
// The coefficient with indices i, j, k comes from i, j and k steps at the vertices of the child.
void quarter_triangle(const Shape& s, int child, std::vector<int64_t>* c) {
  Vertex v[3];
  for (int i = 0; i < 3; ++i) v[i] = child < 3 ? Vertex{child, i} : Vertex{(i + 1) % 3, (i + 2) % 3};
  std::vector<int64_t> last = *c;
  for (int k = 0; k <= s.p; ++k) {
    std::vector<int64_t> second = last;
    for (int j = 0; j + k <= s.p; ++j) {
      std::vector<int64_t> first = second;
      for (int n = s.p - k - j; n > 0; --n) first = step(first, n, v[0]);
      (*c)[size_t(s.at3(j, k))] = first[0];
      if (j + k < s.p) second = step(second, s.p - k - j, v[1]);
    }
    if (k < s.p) last = step(last, s.p - k, v[2]);
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
  if (s.is_triangle)
    quarter_triangle(s, child, &to.c);
  else
    quarter_tensor(s, child, &to.c);
  return to;
}

int sign_of(const Rounded& r) {
  bool any[3] = {false, false, false};  // surely negative, unknown, surely positive
  for (int64_t x : r.c) any[x > r.error ? 2 : x < -r.error ? 0 : 1] = true;
  if (any[0] && any[2]) return 0;
  return any[1] ? kUnknown : any[2] ? 1 : -1;
}
