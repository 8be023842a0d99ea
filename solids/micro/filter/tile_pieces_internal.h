// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/micro/filter/tile_pieces_internal.h: parts of a tile's patches in space, each near the four images of its
// corners. Internal to solids/micro/filter.
#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "interval/box.h"
#include "solids/micro/filter/cell_net_internal.h"
#include "solids/micro/filter/tile_shape.h"

namespace veritope::internal {

/// The part of a patch over [at[a], at[a] + 1] / 2^level[a], a = 0, 1. That of a curve has the level 0 along its second
/// axis: the corners 0 and 2 are its begin, and 1 and 3 its end.
struct TilePiece {
  std::uint32_t patch = 0;
  std::array<std::uint64_t, 2> at{};
  std::array<int, 2> level{};
  /// Contain the images of its corners (0,0), (1,0), (0,1), (1,1).
  std::array<Box3, 4> corners;
  /// No point of the piece is farther, in any coordinate, from the bilinear patch of its exact corners: so the hull of
  /// the corners, grown by this much, contains the piece. bend[a]: what the second derivative along a contributes; a
  /// point of a side along a differs by no more than that from the segment.
  std::array<Point3d, 2> bend{};

  /// Parameters up to this level are doubles.
  static constexpr int kMaxLevel = 50;
  bool can_halve() const { return level[0] < kMaxLevel && level[1] < kMaxLevel; }
  int depth() const { return level[0] + level[1]; }
  /// A corner's parameter along an axis. REQUIRES corner < 4.
  Rational parameter(std::size_t axis, std::size_t corner) const {
    return Rational(at[axis] + (corner >> axis & 1)) * Rational::power_of_two(-level[axis]);
  }
};

/// All functions REQUIRE a live ScopedUpward.
class TilePieces {
 public:
  TilePieces(const CellNet& net, const TileShape& tile);

  const CellNet& net() const { return net_; }
  const TileShape& tile() const { return tile_; }
  /// Contain the images of the tile's corners.
  const std::vector<Box3>& corners() const { return corners_; }
  /// Computes the bounds on which root and halves depend. Separate, since corners often suffice. Returns false if a
  /// weight of the map may be 0, so that derivatives have no bounds.
  bool bound();
  /// The whole patch. REQUIRES bound().
  TilePiece root(std::uint32_t patch) const;
  /// Both parts, cut at the middle of the longer axis; the axis is returned, too. REQUIRES piece.can_halve().
  std::pair<TilePiece, TilePiece> halves(const TilePiece& piece, std::size_t* axis) const;

 private:
  const CellNet& net_;
  const TileShape& tile_;
  std::vector<Box3> corners_;
  std::vector<std::array<Point3d, 2>> bend_;
};

/// The hull of the corners, grown by this much in each coordinate, contains the piece.
Point3d excess_of(const TilePiece& piece);
/// A box around the piece.
Box3d box_of(const TilePiece& piece);

}  // namespace veritope::internal
