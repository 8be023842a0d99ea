// SPDX-License-Identifier: Apache-2.0 OR MIT
// star_g.cc: the polynomials g_c of docs/certificates/star-box.md, section 4, and S1.
#include "star_node.h"

namespace {

__extension__ typedef __int128 i128;

// A polynomial, given by its coefficients times binomials (of a triangle: trinomials): the product
// of two polynomials is then the product of such coefficients.
struct Poly {
  Shape shape;
  std::vector<Big> c;
};
int64_t binomial(int n, int k) {
  int64_t r = 1;
  for (int i = 0; i < k; ++i) r = r * (n - i) / (i + 1);
  return r;
}
// Calls f(index, factor) for each coefficient; factor is the product of its binomials.
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
// (X, Y, Z, W)[k], or its derivative along axis 0 or 1 up to a positive factor.
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

// Whether the signs of g_c at both centres are right, with g_c = G0 + c.G; sgn is -1 for a reversed
// patch. Products are below 2^125 in absolute value, three of them and the carry below 2^127.
template <int N>
bool signs_of(const uint64_t* g, const Box& b, int sgn, int n) {
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
bool signs(const uint64_t* g, const Box& b, int sgn, int n) {
  switch (n) {
    case 1: return signs_of<1>(g, b, sgn, n);
    case 2: return signs_of<2>(g, b, sgn, n);
    case 3: return signs_of<3>(g, b, sgn, n);
    case 4: return signs_of<4>(g, b, sgn, n);
    case 5: return signs_of<5>(g, b, sgn, n);
    case 6: return signs_of<6>(g, b, sgn, n);
    default: return signs_of<0>(g, b, sgn, n);
  }
}

}  // namespace

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
  const auto determinant = [&](int i, int j, int k) {  // the columns F, F_u, F_v, rows i, j, k
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
  const int d = p.shape.is_triangle ? 2 : 1, sgn = p.is_reversed ? -1 : 1, n = node->g.n;
  const Shape s = {p.shape.is_triangle, 3 * p.shape.p - d, 3 * p.shape.q - d};
  std::vector<bool> left_out;
  bool is_before = p.is_collapsed(s.sides() - 1) && node->is_outer(p, s.sides() - 1);
  for (int e = 0; e < s.sides(); ++e) {
    const bool is_pole = p.is_collapsed(e) && node->is_outer(p, e);
    if (is_pole && is_before) return false;  // two collapsed sides with a common corner
    is_before = is_pole;
    if (!is_pole) continue;
    left_out.resize(size_t(s.count()));
    for (int k = 0; k <= s.side_degree(e); ++k) left_out[size_t(s.on_side(e, k))] = true;
  }
  const auto holds = [&](uint32_t i) {
    if (!left_out.empty() && left_out[i]) return true;
    const uint64_t* const g = node->g.number(4 * i);
    return signs(g, b, sgn, n);
  };
  if (!holds(node->last_fail)) return false;
  for (uint32_t i = 0; i < uint32_t(s.count()); ++i)
    if (!holds(i)) {
      node->last_fail = i;
      return false;
    }
  return true;
}
