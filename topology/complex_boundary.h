// SPDX-License-Identifier: LGPL-3.0-or-later
// topology/complex_boundary.h: is a union of octree cells a 3-manifold, and what is its boundary?
// Theory: docs/THEORY.md, COLLAR-1.K1, COLLAR-1.K2.
#pragma once
#include <cstdint>
#include <vector>

#include "topology/common_subdivision.h"

namespace veritope {

/// An edge with more than two boundary faces (octree cells: four).
struct BadEdge {
  std::uint32_t edge, num_faces;
};

/// A vertex whose boundary faces form several cycles.
struct BadVertex {
  std::uint32_t vertex, num_cycles;
};

/// Boundary faces connected through edges.
struct BoundaryComponent {
  std::uint32_t first_face;  ///< its least face; components are numbered by it
  std::uint32_t body;  ///< the body that it bounds; one of them, if the complex is not a manifold
  std::uint64_t vertices = 0, edges = 0, faces = 0;
  std::int64_t euler() const {
    return static_cast<std::int64_t>(vertices) - static_cast<std::int64_t>(edges) +
           static_cast<std::int64_t>(faces);
  }
  /// REQUIRES that the complex is a manifold: then the component is a closed orientable surface.
  std::int64_t genus() const { return 1 - euler() / 2; }
};

/// Cells connected through faces; if the complex is a manifold, these are the components of |K|.
struct Body {
  std::uint32_t first_cell;  ///< bodies are numbered by it
  std::uint64_t cells = 0;
};

struct ComplexBoundary {
  /// K1, edge clause: each edge lies in no or exactly two boundary faces. All exceptions, ascending.
  std::vector<BadEdge> bad_edges;
  /// K1, vertex clause: the boundary faces at each boundary vertex are connected through edges at it, so that they form
  /// one cycle if these edges are good. All exceptions, ascending. The ends of a bad edge are listed only if this
  /// clause fails there, too.
  std::vector<BadVertex> bad_vertices;
  bool is_manifold() const { return bad_edges.empty() && bad_vertices.empty(); }

  std::vector<BoundaryComponent> components;
  std::vector<std::uint32_t> component_of_face;  ///< kNone for a face between two cells
  std::vector<Body> bodies;
  std::vector<std::uint32_t> body_of_cell;

  /// The faces of a component, ascending.
  std::vector<std::uint32_t> faces_of(std::uint32_t component) const;
};

/// @cost O(size of the complex), apart from the inverse Ackermann function
ComplexBoundary analyse_boundary(const CommonSubdivision& complex);

}  // namespace veritope
