// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/micro/cage/hull_cage.h: a box whose control net is pulled towards a model, as far as that can be proved.
// Source: seed paper 003, figure 6c.
#pragma once
#include <cstdint>

#include "robust/base/result.h"
#include "solids/micro/cage/box_cage.h"
#include "solids/micro/cage/cage_content.h"
#include "solids/volumes/cell_maps.h"

namespace veritope {

/// The most knot spans of a hull, in all.
inline constexpr std::uint64_t kMaxHullSpans = std::uint64_t{1} << 15;

struct HullCageOptions {
  CageGrid grid{{1, 1, 1}, {4, 4, 4}};
  /// The length that control points of the border keep from the model, in model units; > 0.
  Rational margin;
  int rounds = 12;  ///< at most; 0: the box
};

struct HullCage {
  CellVolume cell;
  std::uint64_t rounds = 0;     ///< after which the cage was proved
  std::uint64_t shortened = 0;  ///< steps of control points that were halved
};

/// Begins with the box of the content, grown by the margin. In each round every control point of the border moves along
/// the line to the place of the content nearest to it, halfway to the margin; moves are evened out over neighbours in
/// the net, which is straightened a little, and inner control points follow by the Boolean sum of these moves.
/// Steps are halved, at most 20 times, where a patch of the border is not proved disjoint from the content, or where
/// det J falls below a 64th of the box's. After each round the whole is proved: det J > 0 (jacobian_sign.h), and the
/// content is inside (cage_containment.h, if the map is one to one, which is left to the certifier); a round that
/// cannot be proved is undone and is the last. Control points are multiples of a power of two near a 2^16th of the
/// diagonal.
/// Nets of degree 1 get tightest: the map of a higher degree is smooth across lines of the net, and det J vanishes
/// where edges of the box become flat.
/// @error kBadArgument unless margin > 0, and for content without a part; as check_cage_grid; kOverLimit for more
///        than kMaxHullSpans spans, and for content that is 2^34 times as far from the origin as it is large
Result<HullCage> hull_cage(const CageContent& content, const HullCageOptions& options);

}  // namespace veritope
