// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/micro/cage/radial_cage.h: rings, discs and sectors about an axis as one cell.
// Source: seed paper 003, figure 4c. Gluing and the collapsed axis: docs/THEORY.md, VMODEL-1.
#pragma once
#include <cstddef>
#include <optional>

#include "robust/base/result.h"
#include "solids/micro/cage/cage_content.h"
#include "solids/volumes/axis_turn.h"
#include "solids/volumes/cell_maps.h"

namespace veritope {

/// Points at a distance from `inner` to `outer` from the axis, whose places along it, measured from axis.point, are
/// from `low` to `high`. Lengths are in model units.
struct RadialShape {
  TurnAxis axis{{}, {Rational(0), Rational(0), Rational(1)}};
  /// Where the angle begins: the half plane of the axis that this direction points to. Nothing: the coordinate
  /// direction that is farthest from the axis's, the first one on a tie.
  std::optional<CellPoint> start;
  Rational inner, outer, low, high;
  std::optional<Rational> degrees;  ///< of a sector; nothing: a full turn
};

struct RadialCage {
  CellVolume cell;
  Rational angle_error;  ///< of a sector: its exact angle is at most so many degrees from `degrees`
};

/// u outwards, v around the axis, w along it: degrees 1, 2, 1; circles are exact, arcs of at most 100 degrees over
/// intervals of length 1. A full turn is glued to itself: the faces v0 and v1 are equal. With inner = 0 the face u0 is
/// collapsed onto the axis, and N = 0 on it (THEORY 7). Where a length along or across the axis is irrational in terms
/// of its direction, the cell is larger than the shape, by at most 2^-40 of the length.
/// @error kBadArgument unless 0 <= inner < outer, low < high and 0 < degrees < 360; for the direction 0, and a start
///        along the axis. The message begins with the name of the member.
Result<RadialCage> radial_cage(const RadialShape& shape);

/// Sets `outer`, `low` and `high` to the smallest that contain all hulls, grown by `margin` (a length), and rounded
/// outward by at most 2^-40 of a length. REQUIRES a part, margin >= 0.
/// @error kBadArgument for the direction 0
Result<RadialShape> radial_shape_around(const CageContent& content, RadialShape shape,
                                        const Rational& margin);

/// A point of the content that is nearer to the axis than `inner`, exactly: the shape does not contain it. Nothing: no
/// corner of a part is. REQUIRES a direction that is not 0.
std::optional<std::size_t> first_in_hole(const CageContent& content, const RadialShape& shape);

}  // namespace veritope
