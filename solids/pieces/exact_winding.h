// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/pieces/exact_winding.h: what a stretch of a piece's side contributes to a crossing number, in integers.
// Theory: docs/THEORY.md §4.
#pragma once
#include <array>
#include <cstdint>
#include <optional>

#include "solids/pieces/crossing_number.h"
#include "solids/pieces/exact_piece.h"

namespace veritope {

/// Axes of the projection along c+ - c-: `along` has the greatest difference, the others follow it.
struct ProjectionAxes {
  std::size_t i, j, along;
};

/// How often the part [from, to] / 2^bits of the side, in its direction of travel, crosses the half-line y = 0, x > 0
/// from below, counted as in docs/certificates/star-box.md, section 4. The result is empty if the curve meets the line
/// c- c+, or comes so near it that 64 halvings do not separate them.
std::optional<int> exact_winding(const ExactPiece& piece, const Patch& patch, std::uint32_t side,
                                 const CentreLine& centres, const ProjectionAxes& axes,
                                 std::uint64_t from, std::uint64_t to, int bits);

}  // namespace veritope
