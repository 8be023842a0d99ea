// SPDX-License-Identifier: LGPL-3.0-or-later
// splines/bezier_triangle_algebra.h: sums, products, elevation, integrals and affine images of triangular Bernstein
// forms, and their conversion from and to tensor-product form.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "splines/bezier_triangle.h"
#include "splines/binomial.h"
#include "splines/de_casteljau_line.h"
#include "splines/scaled_product.h"

namespace veritope {
namespace internal {

/// n! / (i! j! k!) in the order of triangle_index.
template <typename Knot>
std::vector<Knot> trinomials(int degree) {
  const std::vector<Integer> rows = binomial_row(degree);
  std::vector<Knot> out;
  for (int row = 0; row <= degree; ++row)
    for (const Integer& b : binomial_row(row))
      out.push_back(knot_of<Knot>(rows[static_cast<std::size_t>(row)] * b));
  return out;
}

/// A polynomial of one component whose coefficients carry the trinomials: products are convolutions.
template <Ring R>
struct ScaledTriangle {
  int degree = 0;
  std::vector<R> c;

  static ScaledTriangle of(int degree, std::span<const R> coefficients) {
    ScaledTriangle out{degree, {}};
    const auto scale = trinomials<typename RingNumbers<R>::Knot>(degree);
    for (std::size_t i = 0; i < scale.size(); ++i)
      out.c.push_back(RingNumbers<R>::of_knot(scale[i]) * coefficients[i]);
    return out;
  }
  void store(std::span<R> coefficients) const {
    const auto scale = trinomials<typename RingNumbers<R>::Knot>(degree);
    for (std::size_t i = 0; i < scale.size(); ++i) coefficients[i] = divided<R>(c[i], scale[i]);
  }
  friend ScaledTriangle operator*(const ScaledTriangle& a, const ScaledTriangle& b) {
    ScaledTriangle out{a.degree + b.degree, {}};
    out.c.resize(num_triangle_coefficients(out.degree));
    add_product_on_triangles(a.c.data(), a.degree, b.c.data(), b.degree, out.c.data());
    return out;
  }
  /// REQUIRES the same degree.
  friend ScaledTriangle operator+(ScaledTriangle a, const ScaledTriangle& b) {
    for (std::size_t i = 0; i < a.c.size(); ++i) a.c[i] = a.c[i] + b.c[i];
    return a;
  }
};

}  // namespace internal

/// Raises the degree by one; the map is the same.
template <Ring R>
BezierTriangle<R> elevated(const BezierTriangle<R>& map) {
  const int n = map.degree() + 1;
  BezierTriangle<R> out(n, map.num_components(), map.is_rational());
  for (int c = 0; c < map.num_components(); ++c) {
    const auto from = map.component(c);
    for_each_triangle_index(n, [&](int i, int j, int k) {
      R sum;
      if (i > 0) sum = sum + RingNumbers<R>::ratio(i, n) * from[triangle_index(j, k)];
      if (j > 0) sum = sum + RingNumbers<R>::ratio(j, n) * from[triangle_index(j - 1, k)];
      if (k > 0) sum = sum + RingNumbers<R>::ratio(k, n) * from[triangle_index(j, k - 1)];
      out.component(c)[triangle_index(j, k)] = sum;
    });
  }
  return out;
}
/// Raises the degree to one that is not below the map's.
template <Ring R>
BezierTriangle<R> elevated_to(BezierTriangle<R> map, int degree) {
  while (map.degree() < degree) map = elevated(map);
  return map;
}

/// The product, component by component, weights included; a factor that has one component and is not rational
/// multiplies all components but the weight. REQUIRES equally many components and both maps rational or neither, or an
/// `a` that has one component and is not rational.
template <Ring R>
BezierTriangle<R> product(const BezierTriangle<R>& a, const BezierTriangle<R>& b) {
  const bool is_scalar = a.num_components() == 1 && !a.is_rational();
  VT_CHECK(
      is_scalar || (a.num_components() == b.num_components() && a.is_rational() == b.is_rational()),
      "a product of two maps of as many components, or of a scalar and a map");
  using Scaled = internal::ScaledTriangle<R>;
  BezierTriangle<R> out(a.degree() + b.degree(), b.num_components(), b.is_rational());
  for (int c = 0; c < b.num_components(); ++c) {
    const bool is_weight = b.is_rational() && c == b.dimension();
    const auto of_b = Scaled::of(b.degree(), b.component(c));
    if (is_scalar && is_weight) {
      const std::vector<R> ones(a.count(), one<R>());
      (Scaled::of(a.degree(), ones) * of_b).store(out.component(c));
    } else {
      (Scaled::of(a.degree(), a.component(is_scalar ? 0 : c)) * of_b).store(out.component(c));
    }
  }
  return out;
}

/// The sum of two maps with equally many coordinates, over the product of their weights if one is rational.
template <Ring R>
BezierTriangle<R> sum(const BezierTriangle<R>& a, const BezierTriangle<R>& b) {
  VT_CHECK(a.dimension() == b.dimension(), "a sum of two maps with as many coordinates");
  const auto weight = [](const BezierTriangle<R>& map) {
    if (!map.is_rational()) return BezierTriangle<R>(0, 1, false, {one<R>()});
    const auto w = map.component(map.dimension());
    return BezierTriangle<R>(map.degree(), 1, false, {w.begin(), w.end()});
  };
  const auto coordinates = [](const BezierTriangle<R>& map) {
    const auto all =
        map.coefficients().first(static_cast<std::size_t>(map.dimension()) * map.count());
    return BezierTriangle<R>(map.degree(), map.dimension(), false, {all.begin(), all.end()});
  };
  const bool is_rational = a.is_rational() || b.is_rational();
  auto x = coordinates(a), y = coordinates(b);
  if (is_rational) x = product(weight(b), x), y = product(weight(a), y);
  const int degree = x.degree() > y.degree() ? x.degree() : y.degree();
  x = elevated_to(std::move(x), degree), y = elevated_to(std::move(y), degree);
  std::vector<R> c;
  for (std::size_t i = 0; i < x.coefficients().size(); ++i)
    c.push_back(x.coefficients()[i] + y.coefficients()[i]);
  if (is_rational) {
    const auto w = elevated_to(product(weight(a), weight(b)), degree);
    c.insert(c.end(), w.coefficients().begin(), w.coefficients().end());
  }
  return BezierTriangle<R>(degree, a.dimension() + (is_rational ? 1 : 0), is_rational,
                           std::move(c));
}

/// The integral of each component over {(v, w): v >= 0, w >= 0, v + w <= 1}, of area 1/2: half the mean coefficient.
/// REQUIRES a polynomial map.
template <Ring R>
std::vector<R> integral(const BezierTriangle<R>& map) {
  VT_CHECK(!map.is_rational(), "the integral of a rational map is no rational number");
  const R factor = RingNumbers<R>::ratio(1, 2 * static_cast<std::int64_t>(map.count()));
  std::vector<R> out;
  for (int c = 0; c < map.num_components(); ++c) {
    R total;
    for (const R& v : map.component(c)) total = total + v;
    out.push_back(factor * total);
  }
  return out;
}

/// matrix * (point of the map) + shift. matrix: row by row, each of dimension() numbers; as many rows as `shift` has
/// entries.
template <Ring R>
BezierTriangle<R> affine_image(const BezierTriangle<R>& map, std::span<const R> matrix,
                               std::span<const R> shift) {
  const auto columns = static_cast<std::size_t>(map.dimension());
  VT_CHECK(matrix.size() == columns * shift.size(), "a matrix for the map's points");
  std::vector<R> c;
  for (std::size_t row = 0; row < shift.size(); ++row)
    for (std::size_t i = 0; i < map.count(); ++i) {
      R v = map.is_rational() ? shift[row] * map.component(map.dimension())[i] : shift[row];
      for (std::size_t k = 0; k < columns; ++k)
        v = v + matrix[row * columns + k] * map.component(static_cast<int>(k))[i];
      c.push_back(v);
    }
  if (map.is_rational()) {
    const auto w = map.component(map.dimension());
    c.insert(c.end(), w.begin(), w.end());
  }
  return BezierTriangle<R>(map.degree(),
                           static_cast<int>(shift.size()) + (map.is_rational() ? 1 : 0),
                           map.is_rational(), std::move(c));
}

/// A tensor-product map of degrees (p, q) on the triangle with these corners in its parameter plane; its degree is p +
/// q. @cost O(q p^4 + q^2 p^2) products per component
template <Ring R>
BezierTriangle<R> on_triangle(const BezierSurface<R>& map,
                              const std::array<std::array<R, 2>, 3>& corners) {
  using Scaled = internal::ScaledTriangle<R>;
  std::array<Scaled, 2> along, against;  // s and 1 - s, t and 1 - t, of degree 1
  for (std::size_t a = 0; a < 2; ++a) {
    along[a].degree = against[a].degree = 1;
    for (const auto& corner : corners) {
      along[a].c.push_back(corner[a]);
      against[a].c.push_back(one<R>() - corner[a]);
    }
  }
  struct Blend {  // de Casteljau's scheme with polynomials in the place of numbers
    const Scaled &q, &x;
    void into_first(Scaled& f, const Scaled& g) const { f = f * q + g * x; }
  };
  const auto fold = [](std::vector<Scaled> f, const Scaled& q, const Scaled& x) {
    internal::keep_right(f.data(), 1, static_cast<int>(f.size()) - 1, Blend{q, x});
    return std::move(f.front());
  };
  const int p = map.degree(0), q = map.degree(1);
  BezierTriangle<R> out(p + q, map.num_components(), map.is_rational());
  for (int c = 0; c < map.num_components(); ++c) {
    std::vector<Scaled> rows;
    for (int i = 0; i <= p; ++i) {
      std::vector<Scaled> row;
      for (int j = 0; j <= q; ++j)
        row.push_back({0, {map.component(c)[static_cast<std::size_t>(i * (q + 1) + j)]}});
      rows.push_back(fold(std::move(row), against[1], along[1]));
    }
    fold(std::move(rows), against[0], along[0]).store(out.component(c));
  }
  return out;
}

/// The triangle's points as a tensor-product map of degrees (n, n): S(s, t) = map(1 - s, s (1 - t), s t). Its edge s =
/// 0 is collapsed to corner 0; s = 1 is the boundary opposite to it.
template <Ring R>
BezierSurface<R> as_tensor_product(const BezierTriangle<R>& map) {
  const int n = map.degree();
  BezierSurface<R> out({n, n}, map.num_components(), map.is_rational());
  for (int c = 0; c < map.num_components(); ++c)
    for (int row = 0; row <= n; ++row) {
      const auto first =
          map.component(c).begin() + static_cast<std::ptrdiff_t>(triangle_index(row, 0));
      std::vector<R> curve(first, first + row + 1);  // of degree `row`, raised to n
      for (int degree = row + 1; degree <= n; ++degree) {
        curve.push_back(curve.back());
        for (int k = degree - 1; k > 0; --k) {
          R& v = curve[static_cast<std::size_t>(k)];
          v = blend(curve[static_cast<std::size_t>(k) - 1], v, RingNumbers<R>::ratio(k, degree),
                    RingNumbers<R>::ratio(degree - k, degree));
        }
      }
      for (std::size_t k = 0; k < curve.size(); ++k)
        out.component(c)[static_cast<std::size_t>(row * (n + 1)) + k] = curve[k];
    }
  return out;
}

}  // namespace veritope
