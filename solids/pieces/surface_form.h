// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/pieces/surface_form.h: the four polynomials of a patch whose signs condition S1 asks for, as Bernstein
// coefficients over any ring. Theory: docs/THEORY.md §4.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "splines/bezier_triangle.h"
#include "splines/binomial.h"
#include "splines/ring.h"
#include "splines/scaled_product.h"

namespace veritope {

/// Where the coefficients of a polynomial of two parameters are stored: tensor (degrees p, q): row by row, the second
/// index fastest; triangle (degree p): in the order of triangle_index.
struct FormShape {
  bool is_triangle = false;
  int p = 0, q = 0;

  std::size_t count() const {
    return is_triangle ? num_triangle_coefficients(p)
                       : static_cast<std::size_t>(p + 1) * static_cast<std::size_t>(q + 1);
  }
  friend bool operator==(const FormShape&, const FormShape&) = default;
};
/// The degrees of the polynomials of determinant_form: (3p - 1, 3q - 1), or 3p - 2 for a triangle.
inline FormShape determinant_shape(const FormShape& s) {
  if (s.is_triangle) return {true, 3 * s.p - 2, 0};
  return {false, 3 * s.p - 1, 3 * s.q - 1};
}

namespace internal {

/// A polynomial with its coefficients times the binomials (trinomials) that turn products into convolutions: a square
/// array, of which a triangle uses the indices (j, k) with j + k <= p. R is a ring with division by integers.
template <Ring R>
class ScaledForm {
 public:
  explicit ScaledForm(FormShape shape) : shape_(shape), columns_(last(shape, 0) + 1) {
    values_.resize(static_cast<std::size_t>(rows() * columns_));
  }
  static ScaledForm from_bernstein(FormShape shape, const R* coefficients) {
    ScaledForm out(shape);
    out.visit([&](int a, int b, std::size_t at) {
      const auto [m, n] = factors(shape, a, b);
      out.at(a, b) = m * (n * coefficients[at]);
    });
    return out;
  }
  std::vector<R> to_bernstein() const {
    std::vector<R> out(shape_.count());
    visit([&](int a, int b, std::size_t i) {
      const auto [m, n] = factors(shape_, a, b);
      out[i] = at(a, b) / m / n;
    });
    return out;
  }
  const FormShape& shape() const { return shape_; }
  R& at(int a, int b) { return values_[static_cast<std::size_t>(a * columns_ + b)]; }
  const R& at(int a, int b) const { return values_[static_cast<std::size_t>(a * columns_ + b)]; }
  int rows() const { return shape_.p + 1; }
  /// The greatest second index in row a.
  static int last(const FormShape& s, int a) { return s.is_triangle ? s.p - a : s.q; }

  ScaledForm& operator-=(const ScaledForm& b) {
    for (std::size_t i = 0; i < values_.size(); ++i) values_[i] = values_[i] - b.values_[i];
    return *this;
  }
  ScaledForm& operator+=(const ScaledForm& b) {
    for (std::size_t i = 0; i < values_.size(); ++i) values_[i] = values_[i] + b.values_[i];
    return *this;
  }
  friend ScaledForm operator*(const ScaledForm& x, const ScaledForm& y) {
    ScaledForm out({x.shape_.is_triangle, x.shape_.p + y.shape_.p, x.shape_.q + y.shape_.q});
    const auto columns = static_cast<std::size_t>(out.columns_);
    static thread_local std::vector<ScaledRow> x_rows, y_rows;
    x.list_rows(&x_rows), y.list_rows(&y_rows);
    add_product_of_rows<R>(x.values_.data(), x_rows, y.values_.data(), y_rows, out.values_.data(),
                           [columns](std::size_t a) { return a * columns; });
    return out;
  }

  /// visit(a, b, place among the Bernstein coefficients).
  template <typename Visit>
  void visit(Visit visit) const {
    for (int a = 0; a < rows(); ++a)
      for (int b = 0; b <= last(shape_, a); ++b)
        visit(a, b,
              shape_.is_triangle ? triangle_index(a, b)
                                 : static_cast<std::size_t>(a * (shape_.q + 1) + b));
  }

 private:
  /// The rows of this form, for products.
  void list_rows(std::vector<ScaledRow>* out) const {
    out->clear();
    for (int a = 0; a < rows(); ++a)
      out->push_back({static_cast<std::size_t>(a), static_cast<std::size_t>(a * columns_),
                      static_cast<std::size_t>(last(shape_, a)) + 1});
  }
  /// The product of binomials in two factors: each alone needs fewer digits.
  static std::array<R, 2> factors(const FormShape& s, int a, int b) {
    return {known_binomial<R>(s.p, a), known_binomial<R>(s.is_triangle ? s.p - a : s.q, b)};
  }
  FormShape shape_;
  int columns_;
  std::vector<R> values_;
};

/// The Bernstein coefficients of the derivative along the first or second parameter; for a triangle, along corner 1 -
/// corner 0 or corner 2 - corner 0.
template <Ring R>
ScaledForm<R> derivative_form(const FormShape& s, const R* c, int axis) {
  FormShape less = s;
  if (s.is_triangle || axis == 0) --less.p;
  if (!s.is_triangle && axis == 1) --less.q;
  std::vector<R> d(less.count());
  const R n = RingNumbers<R>::ratio(s.is_triangle || axis == 0 ? s.p : s.q, 1);
  ScaledForm<R>(less).visit([&](int a, int b, std::size_t at) {
    const auto place = [&](int i, int j) {
      return s.is_triangle ? triangle_index(i, j) : static_cast<std::size_t>(i * (s.q + 1) + j);
    };
    d[at] = n * (c[place(a + (axis == 0), b + (axis == 1))] - c[place(a, b)]);
  });
  return ScaledForm<R>::from_bernstein(less, d.data());
}

}  // namespace internal

/// The polynomials of determinant_form, each coefficient times the binomials of its place: no division.
template <Ring R>
std::array<internal::ScaledForm<R>, 4> scaled_determinant_form(const FormShape& shape,
                                                               bool is_rational, const R* control) {
  using Form = internal::ScaledForm<R>;
  const std::size_t n = shape.count();
  const auto value = [&](std::size_t i) { return Form::from_bernstein(shape, control + i * n); };
  const auto slope = [&](std::size_t i, int axis) {
    return internal::derivative_form(shape, control + i * n, axis);
  };
  std::vector<Form> f, u, v;
  for (std::size_t i = 0; i < (is_rational ? 4u : 3u); ++i) {
    f.push_back(value(i));
    u.push_back(slope(i, 0));
    v.push_back(slope(i, 1));
  }
  const auto minor = [](const std::vector<Form>& x, const std::vector<Form>& y, std::size_t i,
                        std::size_t j) {
    Form m = x[i] * y[j];
    m -= x[j] * y[i];
    return m;
  };
  const Form zero(determinant_shape(shape));
  std::array<Form, 4> out{zero, zero, zero, zero};
  if (!is_rational) {
    const std::vector<R> ones(n, one<R>());
    const Form identity = Form::from_bernstein(shape, ones.data());
    std::vector<Form> normal;
    for (std::size_t i = 0; i < 3; ++i) normal.push_back(minor(u, v, (i + 1) % 3, (i + 2) % 3));
    Form g0 = f[0] * normal[0];
    g0 += f[1] * normal[1];
    g0 += f[2] * normal[2];
    out[0] = std::move(g0);
    for (std::size_t i = 0; i < 3; ++i) out[i + 1] -= identity * normal[i];
    return out;
  }
  // Cofactors of the last row (c, 1): G_i = (-1)^(i + 1) times the determinant of the other three components (i from
  // 0).
  const auto triple = [&](std::size_t i, std::size_t j, std::size_t k) {
    Form d = minor(f, u, i, j) * v[k];
    d -= minor(f, u, i, k) * v[j];
    d += minor(f, u, j, k) * v[i];
    return d;
  };
  out[0] = triple(0, 1, 2);
  const std::array<std::array<std::size_t, 3>, 3> rest{{{1, 2, 3}, {0, 2, 3}, {0, 1, 3}}};
  for (std::size_t i = 0; i < 3; ++i) {
    Form d = triple(rest[i][0], rest[i][1], rest[i][2]);
    if (i % 2 == 0)
      out[i + 1] -= d;
    else
      out[i + 1] = std::move(d);
  }
  return out;
}

/// Bernstein coefficients of G0, G1, G2, G3 in determinant_shape(shape), with
///   G0 + c0 G1 + c1 G2 + c2 G3 = det(F, F_u, F_v, (c, 1)) = w^3 n·(S - c),  n = S_u x S_v,
/// F = (w S, w) the homogeneous map. For a polynomial map (no w) the value is n·(S - c). control: component by
/// component, 3 or 4 of them, of shape.count() coefficients each. REQUIRES degrees >= 1.
template <Ring R>
std::array<std::vector<R>, 4> determinant_form(const FormShape& shape, bool is_rational,
                                               const R* control) {
  const auto scaled = scaled_determinant_form<R>(shape, is_rational, control);
  return {scaled[0].to_bernstein(), scaled[1].to_bernstein(), scaled[2].to_bernstein(),
          scaled[3].to_bernstein()};
}

}  // namespace veritope
