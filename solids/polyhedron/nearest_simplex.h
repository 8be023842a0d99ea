// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/polyhedron/nearest_simplex.h: the point of a simplex that is nearest to the origin, for searches of directions
// in floating point. Source: [GJK88].
#pragma once
#include <array>
#include <cstddef>

#include "predicates/vec.h"

namespace veritope::internal {

/// A simplex of at most four points. It is a heuristic: nothing may rely on its rounding.
class NearestSimplex {
 public:
  /// REQUIRES at most three points before: nearest() leaves no more.
  void add(const Vec3d& p) { at_[static_cast<std::size_t>(size_++)] = p; }
  /// Reduces the simplex to the face that holds the nearest point; false if it contains the origin. REQUIRES a point.
  bool nearest(Vec3d& out);

 private:
  Vec3d on_edge(int i, int j);
  Vec3d on_triangle(int i, int j, int k);
  bool on_tetrahedron(Vec3d& out);
  void keep();

  std::array<Vec3d, 4> at_{};
  int size_ = 0;
  unsigned kept_ = 0;
};

}  // namespace veritope::internal
