// SPDX-License-Identifier: Apache-2.0 OR MIT
// star_quarter.cc: blocks of numbers; halves and quarters in fixed widths.
#include "star_limbs.h"
#include "star_node.h"

namespace {

// How often 2 divides all numbers, of which one is not 0.
int twos_of(const Block& b) {
  for (size_t k = 0;; ++k) {
    uint64_t any = 0;
    for (size_t i = k; i < b.d.size(); i += size_t(b.n)) any |= b.d[i];
    if (any != 0) return 64 * int(k) + __builtin_ctzll(any);
  }
}
// b divided by the greatest common power of two, with as few limbs as possible.
Block shrunk(const Block& b) {
  const int bits = bits_of(b), twos = bits == 0 ? 0 : twos_of(b);
  const int limbs = twos / 64, low = twos % 64;
  Block r;
  r.bits = bits - twos;
  r.n = r.bits / 64 + 1;  // one bit more for the sign
  r.d.resize(b.d.size() / size_t(b.n) * size_t(r.n));
  uint64_t* out = r.d.data();
  for (const uint64_t* in = b.d.data(); in != b.d.data() + b.d.size(); in += b.n) {
    const uint64_t* const a = in + limbs;
    for (int k = 0; k + 1 < r.n; ++k) *out++ = a[k] >> low | (a[k + 1] << 1) << (63 - low);
    const uint64_t above = limbs + r.n < b.n ? a[r.n] : 0 - (in[b.n - 1] >> 63);
    *out++ = a[r.n - 1] >> low | (above << 1) << (63 - low);
  }
  return r;
}

}  // namespace

void widen(const Block& b, int n, Block* to) {
  to->n = n;
  to->bits = -1;  // who widens numbers changes them
  to->d.resize(b.d.size() / size_t(b.n) * size_t(n));
  const int same = std::min(n, b.n);
  uint64_t* out = to->d.data();
  for (const uint64_t* in = b.d.data(); in != b.d.data() + b.d.size(); in += b.n) {
    for (int k = 0; k < same; ++k) *out++ = in[k];
    for (int k = same; k < n; ++k) *out++ = 0 - (in[b.n - 1] >> 63);
  }
}
int bits_of(const Block& b) {
  if (b.bits >= 0) return b.bits;
  const size_t n = size_t(b.n);
  for (size_t k = n; k-- > 0;) {  // the highest limb that is not the sign alone
    uint64_t any = 0;
    for (size_t i = 0; i < b.d.size(); i += n) any |= b.d[i + k] ^ (0 - (b.d[i + n - 1] >> 63));
    if (any != 0) return 64 * int(k) + bit_length(any);
  }
  return 0;
}
int bits_of(const uint64_t* a, int n) {
  const uint64_t sign = 0 - (a[n - 1] >> 63);
  for (int k = n; k-- > 0;)
    if (a[k] != sign) return 64 * k + bit_length(a[k] ^ sign);
  return 0;
}
void shrink(Block* b) { *b = shrunk(*b); }

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

namespace {

// The halves along an axis: the first to `low`, the second in place. What follows the points (a common weight) is only
// scaled. REQUIRES limbs for as many bits more as the degree is.
void halve(const Shape& s, int axis, int numbers, Block* low, Block* high) {
  const int n = high->n, p = axis == 0 ? s.p : s.q;
  low->n = n;
  low->d.resize(high->d.size());
  WITH_LIMBS(n, halve_all(s, axis, numbers, n, low->d.data(), high->d.data()))
  for (size_t k = size_t(s.count()) * size_t(numbers) * size_t(n); k < high->d.size(); k += size_t(n)) {
    Limbs<0>::shift(&high->d[k], 1, n, p);
    std::copy(&high->d[k], &high->d[k] + n, &low->d[k]);
  }
}

}  // namespace

Block half_of(const Shape& s, int axis, int half, int numbers, const Block& b) {
  static thread_local Block low, high;  // kept, so that little memory is asked for
  widen(b, (bits_of(b) + (axis == 0 ? s.p : s.q)) / 64 + 1, &high);
  halve(s, axis, numbers, &low, &high);
  return shrunk(half == 0 ? low : high);
}

namespace {

// The corner triangle at corner c.
Block corner_of(const Shape& s, int numbers, const Block& b, int c) {
  const int n = (bits_of(b) + s.p) / 64 + 1;
  Block r;
  widen(b, n, &r);
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

void quarters(const Shape& s, int numbers, const Block& b, Block* out) {
  static thread_local Block part[4];  // kept, so that little memory is asked for
  if (s.is_triangle) {
    for (int c = 0; c < 3; ++c) part[c] = corner_of(s, numbers, b, c);
    part[3] = middle_of(s, numbers, part[2]);
  } else {
    widen(b, (bits_of(b) + s.p + s.q) / 64 + 1, &part[3]);
    halve(s, 0, numbers, &part[1], &part[3]);
    halve(s, 1, numbers, &part[0], &part[1]);
    halve(s, 1, numbers, &part[2], &part[3]);
  }
  for (int c = 0; c < 4; ++c) out[c] = shrunk(part[c]);
}
