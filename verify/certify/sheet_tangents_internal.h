// SPDX-License-Identifier: LGPL-3.0-or-later
// verify/certify/sheet_tangents_internal.h: points and derivatives of patches in doubles, and matrices of three
// columns, for searches only: nothing here decides.
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>

#include "splines/bezier.h"

namespace veritope::internal {

using Vector3 = std::array<double, 3>;
/// Three columns, or three rows.
using Matrix3 = std::array<Vector3, 3>;

inline double dot(const Vector3& a, const Vector3& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
inline Vector3 cross(const Vector3& a, const Vector3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
// square: of the length. The square root is faster; std::hypot is right where squares leave the range of doubles.
inline double length_of(const Vector3& a, double square) {
  return square > 1e-200 && square < 1e200 ? std::sqrt(square) : std::hypot(a[0], a[1], a[2]);
}
inline double length_of(const Vector3& a) { return length_of(a, dot(a, a)); }
inline double largest(const Vector3& a) {
  return std::max({std::abs(a[0]), std::abs(a[1]), std::abs(a[2])});
}

// Below this determinant (columns and rows scaled to length one, approximately) a matrix counts as singular.
inline constexpr double kSingular = 0x1p-40;
// The inverse of the matrix with these columns; false if it is approximately singular, whatever the units of the
// coordinates and of the columns.
inline bool invert(const Matrix3& columns, Matrix3* inverse) {
  Matrix3 c = columns;
  Vector3 unit{};  // one for each coordinate
  for (std::size_t k = 0; k < 3; ++k) {
    for (const Vector3& v : columns) unit[k] = std::max(unit[k], std::abs(v[k]));
    if (!(unit[k] > 0)) return false;
    for (Vector3& v : c) v[k] /= unit[k];
  }
  const Matrix3 r{cross(c[1], c[2]), cross(c[2], c[0]), cross(c[0], c[1])};
  const double d = dot(c[0], r[0]);
  if (!(std::abs(d) > kSingular * largest(c[0]) * largest(c[1]) * largest(c[2]))) return false;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < 3; ++k) (*inverse)[i][k] = r[i][k] / d / unit[k];
  return true;
}

inline Matrix3 columns_without(const std::array<Vector3, 4>& columns, std::size_t fixed) {
  Matrix3 out{};
  for (std::size_t i = 0, n = 0; i < 4; ++i)
    if (i != fixed) out[n++] = columns[i];
  return out;
}

// Values and derivatives of the Bernstein polynomials of degree n at t. REQUIRES n >= 1.
struct Basis {
  std::array<double, 64> value, slope;
};
inline void fill_basis(int n, double t, Basis* basis) {
  auto& b = basis->value;
  b[0] = 1;
  for (int degree = 1; degree <= n; ++degree) {
    const auto d = static_cast<std::size_t>(degree);
    if (degree == n)
      for (std::size_t i = 0; i <= d; ++i)
        basis->slope[i] = n * ((i > 0 ? b[i - 1] : 0) - (i < d ? b[i] : 0));
    b[d] = t * b[d - 1];
    for (std::size_t i = d - 1; i > 0; --i) b[i] = t * b[i - 1] + (1 - t) * b[i];
    b[0] *= 1 - t;
  }
}

// A point and its derivatives.
struct Tangents {
  Vector3 at, along[2];
};
inline Tangents tangents(const BezierSurface<double>& map, const std::array<double, 2>& at) {
  Basis u, v;
  fill_basis(map.degree(0), at[0], &u);
  fill_basis(map.degree(1), at[1], &v);
  double f[4] = {0, 0, 0, 1}, fu[4] = {}, fv[4] = {};
  const auto rows = static_cast<std::size_t>(map.degree(0)) + 1,
             columns = static_cast<std::size_t>(map.degree(1)) + 1;
  for (int c = 0; c < map.num_components(); ++c) {
    double x = 0, xu = 0, xv = 0;
    const double* p = map.component(c).data();
    for (std::size_t i = 0; i < rows; ++i, p += columns) {
      double row = 0, slope = 0;
      for (std::size_t j = 0; j < columns; ++j) {
        row += v.value[j] * p[j];
        slope += v.slope[j] * p[j];
      }
      x += u.value[i] * row, xu += u.slope[i] * row, xv += u.value[i] * slope;
    }
    f[c] = x, fu[c] = xu, fv[c] = xv;
  }
  Tangents out;
  for (std::size_t k = 0; k < 3; ++k) {
    out.at[k] = f[k] / f[3];
    out.along[0][k] = (fu[k] - out.at[k] * fu[3]) / f[3];
    out.along[1][k] = (fv[k] - out.at[k] * fv[3]) / f[3];
  }
  return out;
}

// The step of the parameters along s and t that makes the difference perpendicular to both; nothing where they are
// parallel, approximately.
inline std::optional<std::array<double, 2>> foot_step(const Vector3& difference, const Vector3& s,
                                                      const Vector3& t) {
  const double ss = dot(s, s), st = dot(s, t), tt = dot(t, t), det = ss * tt - st * st;
  if (!(det > 0x1p-30 * ss * tt)) return std::nullopt;
  const double ds = dot(s, difference), dt = dot(t, difference);
  return std::array<double, 2>{(ds * tt - dt * st) / det, (dt * ss - ds * st) / det};
}

}  // namespace veritope::internal
