// SPDX-License-Identifier: LGPL-3.0-or-later
// tests/predicates/rational_oracle.h: the predicates as signs of homogeneous determinants over
// GMP's own rationals, by Gaussian elimination. Shares no line with robust/ or predicates/.
#pragma once
#include <gmpxx.h>

#include <cstddef>
#include <utility>
#include <vector>

#include "predicates/side_of_plane.h"
#include "predicates/vec.h"
#include "robust/base/sign.h"

namespace veritope::oracle {

using Matrix = std::vector<std::vector<mpq_class>>;

inline int determinant_sign(Matrix m) {
  int sign = 1;
  for (std::size_t k = 0; k < m.size(); ++k) {
    std::size_t pivot = k;
    while (pivot < m.size() && sgn(m[pivot][k]) == 0) ++pivot;
    if (pivot == m.size()) return 0;
    if (pivot != k) std::swap(m[pivot], m[k]), sign = -sign;
    sign *= sgn(m[k][k]);
    for (std::size_t i = k + 1; i < m.size(); ++i) {
      const mpq_class factor = m[i][k] / m[k][k];
      for (std::size_t j = k; j < m.size(); ++j) m[i][j] -= factor * m[k][j];
    }
  }
  return sign;
}

inline Sign orient2d(Vec2d a, Vec2d b, Vec2d c) {
  Matrix m;
  for (const Vec2d& p : {a, b, c}) m.push_back({p.x, p.y, 1});
  return static_cast<Sign>(determinant_sign(std::move(m)));
}
// Rows (p, 1): moving the column of ones to the front of 4 columns takes 3 swaps.
inline Sign orient3d(const Vec3d& a, const Vec3d& b, const Vec3d& c, const Vec3d& d) {
  Matrix m;
  for (const Vec3d& p : {a, b, c, d}) m.push_back({1, p.x, p.y, p.z});
  return static_cast<Sign>(determinant_sign(std::move(m)));
}
inline Sign in_circle(Vec2d a, Vec2d b, Vec2d c, Vec2d d) {
  Matrix m;
  for (const Vec2d& p : {a, b, c, d}) {
    const mpq_class x = p.x, y = p.y;
    m.push_back({x, y, x * x + y * y, 1});
  }
  return static_cast<Sign>(determinant_sign(std::move(m)));
}
inline Sign in_sphere(const Vec3d& a, const Vec3d& b, const Vec3d& c, const Vec3d& d,
                      const Vec3d& e) {
  Matrix m;
  for (const Vec3d& p : {a, b, c, d, e}) {
    const mpq_class x = p.x, y = p.y, z = p.z;
    m.push_back({1, x, y, z, x * x + y * y + z * z});
  }
  return -static_cast<Sign>(determinant_sign(std::move(m)));
}
inline Sign side_of_plane(const PlaneCoefficients& f, const Vec3d& p) {
  const mpq_class v = mpq_class(f.normal.x) * mpq_class(p.x) +
                      mpq_class(f.normal.y) * mpq_class(p.y) +
                      mpq_class(f.normal.z) * mpq_class(p.z) + mpq_class(f.offset);
  return static_cast<Sign>(sgn(v));
}
inline Sign compare_along(const Vec3d& d, const Vec3d& p, const Vec3d& q) {
  const mpq_class v = mpq_class(d.x) * (mpq_class(p.x) - mpq_class(q.x)) +
                      mpq_class(d.y) * (mpq_class(p.y) - mpq_class(q.y)) +
                      mpq_class(d.z) * (mpq_class(p.z) - mpq_class(q.z));
  return static_cast<Sign>(sgn(v));
}

}  // namespace veritope::oracle
