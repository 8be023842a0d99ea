// SPDX-License-Identifier: LGPL-3.0-or-later
// cli/bounding_box.h: the box of the vertices that faces use, for display.
#pragma once
#include <algorithm>

#include "solids/polyhedron/triangle_mesh.h"

namespace veritope::cli {

struct Box {
  Vec3d lo, hi;
};

/// REQUIRES at least one face.
inline Box bounding_box(const TriangleMesh& mesh) {
  Box box;
  box.lo = box.hi = mesh.positions[mesh.faces[0][0]];
  for (const auto& face : mesh.faces) {
    for (const auto v : face) {
      const Vec3d& p = mesh.positions[v];
      box.lo = {std::min(box.lo.x, p.x), std::min(box.lo.y, p.y), std::min(box.lo.z, p.z)};
      box.hi = {std::max(box.hi.x, p.x), std::max(box.hi.y, p.y), std::max(box.hi.z, p.z)};
    }
  }
  return box;
}

}  // namespace veritope::cli
