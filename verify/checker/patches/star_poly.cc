// SPDX-License-Identifier: Apache-2.0 OR MIT
#include "star_poly.h"

#include "star_ring.h"

namespace {

int64_t longest(const std::vector<Big>& numbers) {
  int64_t bits = 0;
  for (const Big& x : numbers) bits = std::max(bits, x.bits());
  return bits;
}
Wide widened(const Poly& a, size_t n) {
  Wide r = {a.shape, std::vector<uint64_t>(a.c.size() * n)};
  for (size_t i = 0; i < a.c.size(); ++i) a.c[i].store(&r.d[i * n], int(n));
  return r;
}

}  // namespace

Poly product(const Poly& a, const Poly& b) {
  const Shape shape = {a.shape.is_triangle, a.shape.p + b.shape.p, a.shape.q + b.shape.q};
  const int64_t bits[2] = {longest(a.c), longest(b.c)};
  const size_t n = size_t((bits[0] + bits[1] + bit_length(a.c.size())) / 64 + 1);
  const Wide wide[2] = {widened(a, n), widened(b, n)};
  Wide r = {shape, std::vector<uint64_t>(size_t(shape.count()) * n)};
  Ring<0>{int(n)}.add_product(&r, wide[0], wide[1], int(bits[0] / 64 + 1));
  Poly out = {shape, {}};
  for (size_t i = 0; i < r.d.size(); i += n) out.c.push_back(Big::of(&r.d[i], int(n)));
  return out;
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
