// SPDX-License-Identifier: LGPL-3.0-or-later
#include <utility>

#include "solids/chain/literal_polynomials_internal.h"
#include "splines/bezier_triangle_algebra.h"

namespace veritope::internal {
namespace {

// The vectors whose products with a point are its coordinates along the base.
std::array<ExactPoint, 2> base_axes(const LiteralFacet& facet) {
  const ExactPoint u = minus(facet.corners[1], facet.corners[0]),
                   v = minus(facet.corners[2], facet.corners[0]);
  return {cross(v, facet.normal), cross(facet.normal, u)};
}

Polynomial scalar(int degree, std::vector<Rational> values) {
  return Polynomial(degree, 1, false, std::move(values));
}

Polynomial along(const Polynomial& f, std::size_t axis) {
  const Rational o(1), z;
  return directional_derivative<Rational>(
      f, axis == 0 ? Barycentric<Rational>{-o, o, z} : Barycentric<Rational>{-o, z, o});
}

// a d(b) - b d(a) in Bernstein form, for polynomials of one degree n; of degree 2n - 1.
std::vector<Rational> wronskian(const std::vector<Rational>& a, const std::vector<Rational>& b) {
  const auto n = static_cast<int>(a.size()) - 1;
  const std::vector<Integer> rows = binomial_row(n), less = binomial_row(n - 1),
                             all = binomial_row(2 * n - 1);
  std::vector<Rational> out(all.size());
  for (std::size_t i = 0; i < rows.size(); ++i)
    for (std::size_t j = 0; j < less.size(); ++j)
      out[i + j] +=
          Rational(rows[i] * less[j]) * (a[i] * (b[j + 1] - b[j]) - b[i] * (a[j + 1] - a[j]));
  for (std::size_t k = 0; k < out.size(); ++k) out[k] *= Rational(n) / Rational(all[k]);
  return out;
}

}  // namespace

Polynomial linear_form(const LiteralFacet& facet, const ExactPoint& l, const Rational& offset) {
  const Patch::Triangle& map = *facet.map;
  std::vector<Rational> out;
  for (std::size_t i = 0; i < map.count(); ++i) {
    Rational v = map.is_rational() ? -(offset * map.component(3)[i]) : -offset;
    for (std::size_t k = 0; k < 3; ++k) v += l[k] * map.component(static_cast<int>(k))[i];
    out.push_back(std::move(v));
  }
  return scalar(map.degree(), std::move(out));
}

Polynomial height_form(const LiteralFacet& facet) {
  return linear_form(facet, facet.normal, dot(facet.normal, facet.corners[0]));
}

std::array<Polynomial, 2> base_forms(const LiteralFacet& facet) {
  const auto axes = base_axes(facet);
  return {linear_form(facet, axes[0], dot(axes[0], facet.corners[0])),
          linear_form(facet, axes[1], dot(axes[1], facet.corners[0]))};
}

std::array<Rational, 2> base_coordinates(const LiteralFacet& facet, const ExactPoint& p) {
  const auto axes = base_axes(facet);
  const ExactPoint from = minus(p, facet.corners[0]);
  return {dot(axes[0], from), dot(axes[1], from)};
}

Polynomial weight_form(const LiteralFacet& facet) {
  const Patch::Triangle& map = *facet.map;
  if (!map.is_rational()) return scalar(0, {Rational(1)});
  const auto w = map.component(3);
  return scalar(map.degree(), {w.begin(), w.end()});
}

Polynomial difference(const Polynomial& a, const Polynomial& b) {
  Polynomial out = a;
  for (std::size_t i = 0; i < out.count(); ++i) out.component(0)[i] -= b.component(0)[i];
  return out;
}

// With x = X / w and y = Y / w, x_u y_v - x_v y_u = det(X, Y, w; X_u, Y_u, w_u; X_v, Y_v, w_v) / w^3.
Polynomial jacobian_form(const LiteralFacet& facet) {
  const auto [x, y] = base_forms(facet);
  const Polynomial xu = along(x, 0), xv = along(x, 1), yu = along(y, 0), yv = along(y, 1);
  const Polynomial inner = difference(product(xu, yv), product(xv, yu));
  if (!facet.map->is_rational()) return inner;
  const Polynomial w = weight_form(facet), wu = along(w, 0), wv = along(w, 1);
  Polynomial out = product(w, inner);
  const Polynomial b = product(y, difference(product(xu, wv), product(xv, wu))),
                   a = product(x, difference(product(yu, wv), product(yv, wu)));
  out = difference(out, b);
  for (std::size_t i = 0; i < out.count(); ++i) out.component(0)[i] += a.component(0)[i];
  return out;
}

std::vector<Rational> side_form(const LiteralFacet& facet, std::size_t k, const ExactPoint& l,
                                const Rational& offset) {
  const Patch::Curve c = side_of(facet, k);
  std::vector<Rational> out;
  for (std::size_t i = 0; i <= static_cast<std::size_t>(c.degree(0)); ++i) {
    Rational v = c.is_rational() ? -(offset * c.component(3)[i]) : -offset;
    for (std::size_t j = 0; j < 3; ++j) v += l[j] * c.component(static_cast<int>(j))[i];
    out.push_back(std::move(v));
  }
  return out;
}

std::vector<Rational> turning_form(const LiteralFacet& facet, std::size_t k, const ExactPoint& b) {
  const auto axes = base_axes(facet);
  return wronskian(side_form(facet, k, axes[0], dot(axes[0], b)),
                   side_form(facet, k, axes[1], dot(axes[1], b)));
}

ExactPoint point_at(const LiteralFacet& facet, const Barycentric<Rational>& at) {
  if (facet.map) return *point_of(evaluate<Rational>(*facet.map, at));
  ExactPoint out;
  for (std::size_t c = 0; c < 3; ++c) out = plus(out, times(at[c], facet.corners[c]));
  return out;
}

}  // namespace veritope::internal
