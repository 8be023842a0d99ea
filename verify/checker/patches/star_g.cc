// SPDX-License-Identifier: Apache-2.0 OR MIT
// star_g.cc: the polynomials g_c of docs/certificates/star-box.md, section 4.
#include "star_node.h"
#include "star_poly.h"

namespace {

// (X, Y, Z, W)[k], or its derivative along axis 0 or 1 up to a positive factor.
Poly component(const Patch& p, int k, int axis) {
  std::vector<Big> r;
  for (size_t i = size_t(k); i < p.net.size(); i += 4) r.push_back(p.net[i]);
  return polynomial(p.shape, r, axis);
}

}  // namespace

Block make_g(const Patch& p) {
  Poly f[4], du[4], dv[4], g[4];
  for (int k = 0; k < 4; ++k) {
    f[k] = component(p, k, -1);
    if (k == 3 && !p.is_rational) continue;
    du[k] = component(p, k, 0);
    dv[k] = component(p, k, 1);
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
  return packed(numbers);
}

Shape shape_of_g(const Patch& p) {
  const int d = p.shape.is_triangle ? 2 : 1;
  return Shape{p.shape.is_triangle, 3 * p.shape.p - d, 3 * p.shape.q - d};
}
void make_children_g(const Patch& p, Node* node) {
  Block quarter[4];
  quarters(shape_of_g(p), 4, node->g, quarter);
  for (int c = 0; c < 4; ++c) node->child[c].g = std::move(quarter[c]);
}
