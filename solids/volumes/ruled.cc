// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/volumes/ruled.h"

#include <utility>

#include "solids/volumes/placed.h"

namespace veritope {

Result<CellVolume> extruded(const CellSurface& surface, const CellPoint& vector) {
  if (vector == CellPoint{}) return bad_argument("vector must not be 0");
  if (const Status in = check_cell_surface(surface); !in) return in.error();
  return ruled(surface, placed(surface, translation(vector)));
}

Result<CellVolume> ruled(const CellSurface& a, const CellSurface& b) {
  for (const CellSurface* s : {&a, &b})
    if (const Status in = check_cell_surface(*s); !in) return in.error();
  const auto rows = in_one_space<2>({a, b}, kMaxCellNumbers / 2);
  if (!rows) return rows.error();
  return stacked(*rows, unit_axis(1));
}

}  // namespace veritope
