// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/dms/fast/dms_inverse_internal.h: what finding preimages and preparing for it share.
#pragma once
#include <array>
#include <vector>

#include "robust/base/box3d.h"

namespace veritope::internal {

inline constexpr double kInverseEdge = 0x1p-30;  // what boxes and cells are wider by, of their size
inline constexpr double kInverseDone = 0x1p-44;  // places in a box that differ by less are equal

inline double dot(const Point3d& a, const Point3d& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
inline Point3d minus(const Point3d& a, const Point3d& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
inline Point3d cross(const Point3d& a, const Point3d& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
/// REQUIRES the matrix row by row.
inline Point3d times(const std::array<Point3d, 3>& rows, const Point3d& x) {
  return {dot(rows[0], x), dot(rows[1], x), dot(rows[2], x)};
}
/// x with columns[0] x_0 + columns[1] x_1 + columns[2] x_2 = b; not finite if no such x exists.
inline Point3d solved(const std::array<Point3d, 3>& columns, const Point3d& b) {
  const double volume = dot(columns[0], cross(columns[1], columns[2]));
  return {dot(b, cross(columns[1], columns[2])) / volume,
          dot(columns[0], cross(b, columns[2])) / volume,
          dot(columns[0], cross(columns[1], b)) / volume};
}

/// The factors of x^index[1] y^index[2] z^index[3], in the order of tetrahedral_index, of the polynomial that has these
/// Bernstein coefficients on the tetrahedron of the origin and the three unit points of the axes.
std::vector<double> monomials_of(int degree, const std::vector<double>& coefficients);

}  // namespace veritope::internal
