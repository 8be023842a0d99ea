// SPDX-License-Identifier: Apache-2.0 OR MIT
// star_quarter.cc: blocks of numbers; halves and quarters in fixed widths.
#include "star_limbs.h"
#include "star_node.h"

Block widened(const Block& b, int n) {
  Block r;
  r.n = n;
  r.d.resize(b.d.size() / size_t(b.n) * size_t(n));
  uint64_t* out = r.d.data();
  for (const uint64_t* in = b.d.data(); in != b.d.data() + b.d.size(); in += b.n) {
    std::copy(in, in + std::min(n, b.n), out);
    std::fill(out + std::min(n, b.n), out + n, 0 - (in[b.n - 1] >> 63));
    out += n;
  }
  return r;
}
int bits_of(const Block& b, int* twos) {
  const size_t n = size_t(b.n);
  *twos = 0;
  int bits = 0;
  // Limb by limb from the highest, until one is not the sign alone; then from the lowest, until one is not 0.
  for (size_t k = n; k-- > 0 && bits == 0;) {
    uint64_t any = 0;
    for (size_t i = 0; i < b.d.size(); i += n) any |= b.d[i + k] ^ (0 - (b.d[i + n - 1] >> 63));
    if (any != 0) bits = 64 * int(k) + bit_length(any);
  }
  for (size_t k = 0; k < n; ++k) {
    uint64_t any = 0;
    for (size_t i = 0; i < b.d.size(); i += n) any |= b.d[i + k];
    if (any == 0) continue;
    *twos = 64 * int(k) + __builtin_ctzll(any);
    break;
  }
  return bits;
}

int shrink(Block* b) {
  int twos = 0;
  const int bits = bits_of(*b, &twos);
  if (twos > 0) {
    const int limbs = twos / 64, low = twos % 64;
    for (size_t i = 0; i < b->d.size(); i += size_t(b->n)) {
      uint64_t* const a = &b->d[i];
      const uint64_t above = 0 - (a[b->n - 1] >> 63);
      for (int k = 0; k < b->n; ++k) {
        const uint64_t x = k + limbs < b->n ? a[k + limbs] : above;
        const uint64_t y = k + limbs + 1 < b->n ? a[k + limbs + 1] : above;
        a[k] = low == 0 ? x : x >> low | y << (64 - low);
      }
    }
  }
  const int n = std::max(1, (bits - twos) / 64 + 1);  // one bit more for the sign
  if (n < b->n) *b = widened(*b, n);
  return bits - twos;
}

Block packed(const std::vector<Big>& numbers) {
  Block b;
  int64_t bits = 0;
  for (const Big& x : numbers) bits = std::max(bits, x.bits());
  b.n = int(bits / 64 + 1);
  b.d.resize(numbers.size() * size_t(b.n));
  for (size_t i = 0; i < numbers.size(); ++i) numbers[i].store(&b.d[i * size_t(b.n)], b.n);
  shrink(&b);
  return b;
}

Block half_of(const Shape& s, int axis, int half, int numbers, const Block& b) {
  int twos;
  const int p = axis == 0 ? s.p : s.q, n = (bits_of(b, &twos) + p) / 64 + 1;
  Block r = widened(b, n);
  WITH_LIMBS(n, halve_all(half, s, axis, numbers, n, r.d.data()))
  for (size_t k = size_t(s.count()) * size_t(numbers) * size_t(n); k < r.d.size(); k += size_t(n))
    Limbs<0>::shift(&r.d[k], 1, n, p);
  return r;
}

namespace {

// The corner triangle at corner c.
Block corner_of(const Shape& s, int numbers, const Block& b, int c) {
  int twos;
  const int n = (bits_of(b, &twos) + s.p) / 64 + 1;
  Block r = widened(b, n);
  WITH_LIMBS(n, corner(s, c, r.d.data(), numbers, n))
  for (size_t k = size_t(s.count()) * size_t(numbers) * size_t(n); k < r.d.size(); k += size_t(n))
    Limbs<0>::shift(&r.d[k], 1, n, s.p);
  return r;
}
// The middle triangle from that at corner 2.
Block middle_of(const Shape& s, int numbers, Block corner) {
  WITH_LIMBS(corner.n, middle(s, corner.d.data(), numbers, corner.n))
  return corner;
}

}  // namespace

Block quarter(const Shape& s, int numbers, const Block& b, int c) {
  Block r = !s.is_triangle ? half_of(s, 1, c % 2, numbers, half_of(s, 0, c / 2, numbers, b))
            : c < 3        ? corner_of(s, numbers, b, c)
                           : middle_of(s, numbers, corner_of(s, numbers, b, 2));
  shrink(&r);
  return r;
}

void quarters(const Shape& s, int numbers, const Block& b, Block* out) {
  if (s.is_triangle) {
    for (int c = 0; c < 3; ++c) out[c] = corner_of(s, numbers, b, c);
    out[3] = middle_of(s, numbers, out[2]);
  } else {
    for (int i = 0; i < 2; ++i) {
      const Block half = half_of(s, 0, i, numbers, b);
      for (int j = 0; j < 2; ++j) out[2 * i + j] = half_of(s, 1, j, numbers, half);
    }
  }
  for (int c = 0; c < 4; ++c) shrink(out + c);
}
