// SPDX-License-Identifier: LGPL-3.0-or-later
// tests/support/approx_distance.h: distances of points in binary64, up to a few roundings.
#pragma once
#include <algorithm>
#include <cmath>

#include "solids/polyhedron/triangle_mesh.h"

namespace veritope::approx {

inline Vec3d minus(const Vec3d& a, const Vec3d& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline double dot(const Vec3d& a, const Vec3d& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline double length(const Vec3d& a) { return std::sqrt(dot(a, a)); }

inline double distance_to_segment(const Vec3d& p, const Vec3d& a, const Vec3d& b) {
  const Vec3d e = minus(b, a), w = minus(p, a);
  const double ee = dot(e, e), t = ee > 0 ? std::clamp(dot(w, e) / ee, 0.0, 1.0) : 0;
  return length({w.x - t * e.x, w.y - t * e.y, w.z - t * e.z});
}
inline double distance_to_triangle(const Vec3d& p, const Vec3d& a, const Vec3d& b, const Vec3d& c) {
  const double rim = std::min(
      {distance_to_segment(p, a, b), distance_to_segment(p, b, c), distance_to_segment(p, c, a)});
  const Vec3d e = minus(b, a), f = minus(c, a), w = minus(p, a);
  const double ee = dot(e, e), ef = dot(e, f), ff = dot(f, f), we = dot(w, e), wf = dot(w, f);
  const double det = ee * ff - ef * ef, s = (we * ff - wf * ef) / det,
               t = (wf * ee - we * ef) / det;
  if (!(s >= 0 && t >= 0 && s + t <= 1)) return rim;
  return std::min(
      rim, length({w.x - s * e.x - t * f.x, w.y - s * e.y - t * f.y, w.z - s * e.z - t * f.z}));
}
inline double distance_to_mesh(const Vec3d& p, const TriangleMesh& mesh) {
  double least = 1e300;
  for (const auto& f : mesh.faces)
    least = std::min(least, distance_to_triangle(p, mesh.positions[f[0]], mesh.positions[f[1]],
                                                 mesh.positions[f[2]]));
  return least;
}

}  // namespace veritope::approx
