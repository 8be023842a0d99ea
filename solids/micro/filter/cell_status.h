// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/micro/filter/cell_status.h: how the tile of one cell lies with respect to a solid, and what shows it.
#pragma once
#include <cstdint>
#include <optional>

#include "solids/classify/point_answer.h"

namespace veritope {

/// Let M be the solid, as a closed set, and A the tile in space: a body, or the union of curves and sheets.
enum class CellStatus : std::uint8_t {
  kKept,      ///< A lies in the interior of M: proved
  kCrossing,  ///< A has points in the interior of M and points off M: both are exhibited
  kTouching,  ///< the boundaries meet in an exhibited point, and A lies in M, or A and the interior of M are disjoint
  kOutside,   ///< A and M are disjoint: proved
  kUndecided,  ///< nothing of this was proved within the limits
};

/// "kept", "crossing", "touching", "outside", "undecided".
constexpr const char* cell_status_name(CellStatus status) {
  switch (status) {
    case CellStatus::kKept: return "kept";
    case CellStatus::kCrossing: return "crossing";
    case CellStatus::kTouching: return "touching";
    case CellStatus::kOutside: return "outside";
    default: return "undecided";
  }
}

/// The point map(patch(u, v)) of a tile's surface.
struct TilePatchPoint {
  std::uint32_t patch = 0;
  Rational u, v;
  friend bool operator==(const TilePatchPoint&, const TilePatchPoint&) = default;
};

/// A status with its witnesses. Crossing: `inside` and `off`, or one of them and `vertex`: the boundary of M passes
/// through the interior of the tile there, so that points on either side of it are near. Touching: `contact`.
struct CellFinding {
  CellStatus status = CellStatus::kUndecided;
  std::optional<TilePatchPoint> inside;  ///< a point in the interior of M
  std::optional<TilePatchPoint> off;     ///< a point off M
  std::optional<std::uint32_t> vertex;   ///< a vertex of M in the interior of the tile
  std::optional<ExactPoint> contact;     ///< a point of both boundaries
};

}  // namespace veritope
