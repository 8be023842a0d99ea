// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/tetrahedra/tetrahedron_angles.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "topology/tetrahedral_complex.h"

namespace veritope {
namespace {

Point3d minus(const Point3d& p, const Point3d& q) {
  return {p[0] - q[0], p[1] - q[1], p[2] - q[2]};
}
double dot(const Point3d& p, const Point3d& q) { return p[0] * q[0] + p[1] * q[1] + p[2] * q[2]; }
Point3d cross(const Point3d& p, const Point3d& q) {
  return {p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]};
}
double length(const Point3d& p) { return std::hypot(p[0], p[1], p[2]); }

}  // namespace

TetrahedronShape shape_of(const std::array<const ExactPoint3*, 4>& corners) {
  std::array<std::array<Rational, 3>, 4> from_first;
  TetrahedronShape out{};
  int exponent = -5000;
  for (std::size_t i = 1; i < 4; ++i)
    for (std::size_t axis = 0; axis < 3; ++axis) {
      from_first[i][axis] = corners[i]->at()[axis] - corners[0]->at()[axis];
      const Rational& x = from_first[i][axis];
      if (x.sign() == Sign::kZero) continue;
      exponent = std::max(exponent, static_cast<int>(x.numerator().bit_length()) -
                                        static_cast<int>(x.denominator().bit_length()));
    }
  const Rational scale = Rational::power_of_two(-exponent);
  for (std::size_t i = 1; i < 4; ++i)
    for (std::size_t axis = 0; axis < 3; ++axis)
      out[i][axis] = nearest_double(from_first[i][axis] * scale);
  return out;
}

double approx_min_dihedral(const TetrahedronShape& tetrahedron) {
  std::array<Point3d, 4> normals;  // outward
  for (std::size_t m = 0; m < 4; ++m) {
    const auto& face = kTetrahedronFaces[m];
    const Point3d& a = tetrahedron[face[0]];
    normals[m] = cross(minus(tetrahedron[face[1]], a), minus(tetrahedron[face[2]], a));
  }
  double least = std::numbers::pi;
  for (std::size_t m = 0; m < 4; ++m)
    for (std::size_t n = 0; n < m; ++n)
      least = std::min(
          least, std::atan2(length(cross(normals[m], normals[n])), -dot(normals[m], normals[n])));
  return least;
}

double approx_solid_angle(const TetrahedronShape& tetrahedron, std::size_t corner) {
  std::array<Point3d, 3> edge;
  std::array<double, 3> size{};
  for (std::size_t i = 0; i < 3; ++i) {
    edge[i] = minus(tetrahedron[(corner + 1 + i) % 4], tetrahedron[corner]);
    size[i] = length(edge[i]);
  }
  const double triple = std::abs(dot(edge[0], cross(edge[1], edge[2])));
  const double rest = size[0] * size[1] * size[2] + dot(edge[0], edge[1]) * size[2] +
                      dot(edge[1], edge[2]) * size[0] + dot(edge[2], edge[0]) * size[1];
  return 2 * std::atan2(triple, rest);
}

}  // namespace veritope
