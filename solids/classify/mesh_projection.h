// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/classify/mesh_projection.h: the nearest points of a mesh to a point, all of them, exactly.
#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "solids/base/range_tree.h"
#include "solids/classify/point_answer.h"
#include "solids/polyhedron/triangle_mesh.h"

namespace veritope {

/// The cell of a mesh whose relative interior holds a point.
enum class MeshFeature : std::uint8_t { kVertex, kEdge, kFacet };

struct NearestPoint {
  ExactPoint point;
  MeshFeature feature = MeshFeature::kFacet;
  std::uint32_t facet = 0;  ///< the least facet that has the point at this distance
  /// The corner of that facet that the point is (kVertex), or where the edge begins (kEdge); else 0.
  std::uint32_t corner = 0;
  friend bool operator==(const NearestPoint&, const NearestPoint&) = default;
};

struct MeshProjectionAnswer {
  Rational squared_distance;
  /// All points of the mesh at this distance, each once, in lexicographic order: the first one is the answer where one
  /// is wanted, and more than one is a tie. At most one a facet.
  std::vector<NearestPoint> nearest;
  bool is_tie() const { return nearest.size() > 1; }
};

/// Projects points onto one mesh, closed or not. Immutable: threads may share it.
class MeshProjection {
 public:
  /// REQUIRES finite coordinates, ids in range, at least one face and fewer than 2^30, none of which is degenerate. The
  /// mesh must outlive it.  @cost near-linear in the facets; approximately 150 bytes a facet
  explicit MeshProjection(const TriangleMesh& mesh);
  explicit MeshProjection(TriangleMesh&&) = delete;

  /// @cost the facets whose distance is the least one but for rounding are examined in rationals, usually those around
  ///       one point; a tree of boxes excludes the others
  MeshProjectionAnswer project(const ExactPoint& point) const;

 private:
  const TriangleMesh* mesh_;
  std::vector<std::uint32_t> order_;
  RangeTree<Box3d> tree_;
};

}  // namespace veritope
