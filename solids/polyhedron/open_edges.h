// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/polyhedron/open_edges.h: the open edges of a mesh: the borders that they form, and which of these are cracks.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "solids/polyhedron/edge_gap.h"
#include "solids/polyhedron/nearest_edges.h"
#include "solids/polyhedron/triangle_mesh.h"
#include "topology/incidence.h"

namespace veritope {

/// An edge of one face only (rule M3), in the direction in which the face runs along it.
struct OpenEdge {
  std::uint32_t a = 0, b = 0;
  std::uint32_t face = 0;
  friend bool operator==(const OpenEdge&, const OpenEdge&) = default;
};

/// All of them, in ascending order of (lesser vertex, greater vertex), as SurfaceTopology lists the first ones.
/// Collapsed faces have none. REQUIRES incidence built from mesh.faces. The result does not depend on jobs. @cost O(F)
std::vector<OpenEdge> list_open_edges(const TriangleMesh& mesh, const Incidence& incidence,
                                      unsigned jobs);

inline EdgeEnds ends_of(const TriangleMesh& mesh, const OpenEdge& e) {
  return {mesh.positions[e.a], mesh.positions[e.b]};
}

struct OpenEdges {
  std::vector<NearestEdge> nearest;  ///< of each edge of the list, among those of the list
  std::uint64_t borders = 0;         ///< classes of open edges by common vertices
  /// Borders that are no cracks: none of their edges is near another one, and no other edge is near one of theirs.
  std::uint64_t holes = 0;
  std::uint64_t near_edges = 0;  ///< is_near
  /// is_touching: the edges of a crack without a gap. They would have other faces if vertices were merged or inserted.
  std::uint64_t touching_edges = 0;
  std::uint64_t unsearched_edges = 0;  ///< not is_searched
  /// The least and the greatest gap of a near edge, rounded to nearest; 0 if no edge is near. Gaps that differ by less
  /// than 2^-39 of themselves may stand for each other here.
  double least_gap = 0, greatest_gap = 0;
};

/// The most steps of each search among so many edges: the fewer edges, the more, from 2^20 for some tens of edges to
/// 256 for 131,072 and more, so that all searches together take some seconds at the most.
std::uint32_t search_steps(std::size_t num_edges);

/// Edges of length 0 (two vertices at one point) are parts of borders, but are not near any edge. The result does not
/// depend on jobs, and on the order of the edges as little as that of find_nearest_edges.
/// REQUIRES finite coordinates, vertex ids in range, fewer than 2^30 edges, none of them twice.
/// @cost  that of find_nearest_edges, and O(V)
OpenEdges analyse_open_edges(const TriangleMesh& mesh, std::span<const OpenEdge> edges,
                             unsigned jobs);

}  // namespace veritope
