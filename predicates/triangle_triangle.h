// SPDX-License-Identifier: LGPL-3.0-or-later
// predicates/triangle_triangle.h: do two facets of a mesh meet as facets of a mesh may?
// Source: the interval comparison of [GD03], with the shared vertex and edge worked out in
// triangle_triangle.cc.
#pragma once
#include <array>
#include <cstdint>

#include "predicates/vec.h"
#include "robust/cascade.h"

namespace veritope {

/// A triangle whose corners have names. Corners of two triangles are the same vertex iff their ids
/// are equal; different ids may have equal coordinates.
struct IndexedTriangle {
  std::array<Vec3d, 3> point;
  std::array<std::uint32_t, 3> id;
};

/// What the intersection of two closed triangles is. Their common simplex is what the common ids
/// span: nothing, a vertex, an edge, or the whole triangle.
enum class TriangleContact : std::uint8_t {
  kDisjoint,      ///< empty; no common id
  kSharedVertex,  ///< exactly the one common vertex
  kSharedEdge,    ///< exactly the common edge
  kImproper,  ///< planes differ, and it has a point outside the common simplex: crossing or mere touching
  kCoplanarOverlap,  ///< one plane, and it has a point outside the common simplex: overlap or mere touching
  kIdentical,  ///< the same three ids, in any order
};

/// Is this contact allowed between two facets of an embedded mesh?
constexpr bool is_proper(TriangleContact c) {
  return c == TriangleContact::kDisjoint || c == TriangleContact::kSharedVertex ||
         c == TriangleContact::kSharedEdge;
}

/// The exact classification. Symmetric in t and u; it does not depend on the order of the corners.
/// REQUIRES finite coordinates; both triangles non-degenerate (not collinear); the ids of one
/// triangle distinct; equal ids have equal coordinates. `tally` counts the tiers of the
/// orientations asked for.
TriangleContact triangle_triangle(const IndexedTriangle& t, const IndexedTriangle& u,
                                  TierCounts* tally = nullptr) noexcept;

}  // namespace veritope
