// SPDX-License-Identifier: LGPL-3.0-or-later
// tests/support/complex_oracle.h: the common subdivision of octree cells, K1, Euler characteristics and collapses,
// computed as THEORY words them, with sets of squares and all pairs; and vertex links on a voxel grid. For a few
// hundred cells.
#pragma once
#include <array>
#include <cstdint>
#include <set>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "topology/octree_key.h"

namespace veritope::oracle {

using GridPoint = std::array<int, 3>;  // in cells of the finest level that occurs

/// Which vertices split an edge of a face.
enum class EdgeRule {
  kEveryVertex,  ///< THEORY 2
  kFaceNeighbours,  ///< wrong: only corners of faces of the face's own cells and of those that share a face with them
};

struct GridSquare {
  unsigned axis;
  GridPoint low;
  int size;
  auto operator<=>(const GridSquare&) const = default;
};

struct BruteComplex {
  std::vector<GridPoint> vertices;                     // ascending
  std::vector<std::pair<GridPoint, GridPoint>> edges;  // lower and upper end, ascending
  std::vector<GridSquare> faces;                       // ascending
  std::vector<std::set<std::size_t>> face_edges, face_cells, cell_faces;

  /// Edges with a number of boundary faces that is neither 0 nor 2.
  std::vector<std::size_t> bad_edges() const;
  /// Vertices whose boundary faces are not connected through boundary edges at the vertex.
  std::vector<std::size_t> bad_vertices() const;
  std::vector<std::set<std::size_t>> boundary_components() const;
  /// V - E + F of the closure of these faces.
  int euler(const std::set<std::size_t>& faces) const;
  /// Vertices, edges, faces, cells outside the closure of d_plus that a greedy collapse leaves.
  std::array<std::size_t, 4> collapse(const std::set<std::size_t>& d_plus) const;
};

BruteComplex brute_complex(std::span<const OctreeCell> cells, EdgeRule rule);

/// K1 by links on the grid of the finest level: at each grid point, the occupied ones of the 8 voxels around it.
struct VoxelLinks {
  /// Unit edges (lower end, axis) around which two voxels are occupied, diagonally.
  std::set<std::pair<GridPoint, unsigned>> bad_edges;
  /// Points without such an edge whose occupied voxels, or whose empty ones, are not connected through faces.
  std::set<GridPoint> bad_points;
};
VoxelLinks voxel_links(std::span<const OctreeCell> cells);

}  // namespace veritope::oracle
