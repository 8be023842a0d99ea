// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/collar/facing.h: in which of a few directions do the normals of a piece point? A hint for searches.
#pragma once
#include <cstdint>
#include <vector>

#include "solids/pieces/piece_forest.h"

namespace veritope {

/// A set of the 26 directions from a cube's middle to its corners, edges and faces: those in which a surface faces.
using Facing = std::uint32_t;
inline constexpr Facing kAllDirections = (Facing{1} << 26) - 1;

/// The directions with which the coefficients of a piece's normals, as approximate numbers, have a positive product,
/// not too small. The intersection over several pieces is not empty if their normals lie in a cone of half-angle
/// approximately 60 degrees: there they are one sheet without a fold, or sheets that face alike.
class FacingOfPieces {
 public:
  explicit FacingOfPieces(PieceForest& forest) : forest_(forest) {}
  Facing of(PieceForest::Id id);
  /// The directions in which the parts of the piece that meet the box face; the piece is cut until no part is much
  /// longer than half of the box.
  Facing of_part(PieceForest::Id id, const Box3d& box);

 private:
  Facing compute(PieceForest::Id id);
  static constexpr Facing kUnknown = ~Facing{0};
  PieceForest& forest_;
  std::vector<Facing> known_;
};

}  // namespace veritope
