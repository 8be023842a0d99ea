// SPDX-License-Identifier: Apache-2.0 OR MIT
// star_node.cc: halves and quarters in fixed widths, hulls, roots and children.
#include "star_node.h"

#include "star_limbs.h"

namespace {

__extension__ typedef __int128 i128;

// All numbers with n limbs.
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
// The number of bits of the largest magnitude, and how often 2 divides all numbers.
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
}  // namespace

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

namespace {

// Halves along an axis; what follows the points (a common weight) is only scaled.
void halves(const Shape& s, int axis, int numbers, const Block& b, Block* out) {
  int twos;
  const int p = axis == 0 ? s.p : s.q, n = (bits_of(b, &twos) + p) / 64 + 1;
  out[0] = out[1] = widened(b, n);
  WITH_LIMBS(n, halve_all(s, axis, numbers, n, out[0].d.data(), out[1].d.data()))
  const size_t points = size_t(s.count()) * size_t(numbers) * size_t(n);
  for (int i = 0; i < 2; ++i) {
    for (size_t k = points; k < out[i].d.size(); k += size_t(n))
      Limbs<0>::shift(&out[i].d[k], 1, n, p);
  }
}
int64_t limited(i128 q) {
  return int64_t(std::max<i128>(-kFarthest, std::min<i128>(kFarthest, q)));
}
// floor(q / 2^shift); *exact becomes false where this is less.
i128 shifted(i128 q, int shift, bool* exact) {
  if ((q & ((i128(1) << shift) - 1)) != 0) *exact = false;
  return q >> shift;
}
// floor(x / (w 2^shift)), limited to +-kFarthest; w > 0, 0 <= shift <= kMostShift.
int64_t floor_ratio(const uint64_t* x, const uint64_t* w, int n, int shift, bool* exact) {
  if (n == 1) {
    const int64_t a = int64_t(*x), d = int64_t(*w), q = a / d - (a % d < 0);
    *exact = a % d == 0;
    return limited(shifted(q, shift, exact));
  }
  if (n == 2) {
    const i128 a = i128(u128(x[1]) << 64 | x[0]), d = i128(u128(w[1]) << 64 | w[0]);
    const i128 q = a / d - (a % d < 0);
    *exact = a % d == 0;
    return limited(shifted(q, shift, exact));
  }
  Big rest;
  Big q = divide(Big::of(x, n), shifted(Big::of(w, n), shift), &rest);
  *exact = rest.sign() == 0;
  if (rest.sign() < 0) q = q - Big(1);
  if (q.bits() > 61) return q.sign() * kFarthest;
  return q.sign() == 0 ? 0 : q.sign() * int64_t(q.m[0]);
}
bool is_less(const uint64_t* a, const uint64_t* b, int n) {
  if (a[n - 1] != b[n - 1]) return int64_t(a[n - 1]) < int64_t(b[n - 1]);
  for (int i = n - 1; i-- > 0;)
    if (a[i] != b[i]) return a[i] < b[i];
  return false;
}
// The hull of a node with this net, in units 2^shift times those of the net.
Hull hull_of(const Patch& p, const Block& net, int shift) {
  Hull h;
  const int n = net.n, count = p.shape.count();
  const size_t step = p.is_rational ? 4 : 3;
  for (int k = 0; k < 3; ++k) {
    const auto coordinate = [&](int i) { return net.number(step * size_t(i) + size_t(k)); };
    h.out_lo[k] = h.in_lo[k] = kFarthest;
    h.out_hi[k] = h.in_hi[k] = -kFarthest;
    int least = 0, most = 0;
    for (int i = 1; i < count && !p.is_rational; ++i) {
      if (is_less(coordinate(i), coordinate(least), n)) least = i;
      if (is_less(coordinate(most), coordinate(i), n)) most = i;
    }
    for (int i = 0; i < count; ++i) {
      if (!p.is_rational && i != least && i != most) continue;
      bool exact;
      const uint64_t* const weight =
          net.number(p.is_rational ? 4 * size_t(i) + 3 : 3 * size_t(count));
      const int64_t low = floor_ratio(coordinate(i), weight, n, shift, &exact);
      const int64_t high = exact ? low : std::min(low + 1, kFarthest);
      h.out_lo[k] = std::min(h.out_lo[k], low);
      h.in_lo[k] = std::min(h.in_lo[k], high);
      h.in_hi[k] = std::max(h.in_hi[k], low);
      h.out_hi[k] = std::max(h.out_hi[k], high);
    }
  }
  return h;
}

// A net whose points are A times those of a net, with their weights. Sums of three products with entries below 2^31
// need 33 bits more, so one more limb holds them.
Block mapped(const Patch& p, const Block& net, const Frame& frame) {
  const int n = net.n;
  const size_t step = p.is_rational ? 4 : 3;
  Block r = widened(net, n + 1);
  for (size_t i = 0; i < size_t(p.shape.count()); ++i)
    for (size_t row = 0; row < 3; ++row) {
      const uint64_t* const from = net.number(step * i);
      uint64_t* const to = &r.d[(step * i + row) * size_t(n + 1)];
      i128 carry = 0;
      for (int limb = 0; limb < n; ++limb) {
        for (int k = 0; k < 3; ++k) {
          const uint64_t x = from[k * n + limb];
          carry += (limb + 1 == n ? i128(int64_t(x)) : i128(x)) * frame.a[row][k];
        }
        to[limb] = uint64_t(carry);
        carry >>= 64;
      }
      to[n] = uint64_t(carry);
    }
  int twos;
  const int need = bits_of(r, &twos) / 64 + 1;
  return need < r.n ? widened(r, need) : r;
}

}  // namespace

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

void quarters(const Shape& s, int numbers, const Block& b, Block* out) {
  if (!s.is_triangle) {
    Block half[2];
    halves(s, 0, numbers, b, half);
    for (int i = 0; i < 2; ++i) halves(s, 1, numbers, half[i], out + 2 * i);
  } else {
    int twos;
    const int n = (bits_of(b, &twos) + s.p) / 64 + 1;
    const size_t points = size_t(s.count()) * size_t(numbers) * size_t(n);
    for (int c = 0; c < 4; ++c) {
      out[c] = widened(b, n);
      uint64_t* const d = out[c].d.data();
      if (c < 3) WITH_LIMBS(n, corner(s, c, d, numbers, n))
      if (c == 3) WITH_LIMBS(n, middle(s, out[2].d.data(), d, numbers, n))
      for (size_t k = points; k < out[c].d.size(); k += size_t(n))
        Limbs<0>::shift(d + k, 1, n, s.p);
    }
  }
  for (int c = 0; c < 4; ++c) shrink(out + c);
}

bool Node::touches(const Patch& p, int corner, int e) const {
  const int64_t *const c = at[corner], whole = kWholeSide;
  if (p.shape.is_triangle) return (e == 0 ? whole - c[0] - c[1] : c[e - 1]) == 0;
  return e % 2 == 0 ? c[1] == (e == 0 ? 0 : whole) : c[0] == (e == 3 ? 0 : whole);
}
bool Node::is_outer(const Patch& p, int e) const {
  if (!p.shape.is_triangle) return touches(p, e, e);  // its sides follow the axes
  return touches(p, (e + 1) % 3, e) && touches(p, (e + 2) % 3, e);
}

Hull hull_in(const Frame& frame, int shift, const Patch& p, const Node& node) {
  return hull_of(p, mapped(p, node.net, frame), shift);
}
std::vector<Big> coefficients(const Patch& p, const Node& node, int k) {
  std::vector<Big> r;
  for (int i = 0; i < p.shape.count(); ++i)
    r.push_back(Big::of(k < 3 ? node.coordinate(p, i, k) : node.weight(p, i), node.net.n));
  return r;
}

namespace {

struct Index {  // of a root along u and v
  int64_t at[2];
};
Index index_of(const Patch& p, uint64_t root) {
  return Index{{int64_t(root >> p.roots[1]), int64_t(root & ((uint64_t(1) << p.roots[1]) - 1))}};
}

}  // namespace

Block on_root(const Patch& p, uint64_t root, const Shape& s, int numbers, Block b) {
  const Index ij = index_of(p, root);
  for (int axis = 0; axis < 2; ++axis)
    for (int bit = p.roots[axis]; bit-- > 0;) {
      Block half[2];
      halves(s, axis, numbers, b, half);
      b = std::move(half[ij.at[axis] >> bit & 1]);
      shrink(&b);
    }
  return b;
}

Node make_root(const Patch& p, uint64_t root) {
  Node r = Node();
  std::vector<Big> numbers;
  for (size_t i = 0; i < p.net.size(); ++i)
    if (p.is_rational || i % 4 < 3 || i + 1 == p.net.size()) numbers.push_back(p.net[i]);
  r.net = on_root(p, root, p.shape, p.is_rational ? 4 : 3, packed(numbers));
  const Index ij = index_of(p, root);
  if (p.shape.is_triangle) {
    r.at[1][0] = r.at[2][1] = kWholeSide;
  } else {
    for (int c = 0; c < 4; ++c)
      for (int axis = 0; axis < 2; ++axis)
        r.at[c][axis] =
            (ij.at[axis] + int((axis == 0 ? c + 1 : c) % 4 >= 2)) * (kWholeSide >> p.roots[axis]);
  }
  r.hull = hull_of(p, r.net, 0);
  return r;
}

void make_children(const Patch& p, Node* node) {
  node->child.reset(new Node[4]());
  Block quarter[4];
  quarters(p.shape, p.is_rational ? 4 : 3, node->net, quarter);
  const auto& a = node->at;
  for (int c = 0; c < 4; ++c) {
    Node& to = node->child[c];
    to.level = node->level + 1;
    to.net = std::move(quarter[c]);
    for (int i = 0; i < p.shape.sides(); ++i)
      for (int k = 0; k < 2; ++k) {
        // The midpoint with the corner at which the quarter lies; for the middle triangle, the
        // midpoint of the two other corners.
        const int own = p.shape.is_triangle ? c : (c == 0 ? 0 : c == 1 ? 3 : c == 2 ? 1 : 2);
        to.at[i][k] =
            (own < p.shape.sides() ? a[i][k] + a[own][k] : a[(i + 1) % 3][k] + a[(i + 2) % 3][k]) /
            2;
      }
    to.hull = hull_of(p, to.net, 0);
  }
}
