// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/micro/filter/exact_contact_internal.h: pieces of a tile that touch facets, in rational numbers. Internal to
// solids/micro/filter.
#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "solids/micro/filter/filter_model_internal.h"
#include "solids/micro/filter/tile_pieces_internal.h"

namespace veritope::internal {

/// What is known of a piece of the tile's surface. Both may hold of a piece that lies in the plane of a facet.
struct PieceSide {
  bool is_decided = false;
  bool is_apart = false;  ///< from the surface of M
  bool is_near_inside =
      false;  ///< every point of the piece is a limit of points in the interior of M
  bool is_near_outside = false;  ///< every point of the piece is a limit of points off M
};

/// The exact map of a tile's patches in one cell, composed on demand.
class ExactPatches {
 public:
  ExactPatches(const CellMap& cell, const TileShape& tile) : cell_(cell), tile_(tile) {}

  /// The piece as a map of [0,1]^2.
  BezierSurface<Rational> piece(const TilePiece& piece);

 private:
  const CellMap& cell_;
  const TileShape& tile_;
  std::optional<BezierVolume<Rational>> map_;
  std::vector<std::optional<BezierSurface<Rational>>> patches_;
};

/// Whether planes through facets, along the axes, or along an edge of the piece and one of the facet, separate the hull
/// of the piece's control points from each of the facets, perhaps touching both; and on which side of M the piece lies
/// then. `contact` is set to a point that the piece and a facet have in common, if one is found.
/// The rule. Let the piece's hull H lie in closed half-spaces h_i, the facets that are not strictly apart in the closures
/// of their complements, and let z be a point of all open h_i such that all other facets miss the hull of H and z. Then
/// the half-open segments from H to z, without H, miss the surface of M, and so every point of H is a limit of points
/// that lie on z's side.
/// @cost rationals of the composed degree: for few pieces
PieceSide exact_side(const TileFilter::Model& model, const TilePiece& piece,
                     const BezierSurface<Rational>& exact, std::span<const std::uint32_t> facets,
                     std::optional<ExactPoint>* contact);

}  // namespace veritope::internal
