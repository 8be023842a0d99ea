// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/micro/filter/exact_contact_internal.h: pieces of a tile that touch facets, in rational numbers. Internal to
// solids/micro/filter.
#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "solids/micro/filter/mesh_model_internal.h"
#include "solids/micro/filter/tile_pieces_internal.h"

namespace veritope::internal {

/// Points whose hull contains a piece, and what else is exact about it.
struct ExactControl {
  std::vector<ExactPoint> points;
  std::vector<Point3d> approx;
  std::array<ExactPoint, 4> corners;  ///< of the piece, in the cycle (0,0), (1,0), (1,1), (0,1)
  /// The sides' control points lie on the segments between the corners, all of them in a plane, and the corners are a
  /// convex quadrilateral: the piece covers it, and nothing else.
  bool is_flat = false;
  ExactPoint normal;  ///< of a flat piece
  /// All control points lie on the segment between the corners 0 and 2: the piece covers it, and nothing else.
  bool is_straight = false;
};

/// The exact map of a tile's patches in one cell, composed on demand.
class ExactPatches {
 public:
  ExactPatches(const CellMap& cell, const TileShape& tile) : cell_(cell), tile_(tile) {}

  /// The number of control points of a patch in the cell.
  std::size_t num_points(std::uint32_t patch) const;
  /// The hull of the whole cell's control points: cheap, and enough where a wall of the cage lies in a facet's plane.
  /// Both return nothing if a weight is not positive.
  std::optional<ExactControl> around(const TilePiece& piece);
  /// The piece's own control points.
  std::optional<ExactControl> control(const TilePiece& piece);

 private:
  void restrict_map();

  const CellMap& cell_;
  const TileShape& tile_;
  std::optional<BezierVolume<Rational>> map_;
  std::optional<ExactControl> around_;
  std::vector<std::optional<BezierSurface<Rational>>> patches_;
};

/// Whether planes through facets, along the axes, or along an edge of the piece and one of the facet, separate the hull
/// of the control points from each of the facets, perhaps touching both; and on which side of M the piece lies then.
/// `contact` is set to a point that the piece and a facet have in common, if one is found.
/// The rule. Let the hull H of the control points lie in closed half-spaces h_i, the facets that are not strictly apart
/// from H in the closures of their complements, and let z be a point of all open h_i such that all other facets miss
/// the hull of the piece and z. Then a segment from a point of the piece to z, without its begin, misses the surface of
/// M, and so every point of the piece is a limit of points that lie on z's side.
/// @cost rationals: for few pieces
PieceSide exact_side(const MeshModel& model, const TilePiece& piece, const ExactControl& control,
                     std::span<const std::uint32_t> facets, std::optional<ExactPoint>* contact);

}  // namespace veritope::internal
