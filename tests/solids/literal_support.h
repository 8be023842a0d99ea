// SPDX-License-Identifier: LGPL-3.0-or-later
// tests/solids/literal_support.h: small models for the literal chain.
#pragma once
#include <algorithm>
#include <array>
#include <map>
#include <vector>

#include "solids/patches/patch.h"
#include "splines/bezier_triangle.h"
#include "splines/pn_triangle.h"

namespace veritope::literal {

using Patches = std::vector<Patch>;

inline Rational fraction(std::int64_t p, std::int64_t q) { return Rational(p) / Rational(q); }

/// A homogeneous polynomial in barycentric coordinates: coefficients of monomials, by their exponents.
struct Poly {
  int degree = 0;
  std::map<std::array<int, 3>, Rational> terms;
};
inline Poly monomial(const std::array<int, 3>& e, const Rational& c = Rational(1)) {
  return {e[0] + e[1] + e[2], {{e, c}}};
}
inline Poly operator+(Poly a, const Poly& b) {
  for (const auto& [e, c] : b.terms) a.terms[e] += c;
  return a;
}
inline Poly operator*(const Poly& a, const Poly& b) {
  Poly out{a.degree + b.degree, {}};
  for (const auto& [e, c] : a.terms)
    for (const auto& [f, d] : b.terms) out.terms[{e[0] + f[0], e[1] + f[1], e[2] + f[2]}] += c * d;
  return out;
}
/// u + v + w, which is 1.
inline Poly unit() { return monomial({1, 0, 0}) + monomial({0, 1, 0}) + monomial({0, 0, 1}); }
inline Poly of_degree(Poly p, int degree) {
  while (p.degree < degree) p = p * unit();
  return p;
}
/// The Bernstein coefficient of u^i v^j w^k.
inline Rational bernstein(const Poly& p, int i, int j, int k) {
  const auto term = p.terms.find({i, j, k});
  if (term == p.terms.end()) return Rational(0);
  Rational choices(1);  // (i + j + k)! / (i! j! k!)
  for (int n = 1; n <= j; ++n) choices *= fraction(i + n, n);
  for (int n = 1; n <= k; ++n) choices *= fraction(i + j + n, n);
  return term->second / choices;
}

/// Moves each point of a triangle along these vectors by these polynomials.
struct Move {
  PatchPoint along;
  Poly by;
};
inline Patch moved(const std::array<PatchPoint, 3>& corners, const std::vector<Move>& moves) {
  int degree = 1;
  for (const Move& m : moves) degree = std::max(degree, m.by.degree);
  Patch::Triangle map(degree, 3, false);
  for_each_triangle_index(degree, [&](int i, int j, int k) {
    for (std::size_t c = 0; c < 3; ++c) {
      Rational& x = map.component(static_cast<int>(c))[triangle_index(j, k)];
      x = (Rational(i) * corners[0][c] + Rational(j) * corners[1][c] +
           Rational(k) * corners[2][c]) /
          Rational(degree);
      for (const Move& m : moves) x += m.along[c] * bernstein(of_degree(m.by, degree), i, j, k);
    }
  });
  return make_patch(std::move(map)).value();
}

/// A tetrahedron with a corner below, without a symmetry, whose upper face over (0,0,0), (1,0,0), (0,1,0) is moved. The
/// moves vanish on its sides.
inline Patches tetrahedron_with(const std::vector<Move>& moves, const Rational& bottom = -2) {
  const PatchPoint a{0, 0, 0}, b{1, 0, 0}, c{0, 1, 0}, d{fraction(1, 4), fraction(1, 5), bottom};
  return {moved({a, b, c}, moves), moved({b, a, d}, {}), moved({c, b, d}, {}),
          moved({a, c, d}, {})};
}

/// A solid with a valley from (0,0,0) to (0,1,0), whose plane is x = 0. Both faces at it are moved, the right one by
/// `right`, with parameters u and v at the valley's ends; the left one by `left`, with v and u.
inline Patches valley_with(const std::vector<Move>& right, const std::vector<Move>& left) {
  const PatchPoint a{0, 0, 0}, b{0, 1, 0}, c{1, fraction(1, 2), 1}, d{-1, fraction(1, 2), 1},
      e{0, fraction(1, 2), -3};
  return {moved({b, a, c}, right), moved({a, b, d}, left), moved({a, e, c}, {}),
          moved({c, e, b}, {}),    moved({b, e, d}, {}),   moved({d, e, a}, {})};
}

inline Patches pn_solid(const std::vector<PatchPoint>& points,
                        const std::vector<std::array<std::size_t, 3>>& faces) {
  Patches out;
  for (const auto& f : faces) {
    const std::array<PnPoint, 3> corners{points[f[0]], points[f[1]], points[f[2]]};
    out.push_back(make_patch(make_pn_triangle(corners, corners).value().points).value());
  }
  return out;
}
/// PN triangles with the normal of each vertex along its position.
inline Patches pn_octahedron() {
  return pn_solid(
      {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {-1, 0, 0}, {0, -1, 0}, {0, 0, -1}},
      {{0, 1, 2}, {1, 3, 2}, {3, 4, 2}, {4, 0, 2}, {1, 0, 5}, {3, 1, 5}, {4, 3, 5}, {0, 4, 5}});
}
inline Patches pn_tetrahedron() {
  return pn_solid({{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}},
                  {{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}});
}

}  // namespace veritope::literal
