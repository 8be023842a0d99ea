// SPDX-License-Identifier: LGPL-3.0-or-later
// bench/surface_peers.h: what people use to make triangles of a field on a grid; its headers stay
// in its own file.
#pragma once
#include <array>
#include <vector>

#include "predicates/vec.h"
#include "solids/polyhedron/triangle_mesh.h"

namespace veritope::bench {

/// Values at the points of a grid of equal steps, those along x fastest.
struct FieldGrid {
  std::array<int, 3> size{};
  Vec3d origin{};
  double step = 0;
  std::vector<float> values;
};

struct PeerSurface {
  double ns = 0;  ///< of the filter alone, on one thread
  TriangleMesh mesh;
};

/// VTK's vtkFlyingEdges3D without normals, gradients and scalars: the contour of the value 0.
/// Facets turn to the side of smaller values.
#ifdef VERITOPE_BENCH_VTK
inline constexpr bool kHasFlyingEdges = true;
PeerSurface flying_edges(FieldGrid& grid);
#else
inline constexpr bool kHasFlyingEdges = false;
inline PeerSurface flying_edges(FieldGrid&) { return {}; }
#endif

}  // namespace veritope::bench
