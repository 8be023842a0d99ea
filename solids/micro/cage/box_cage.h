// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/micro/cage/box_cage.h: a box as one cell with a control net that can be bent.
// Source: seed paper 003, section 3 and figures 4a, 5 and 6a.
#pragma once
#include <array>
#include <cstdint>

#include "robust/base/result.h"
#include "solids/micro/cage/cage_content.h"
#include "solids/volumes/cell_maps.h"

namespace veritope {

/// The degree along each axis, and the number of knot spans.
struct CageGrid {
  std::array<int, 3> degrees{1, 1, 1};
  std::array<std::uint64_t, 3> spans{1, 1, 1};
};

/// The greatest degree of cages that follow fields (fit_cage.h).
inline constexpr int kMaxFitDegree = 7;
/// The most knot spans along an axis.
inline constexpr std::uint64_t kMaxCageSpans = 4096;

/// The knots 0, 1, ..., spans: those at the ends degree + 1 times, the inner ones once. REQUIRES a grid that
/// check_cage_grid accepts.
KnotAxis<Rational> cage_axis(const CageGrid& grid, std::size_t axis);

/// @error kBadArgument for a degree that is not from 1 to kMaxCellDegree, or a number of spans that is not from 1 to
///        kMaxCageSpans; kOverLimit for more than kMaxCellNumbers coefficients. The message begins with "degrees" or
///        "spans".
Status check_cage_grid(const CageGrid& grid);

/// The cell over the domain [0, spans] along each axis, u, v and w along x, y and z. Control points lie at the Greville
/// abscissae: the map is affine, exactly.
/// @error kBadArgument unless min < max in each coordinate; as check_cage_grid
Result<CellVolume> box_cage(const CageBox& box, const CageGrid& grid);

}  // namespace veritope
