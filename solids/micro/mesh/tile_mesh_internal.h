// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/micro/mesh/tile_mesh_internal.h: the surface of a tile, each patch cut into a grid of quadrilaterals: vertices
// in groups that cells can share, and where they lie in the unit cube. Internal to solids/micro/mesh.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "interval/box.h"
#include "solids/micro/mesh/mesh_lanes_internal.h"
#include "solids/micro/tile_analysis.h"

namespace veritope::internal {

/// Into how many parts the parameters u and v of a patch are cut. Sides 0 and 2 of a patch have parts[0], the others
/// parts[1].
using PatchParts = std::array<std::uint32_t, 2>;

/// Vertices of a quadrilateral at (u, v) = (0, 0), (1, 0), (1, 1), (0, 1) of its part. Two neighbours are equal where a
/// side is collapsed.
using TileQuad = std::array<std::uint32_t, 4>;
using TileTriangle = std::array<std::uint32_t, 3>;
/// Its triangles: two, or one if two neighbours are equal. Returns their number.
std::size_t triangles_of(const TileQuad& quad, std::array<TileTriangle, 2>& out);

/// Vertices are numbered group by group: group 0 off all caps, 2 c + 1 on the rim of cap c, 2 c + 2 inside of it.
class TileMesh {
 public:
  /// REQUIRES that sides that are glued have one number of parts, and that this number is at least 2 for the sides
  /// between two collapsed ones. REQUIRES a live ScopedUpward.
  TileMesh(const AnalysedTile& tile, std::vector<PatchParts> parts);

  const std::vector<PatchParts>& parts() const { return parts_; }
  std::uint32_t num_vertices() const { return group_begin_.back(); }
  std::size_t num_groups() const { return group_begin_.size() - 1; }
  std::uint32_t group_begin(std::size_t group) const { return group_begin_[group]; }
  std::uint32_t group_size(std::size_t group) const {
    return group_begin_[group + 1] - group_begin_[group];
  }
  static constexpr std::size_t rim_of_cap(std::size_t cap) { return 2 * cap + 1; }
  static constexpr std::size_t inside_of_cap(std::size_t cap) { return 2 * cap + 2; }

  /// The vertex number i, of 0 to the number of parts, along side 4 patch + s in its direction.
  std::uint32_t vertex_of_side(std::uint32_t side, std::uint32_t i) const;

  /// The triangles of a patch; all patches one after the other.
  const std::vector<TileTriangle>& triangles() const { return triangles_; }
  std::uint32_t first_triangle(std::size_t patch) const { return first_triangle_[patch]; }
  /// The quadrilaterals of a patch that have four corners.
  const std::vector<TileQuad>& quads() const { return quads_; }
  std::uint32_t first_quad(std::size_t patch) const { return first_quad_[patch]; }

  /// Where a vertex lies in the cell's cube, if its walls have these numbers.
  Box3 position(std::uint32_t vertex, const WallNumbers& numbers) const;
  /// The same for all vertices, approximate, with a bound of the error.
  const PointTable& points() const { return table_; }

  /// A patch that needs more parts so that the triangles are those of a surface, also where caps are dropped and rims
  /// are shared; kNoPatch if all have enough. `strictness` 1: where two tiles share two pairs of caps; 2: where a tile
  /// shares caps with itself.
  static constexpr std::uint32_t kNoPatch = 0xffffffff;
  std::uint32_t patch_with_too_few_parts(int strictness) const;

 private:
  void number_vertices();
  void place_vertices();
  void fill_table();
  void add_facets();
  std::uint32_t vertex_at(std::uint32_t patch, std::uint32_t i, std::uint32_t j) const;
  std::size_t group_of_vertex(std::uint32_t vertex) const;

  const AnalysedTile& tile_;
  std::vector<PatchParts> parts_;
  std::vector<std::uint32_t> group_begin_;
  std::vector<std::uint32_t> corner_, side_,
      inner_;  // the first vertex: of corners, by classes; of sides; of patches
  std::vector<TileTriangle> triangles_;
  std::vector<TileQuad> quads_;
  std::vector<std::uint32_t> first_triangle_, first_quad_;
  // By vertices: the wall on whose number it depends, or 6; and where its list of points begins, one for each power.
  std::vector<std::uint8_t> wall_;
  std::vector<std::uint32_t> first_point_;
  std::vector<Box3> points_;
  PointTable table_;
};

}  // namespace veritope::internal
