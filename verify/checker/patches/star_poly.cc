// SPDX-License-Identifier: Apache-2.0 OR MIT
#include "star_poly.h"

int64_t binomial(int n, int k) {
  int64_t r = 1;
  for (int i = 0; i < k; ++i) r = r * (n - i) / (i + 1);
  return r;
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
Poly polynomial(const Shape& s, const std::vector<Big>& coefficients, int axis) {
  const auto at = [&](int i) -> const Big& { return coefficients[size_t(i)]; };
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
