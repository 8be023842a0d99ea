// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/expression/flat_cone.h: the directions in which the boundary of a solid leaves one of its points, where it is
// flat.  Theory: docs/THEORY.md, POINT-6.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "interval/exact_box.h"
#include "solids/classify/point_answer.h"
#include "solids/expression/direction.h"
#include "solids/polyhedron/triangle_mesh.h"

namespace veritope {

/// A plane, a half-plane, or a sector of less than a half turn: the directions of one flat patch at a point of it.
struct Sector {
  Direction normal;  ///< on the outer side of the solid
  std::vector<Direction>
      inward;  ///< of each rim the normal in the plane, to the side of the sector; 0, 1 or 2
  /// From rim to rim, counter-clockwise around the normal, each less than a half turn after the one before; of a plane
  /// all around, and the last is the first.
  std::vector<Direction> rays;

  /// REQUIRES a direction in the sector's plane.
  bool contains(const Direction& d) const;
  /// Whether the open sector, without its rims, contains the direction. REQUIRES as contains.
  bool holds(const Direction& d) const;
};

/// The sectors of all flat patches at a point of the boundary of a solid: they meet in rims only.
using FlatCone = std::vector<Sector>;

/// Whether the solid holds points near the apex in this direction. REQUIRES a direction in none of the sectors.
bool is_inside(const FlatCone& cone, const Direction& d);

/// @param facets  all those of a valid mesh that contain the point; at least one
FlatCone flat_cone(const TriangleMesh& mesh, std::span<const std::uint32_t> facets,
                   const ExactPoint& point);
/// REQUIRES a point on the boundary of a box with positive sides.
FlatCone flat_cone(const ExactBox<3>& box, const ExactPoint& point);

}  // namespace veritope
