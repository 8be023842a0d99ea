// SPDX-License-Identifier: LGPL-3.0-or-later
// topology/common_subdivision.h: octree cells of mixed levels as one regular cell complex. Integers only.
// Theory: docs/THEORY.md, COLLAR-1.
#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "robust/base/result.h"
#include "topology/octree_key_set.h"

namespace veritope {

/// The common subdivision of a set of octree cells: the coarsest regular cell complex with these 3-cells whose 2-cells
/// are squares.
///   faces     a face of a cell in which smaller faces of cells lie is split into quadrants, these likewise;
///   vertices  the corners of all faces (of the quadrants, where a face is split);
///   edges     every edge of every face, whatever cells it belongs to, split at each vertex that lies inside it. (Two
///             cells that touch only along edges of different length share the shorter one.)
/// The numbering does not depend on the program: cells ascend by code; vertices by (z, y, x); an edge is named by its
/// lower vertex and its direction, a face by its least corner and its normal: both ascend by (vertex, axis).
class CommonSubdivision {
 public:
  static constexpr std::uint32_t kNone = 0xffffffffu;
  /// Up to this number of faces all counts and incidences fit 32 bits.
  static constexpr std::uint32_t kMaxFaces = 1u << 26;

  struct Face {
    std::uint32_t below, above;  ///< cells on its two sides, along its normal; kNone for none
    std::uint32_t corner;        ///< the vertex with the least coordinates
    std::uint8_t axis;           ///< of its normal
    std::uint8_t level;          ///< its edge is 2^-level of the root's
    std::uint32_t num_cells() const { return (below != kNone) + (above != kNone); }
    /// REQUIRES num_cells() == 1.
    std::uint32_t only_cell() const { return below != kNone ? below : above; }
  };
  struct Edge {
    std::uint32_t lower, upper;  ///< vertices
  };

  /// @error kOverLimit if there are more than max_faces faces (the cap on memory: found before anything else is built).
  ///        REQUIRES max_faces <= kMaxFaces.
  /// @cost  O(n depth) time and memory for n cells (approximately 0.5 kB per cell in uniform levels).
  static Result<CommonSubdivision> build(OctreeKeySet cells, std::uint32_t max_faces = kMaxFaces);

  const OctreeKeySet& cells() const { return cells_; }
  std::uint32_t num_cells() const { return static_cast<std::uint32_t>(cells_.size()); }
  std::uint32_t num_faces() const { return static_cast<std::uint32_t>(faces_.size()); }
  std::uint32_t num_edges() const { return static_cast<std::uint32_t>(edges_.size()); }
  std::uint32_t num_vertices() const { return static_cast<std::uint32_t>(points_.size()); }

  std::span<const Face> faces() const { return faces_; }
  std::span<const Edge> edges() const { return edges_; }
  /// The faces of a cell, ascending; 6 or more.
  std::span<const std::uint32_t> faces_of_cell(std::uint32_t cell) const {
    return {cell_faces_.data() + cell_first_[cell], cell_faces_.data() + cell_first_[cell + 1]};
  }
  /// The edges of a face, side after side: the sides from its least corner, then the sides to its greatest; 4 or more.
  std::span<const std::uint32_t> edges_of_face(std::uint32_t face) const {
    return {face_edges_.data() + face_first_[face], face_edges_.data() + face_first_[face + 1]};
  }

  /// The coordinates, in units of the finest level that octrees have, each in [0, OctreeKey::kGrid].
  std::array<std::uint32_t, 3> point(std::uint32_t vertex) const {
    const std::uint64_t p = points_[vertex], mask = (std::uint64_t{1} << bits_) - 1;
    const auto at = [&](unsigned a) {
      return static_cast<std::uint32_t>(p >> (a * bits_) & mask) << up_;
    };
    return {at(0), at(1), at(2)};
  }
  /// The axis along which an edge runs.
  unsigned edge_axis(std::uint32_t edge) const {
    const std::uint64_t d = points_[edges_[edge].upper] ^ points_[edges_[edge].lower];
    return d >> (2 * bits_) != 0 ? 2 : d >> bits_ != 0 ? 1 : 0;
  }

 private:
  friend class SubdivisionBuilder;
  CommonSubdivision() = default;

  OctreeKeySet cells_;
  std::vector<Face> faces_;
  std::vector<Edge> edges_;
  std::vector<std::uint64_t>
      points_;  // z, y, x, bits_ bits each, in cells of the finest level that occurs
  std::vector<std::uint32_t> cell_first_, cell_faces_;  // compressed rows
  std::vector<std::uint32_t> face_first_, face_edges_;
  unsigned bits_ = 1, up_ = 0;
};

namespace internal {
/// For the files of this folder.
inline constexpr std::uint32_t kNone = CommonSubdivision::kNone;
}  // namespace internal

}  // namespace veritope
