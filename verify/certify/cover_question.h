// SPDX-License-Identifier: LGPL-3.0-or-later
// verify/certify/cover_question.h: why a search for star boxes ended without a cover, as a finding: two sheets that run
// near each other are named with both patches and their distance.
#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "solids/base/finding.h"
#include "verify/certify/star_cover.h"

namespace veritope {

/// A part of a patch of a complex: bounds of its parameters, exact; u and v of a tensor patch, the three barycentric
/// coordinates of a triangle.
struct PatchPart {
  std::uint32_t patch = 0;
  std::vector<std::array<double, 2>> parameters;
};
PatchPart part_of_piece(const PieceForest& forest, PieceForest::Id piece);

struct CoverQuestion {
  /// The code is one of open_code; place.patch, place.shell and place.box are set.
  Finding finding;
  /// The two sheets whose approximate distance is finding.witness.approx_distance; empty if sheets that are near each
  /// other were not what prevented a box.
  std::vector<PatchPart> facing;
};
/// REQUIRES a cover that is not complete, of this forest.
CoverQuestion cover_question(PieceForest& forest, const StarCover& cover);

/// The reason for UncoveredPiece::Why::kTooFine.
extern const char* const kOutOfRangeText;

}  // namespace veritope
