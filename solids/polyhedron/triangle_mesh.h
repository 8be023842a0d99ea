// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/polyhedron/triangle_mesh.h: the triangles that a file means (docs/certificates/reading-rule-1.md), as plain
// arrays.
#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "predicates/vec.h"

namespace veritope {

/// Positions and triangles with vertex ids 0..positions.size()-1. Nothing is promised about validity; every
/// coordinate is finite and every id in range when a reader returned it. No coordinate is -0.
struct TriangleMesh {
  std::vector<Vec3d> positions;
  std::vector<std::array<std::uint32_t, 3>> faces;
};

}  // namespace veritope
