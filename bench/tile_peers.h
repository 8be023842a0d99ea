// SPDX-License-Identifier: LGPL-3.0-or-later
// bench/tile_peers.h: what people use to filter triangulated tiles against a mesh; its headers stay in its own file.
#pragma once
#include <array>
#include <memory>
#include <vector>

#include "solids/polyhedron/triangle_mesh.h"

namespace veritope::bench {

enum class PeerStatus { kInside, kCrossing, kOutside };

/// CGAL's AABB_tree and Side_of_triangle_mesh over EPICK: whether a triangle of the tile meets a facet, else on which
/// side one of its points lies. Tiles that touch are crossing here, and bubbles inside a tile are not seen.
class CgalTiles {
 public:
  explicit CgalTiles(const TriangleMesh& mesh);
  ~CgalTiles();
  CgalTiles(const CgalTiles&) = delete;
  PeerStatus operator()(const std::vector<std::array<Vec3d, 3>>& triangles) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace veritope::bench
