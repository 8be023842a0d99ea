// SPDX-License-Identifier: Apache-2.0 OR MIT
#include "star_node.h"

namespace {

__extension__ typedef __int128 i128;

// Limbs of a number: N, or, if N is 0, n.
template <int N>
struct Limbs {
  static void add(uint64_t* a, const uint64_t* b, int numbers, int n) {
    const int width = N != 0 ? N : n;
    for (int k = 0; k < numbers; ++k, a += width, b += width) {
      u128 carry = 0;
      for (int i = 0; i < width; ++i, carry >>= 64) {
        carry += u128(a[i]) + b[i];
        a[i] = uint64_t(carry);
      }
    }
  }
  static void subtract(uint64_t* a, const uint64_t* b, int numbers, int n) {
    const int width = N != 0 ? N : n;
    for (int k = 0; k < numbers; ++k, a += width, b += width) {
      u128 carry = 1;
      for (int i = 0; i < width; ++i, carry >>= 64) {
        carry += u128(a[i]) + ~b[i];
        a[i] = uint64_t(carry);
      }
    }
  }
  static void shift(uint64_t* a, int numbers, int n, int up) {
    const int width = N != 0 ? N : n;
    for (int k = 0; k < numbers && up > 0; ++k, a += width) {
      for (int i = width - 1; i > 0; --i) a[i] = a[i] << up | a[i - 1] >> (64 - up);
      a[0] <<= up;
    }
  }

  // The two halves of a row of p + 1 points, each of `numbers` numbers, `step` limbs apart; times
  // 2^p. lower and upper come with the row in them.
  static void halve(uint64_t* lower, uint64_t* upper, int p, size_t step, int numbers, int n) {
    for (int s = 1; s <= p; ++s)
      for (int i = p; i >= s; --i) add(lower + step * i, lower + step * (i - 1), numbers, n);
    for (int s = 1; s <= p; ++s)
      for (int i = 0; i <= p - s; ++i) add(upper + step * i, upper + step * (i + 1), numbers, n);
    for (int i = 0; i <= p; ++i) {
      shift(lower + step * i, numbers, n, p - i);
      shift(upper + step * i, numbers, n, i);
    }
  }
  static void halve_all(const Shape& s, int axis, int numbers, int n, uint64_t* lower,
                        uint64_t* upper) {
    const size_t point = size_t(numbers) * size_t(n);
    for (int k = 0; k <= (axis == 0 ? s.q : s.p); ++k) {
      const size_t first = point * size_t(axis == 0 ? s.at(0, k) : s.at(k, 0));
      const size_t step = point * size_t(axis == 0 ? s.q + 1 : 1);
      halve(lower + first, upper + first, axis == 0 ? s.p : s.q, step, numbers, n);
    }
  }

  // In the net of a triangle, the corner `to` is replaced by its midpoint with the corner `from`;
  // points of index r in `to` come out times 2^r.
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
  static void middle(const Shape& s, const uint64_t* a, uint64_t* out, int numbers, int n) {
    const size_t point = size_t(numbers) * size_t(n);
    std::vector<uint64_t> d(a, a + point * size_t(s.count()));
    for (int r = 0; r <= s.p; ++r) {
      const Shape now = {true, s.p - r, s.p - r}, next = {true, s.p - r - 1, s.p - r - 1};
      for (int j = 0; j <= s.p - r; ++j)  // second index, of m0; of m1: p - r - j
        std::copy(&d[point * size_t(now.at3(j, 0))], &d[point * size_t(now.at3(j, 0))] + point,
                  out + point * size_t(s.at3(s.p - r - j, r)));
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

  // The signs of g_c at both centres are right: of G0 + c.G; sgn -1 for a flipped patch. Products
  // are below 2^125 in absolute value, three of them and the carry below 2^127.
  static bool signs(const uint64_t* g, const Box& b, int sgn, int n) {
    const int width = N != 0 ? N : n;
    for (int side = 0; side < 2; ++side) {
      const int64_t* const c = b.c[side];
      i128 carry = 0;
      uint64_t any = 0;
      for (int i = 0; i < width; ++i) {
        const bool top = i + 1 == width;
        i128 t[4];
        for (int k = 0; k < 4; ++k)
          t[k] = top ? i128(int64_t(g[k * width + i])) : i128(g[k * width + i]);
        carry += t[0] + t[1] * c[0] + t[2] * c[1] + t[3] * c[2];
        if (top) break;
        any |= uint64_t(carry);
        carry >>= 64;
      }
      const int sign = carry < 0 ? -1 : (carry != 0 || any != 0) ? 1 : 0;
      if (sign * sgn != (side == 0 ? 1 : -1)) return false;
    }
    return true;
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
// The largest magnitude's bits, and how often 2 divides all.
int bits_of(const Block& b, int* twos) {
  std::vector<uint64_t> any(size_t(b.n)), low(size_t(b.n));
  for (size_t i = 0; i < b.d.size(); i += size_t(b.n)) {
    const uint64_t flip = 0 - (b.d[i + size_t(b.n) - 1] >> 63);
    for (size_t k = 0; k < size_t(b.n); ++k) any[k] |= b.d[i + k] ^ flip, low[k] |= b.d[i + k];
  }
  int bits = 0;
  *twos = 0;
  for (int k = 0; k < b.n; ++k)
    if (any[size_t(k)] != 0) bits = 64 * k + bit_length(any[size_t(k)]);
  for (int k = 0; k < b.n; ++k) {
    if (low[size_t(k)] == 0) continue;
    *twos = 64 * k + __builtin_ctzll(low[size_t(k)]);
    break;
  }
  return bits;
}
void shrink(Block* b) {
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

// Halves along an axis; what stands behind the points (a common weight) is only scaled.
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

// floor(x / w), cut at +-kFarthest; w > 0.
int64_t floor_ratio(const uint64_t* x, const uint64_t* w, int n, bool* exact) {
  if (n == 1) {
    const int64_t a = int64_t(*x), d = int64_t(*w), q = a / d - (a % d < 0);
    *exact = a % d == 0;
    return std::max(-kFarthest, std::min(kFarthest, q));
  }
  if (n == 2) {
    const i128 a = i128(u128(x[1]) << 64 | x[0]), d = i128(u128(w[1]) << 64 | w[0]);
    const i128 q = a / d - (a % d < 0);
    *exact = a % d == 0;
    return int64_t(std::max<i128>(-kFarthest, std::min<i128>(kFarthest, q)));
  }
  Big rest;
  Big q = divide(Big::of(x, n), Big::of(w, n), &rest);
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
void set_hull(const Patch& p, Node* node) {
  Hull& h = node->hull;
  const int n = node->net.n, count = p.shape.count();
  for (int k = 0; k < 3; ++k) {
    h.out_lo[k] = h.in_lo[k] = kFarthest;
    h.out_hi[k] = h.in_hi[k] = -kFarthest;
    int least = 0, most = 0;
    for (int i = 1; i < count && !p.is_rational; ++i) {
      const uint64_t* const x = node->coordinate(p, i, k);
      if (is_less(x, node->coordinate(p, least, k), n)) least = i;
      if (is_less(node->coordinate(p, most, k), x, n)) most = i;
    }
    for (int i = 0; i < count; ++i) {
      if (!p.is_rational && i != least && i != most) continue;
      bool exact;
      const int64_t low = floor_ratio(node->coordinate(p, i, k), node->weight(p, i), n, &exact);
      const int64_t high = exact ? low : std::min(low + 1, kFarthest);
      h.out_lo[k] = std::min(h.out_lo[k], low);
      h.in_lo[k] = std::min(h.in_lo[k], high);
      h.in_hi[k] = std::max(h.in_hi[k], low);
      h.out_hi[k] = std::max(h.out_hi[k], high);
    }
  }
}

// A polynomial by its coefficients times binomials (of a triangle: trinomials): products of
// polynomials are then products of coefficients.
struct Poly {
  Shape shape;
  std::vector<Big> c;
};
int64_t binomial(int n, int k) {
  int64_t r = 1;
  for (int i = 0; i < k; ++i) r = r * (n - i) / (i + 1);
  return r;
}
// f(index, factor) for each coefficient; factor: its binomials' product.
template <class F>
void each_binomial(const Shape& s, F f) {
  if (s.is_triangle) {
    for (int j = 0; j <= s.p; ++j)
      for (int k = 0; j + k <= s.p; ++k)
        f(size_t(s.at3(j, k)), Big(binomial(s.p, j)) * Big(binomial(s.p - j, k)));
  } else {
    for (int i = 0; i <= s.p; ++i)
      for (int j = 0; j <= s.q; ++j)
        f(size_t(s.at(i, j)), Big(binomial(s.p, i)) * Big(binomial(s.q, j)));
  }
}
Poly product(const Poly& a, const Poly& b) {
  Poly r = {Shape{a.shape.is_triangle, a.shape.p + b.shape.p, a.shape.q + b.shape.q}, {}};
  r.c.resize(size_t(r.shape.count()));
  const bool tri = r.shape.is_triangle;
  const int q = b.shape.q;
  for (int i = 0; i <= a.shape.p; ++i)
    for (int j = 0; j <= (tri ? a.shape.p - i : a.shape.q); ++j) {
      const Big& x = a.c[size_t(tri ? a.shape.at3(i, j) : a.shape.at(i, j))];
      for (int k = 0; k <= b.shape.p && x.sign() != 0; ++k)
        for (int l = 0; l <= (tri ? b.shape.p - k : q); ++l) {
          Big& to = r.c[size_t(tri ? r.shape.at3(i + k, j + l) : r.shape.at(i + k, j + l))];
          to = to + x * b.c[size_t(tri ? b.shape.at3(k, l) : b.shape.at(k, l))];
        }
    }
  return r;
}
Poly combined(const Poly& a, const Poly& b, int sign) {
  Poly r = a;
  for (size_t i = 0; i < r.c.size(); ++i) r.c[i] = sign > 0 ? a.c[i] + b.c[i] : a.c[i] - b.c[i];
  return r;
}
// (X, Y, Z, W)[k], or, of axis 0 or 1, its derivative up to a positive factor.
Poly component(const Patch& p, const Node& node, int k, int axis) {
  const Shape& s = p.shape;
  const auto at = [&](int i) {
    const uint64_t* const x = k < 3 ? node.coordinate(p, i, k) : node.weight(p, i);
    return Big::of(x, node.net.n);
  };
  Poly r = {s, {}};
  if (axis >= 0 && (s.is_triangle || axis == 0)) --r.shape.p;
  if (axis >= 0 && (s.is_triangle || axis == 1)) --r.shape.q;
  r.c.resize(size_t(r.shape.count()));
  for (int i = 0; i <= r.shape.p; ++i)
    for (int j = 0; j <= (s.is_triangle ? r.shape.p - i : r.shape.q); ++j) {
      const int to = s.is_triangle ? r.shape.at3(i, j) : r.shape.at(i, j);
      if (axis < 0) r.c[size_t(to)] = at(to);
      if (axis >= 0 && s.is_triangle)
        r.c[size_t(to)] = at(axis == 0 ? s.at3(i + 1, j) : s.at3(i, j + 1)) - at(s.at3(i, j));
      if (axis >= 0 && !s.is_triangle)
        r.c[size_t(to)] = at(axis == 0 ? s.at(i + 1, j) : s.at(i, j + 1)) - at(s.at(i, j));
    }
  each_binomial(r.shape, [&](size_t i, const Big& factor) { r.c[i] = r.c[i] * factor; });
  return r;
}

}  // namespace

bool Node::is_outer(const Patch& p, int e) const {
  const int64_t whole = kWholeSide;
  if (!p.shape.is_triangle)
    return e == 0   ? at[0][1] == 0
           : e == 1 ? at[1][0] == whole
           : e == 2 ? at[2][1] == whole
                    : at[3][0] == 0;
  for (int i = 1; i < 3; ++i) {
    const int64_t* const c = at[(e + i) % 3];
    if ((e == 0 ? whole - c[0] - c[1] : c[e - 1]) != 0) return false;
  }
  return true;
}

Node make_root(const Patch& p, uint64_t root) {
  Node r = Node();
  std::vector<Big> numbers;
  for (size_t i = 0; i < p.net.size(); ++i)
    if (p.is_rational || i % 4 < 3 || i + 1 == p.net.size()) numbers.push_back(p.net[i]);
  r.net = packed(numbers);
  const int64_t ij[2] = {int64_t(root >> p.roots[1]),
                         int64_t(root & ((uint64_t(1) << p.roots[1]) - 1))};
  for (int axis = 0; axis < 2; ++axis)
    for (int bit = p.roots[axis]; bit-- > 0;) {
      Block half[2];
      halves(p.shape, axis, p.is_rational ? 4 : 3, r.net, half);
      r.net = half[ij[axis] >> bit & 1];
      shrink(&r.net);
    }
  if (p.shape.is_triangle) {
    r.at[1][0] = r.at[2][1] = kWholeSide;
  } else {
    for (int c = 0; c < 4; ++c)
      for (int axis = 0; axis < 2; ++axis)
        r.at[c][axis] =
            (ij[axis] + int((axis == 0 ? c + 1 : c) % 4 >= 2)) * (kWholeSide >> p.roots[axis]);
  }
  set_hull(p, &r);
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
        // The midpoint with the corner that the quarter is at; of the middle triangle, of the two
        // other corners.
        const int own = p.shape.is_triangle ? c : (c == 0 ? 0 : c == 1 ? 3 : c == 2 ? 1 : 2);
        to.at[i][k] =
            (own < p.shape.sides() ? a[i][k] + a[own][k] : a[(i + 1) % 3][k] + a[(i + 2) % 3][k]) /
            2;
      }
    set_hull(p, &to);
  }
}

void make_root_g(const Patch& p, Node* root) {
  Poly f[4], du[4], dv[4], g[4];
  for (int k = 0; k < 4; ++k) {
    f[k] = component(p, *root, k, -1);
    if (k == 3 && !p.is_rational) continue;
    du[k] = component(p, *root, k, 0);
    dv[k] = component(p, *root, k, 1);
  }
  Poly minors[4][4];
  for (int i = 0; i < (p.is_rational ? 4 : 3); ++i)
    for (int j = 0; j < i; ++j) {
      minors[j][i] = combined(product(du[j], dv[i]), product(du[i], dv[j]), -1);
      minors[i][j] = minors[j][i];
      for (Big& x : minors[i][j].c) x = -x;
    }
  const auto determinant = [&](int i, int j, int k) {  // of the columns of F, F_u, F_v
    return combined(combined(product(f[i], minors[j][k]), product(f[j], minors[k][i]), 1),
                    product(f[k], minors[i][j]), 1);
  };
  g[0] = determinant(0, 1, 2);
  for (int k = 0; k < 3; ++k) {  // minus the cofactor; a polynomial patch has F_u, F_v with w = 0
    const int i = (k + 1) % 3, j = (k + 2) % 3;
    g[k + 1] = p.is_rational ? determinant(i, j, 3) : product(f[3], minors[i][j]);
  }
  Big common = 1;
  each_binomial(g[0].shape, [&](size_t, const Big& factor) {
    common = common * divide(factor, gcd(common, factor), nullptr);
  });
  std::vector<Big> numbers(4 * g[0].c.size());
  each_binomial(g[0].shape, [&](size_t i, const Big& factor) {
    const Big up = divide(common, factor, nullptr);
    for (int k = 0; k < 4; ++k)
      numbers[4 * i + size_t(k)] = k == 0 ? g[k].c[i] * up : -(g[k].c[i] * up);
  });
  root->g = packed(numbers);
}

void make_children_g(const Patch& p, Node* node) {
  const int d = p.shape.is_triangle ? 2 : 1;
  Block quarter[4];
  quarters(Shape{p.shape.is_triangle, 3 * p.shape.p - d, 3 * p.shape.q - d}, 4, node->g, quarter);
  for (int c = 0; c < 4; ++c) node->child[c].g = std::move(quarter[c]);
}

bool star_test(const Patch& p, Node* node, const Box& b) {
  const int d = p.shape.is_triangle ? 2 : 1, sgn = p.is_flipped ? -1 : 1, n = node->g.n;
  const Shape s = {p.shape.is_triangle, 3 * p.shape.p - d, 3 * p.shape.q - d};
  std::vector<bool> left_out;
  bool is_before = p.is_collapsed(s.sides() - 1) && node->is_outer(p, s.sides() - 1);
  for (int e = 0; e < s.sides(); ++e) {
    const bool is_pole = p.is_collapsed(e) && node->is_outer(p, e);
    if (is_pole && is_before) return false;  // two with a common corner
    is_before = is_pole;
    if (!is_pole) continue;
    left_out.resize(size_t(s.count()));
    for (int k = 0; k <= s.side_degree(e); ++k) left_out[size_t(s.on_side(e, k))] = true;
  }
  const auto holds = [&](uint32_t i) {
    if (!left_out.empty() && left_out[i]) return true;
    const uint64_t* const g = node->g.number(4 * i);
    bool r = false;
    WITH_LIMBS(n, signs(g, b, sgn, n) ? r = true : r)
    return r;
  };
  if (!holds(node->last_fail)) return false;
  for (uint32_t i = 0; i < uint32_t(s.count()); ++i)
    if (!holds(i)) {
      node->last_fail = i;
      return false;
    }
  return true;
}
