// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/micro/jack.h: the tile of figure 2 of [HPE22]: a cube with six arms.
#pragma once
#include <array>
#include <cstdint>
#include <optional>

#include "robust/base/result.h"
#include "solids/micro/micro_tile.h"

namespace veritope {

struct JackShape {
  Rational node =
      Rational(1) / Rational(5);  ///< half the edge of the cube in the middle, in (0, 1/2)
  Rational cap = Rational(1) / Rational(8);  ///< half the edge of each arm's end, in (0, 1/2)
  /// 1: each arm is a frustum. 3: its profile is (node, node, cap, cap), so that arms of neighbours join with one
  /// tangent plane.
  int degree = 3;
  /// A bit for each wall 2 axis + end to which an arm reaches; the cube is closed on the other sides.
  unsigned arms = 63;
  /// If set, `cap` is not used: half the edge of each end is the number of its wall, in this range of 2^-20, inside
  /// (0, 1/2).
  std::optional<std::array<std::int32_t, 2>> range;
};

/// Four patches and a cap for each arm, in the order of the walls; a patch for each side without an arm.
/// @error kBadArgument: a number outside of its range, with its value
Result<MicroTile> jack_tile(const JackShape& shape);

}  // namespace veritope
