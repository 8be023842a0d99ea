// SPDX-License-Identifier: LGPL-3.0-or-later
// topology/v_complex_edit.h: changes of a V-complex that keep its invariants. Each edit returns an error (kBadArgument,
// with a sentence that names an element) and changes nothing where it would break one; ids of other elements stay.
// Elements that an argument names must exist; if not, that is the error.
#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "robust/base/result.h"
#include "topology/v_complex.h"
#include "topology/v_complex_data.h"

namespace veritope {

/// Adds the one cell of the lists, with V-curves and V-points of its own, disjoint from all others.
Result<VCellId> add_cell(VComplex& complex, const VComplexData& one_cell);
/// Unglues all half-V-surfaces of the cell, then removes it with the V-curves and V-points that only it uses.
Status remove_cell(VComplex& complex, VCellId cell);

/// Two uses that become mates.
using UsePair = std::array<CurveUseId, 2>;
/// Glues two half-V-surfaces without mates into one V-surface: one pair for each loop; what follows the first use of a
/// pair is glued to what is before the second one. V-curves and V-points that are glued become one, with the least id.
/// The first half of the V-surface is that of the first uses.
/// @error also if a V-curve would be glued to its own reverse
Status glue(VComplex& complex, std::span<const UsePair> pairs);
/// Makes two V-surfaces of one. A V-curve whose fan falls apart becomes several: the part with the least use keeps it,
/// with its other fans. V-points fall apart alike, into what V-cells, V-surfaces and V-curves connect.
Status unglue(VComplex& complex, VSurfaceId surface);

/// Makes one V-point of two, or one V-curve of two with the same ends, where cells meet without common V-surfaces. The
/// second one is removed. With is_reversed the second V-curve runs from the end of the first one to its beginning.
Status identify_points(VComplex& complex, VPointId kept, VPointId other);
Status identify_curves(VComplex& complex, VCurveId kept, VCurveId other, bool is_reversed);

struct SplitCurve {
  VPointId point;  ///< the new V-point
  VCurveId curve;  ///< from it to the old end
};
Result<SplitCurve> split_curve(VComplex& complex, VCurveId curve);
/// Makes one V-curve of the two that end at the V-point, and removes it. The V-curve with the lesser id stays, and
/// keeps its direction.
/// @error unless exactly two V-curves end there, once each, and follow each other in all loops and around all cells
Status merge_curves(VComplex& complex, VPointId point);

struct SplitSurface {
  VCurveId curve;      ///< the new V-curve
  VSurfaceId surface;  ///< the new V-surface; none if the V-curve connects two loops
};
/// Adds a V-curve that goes through a half-V-surface, and its mate, from the beginning of one of its uses to that of
/// another one. If both are in one loop (they may be equal: a closed V-curve), the V-surface is split: the new one has
/// the part of the loop from `from` on up to `to`, and the loops of `moved`, a use of each. Otherwise the two loops
/// become one, and `moved` must be empty.
Result<SplitSurface> split_surface(VComplex& complex, CurveUseId from, CurveUseId to,
                                   std::span<const CurveUseId> moved = {});
/// Removes a V-curve that is only used by the two V-surfaces on its sides, which become one, the one with the lesser
/// id; or by one loop of one V-surface twice, which becomes two loops.
/// @error also if one V-surface would meet itself in another way, or nothing would be left of a loop
Status merge_surfaces(VComplex& complex, VCurveId curve);

struct SplitCell {
  VSurfaceId surface;  ///< the new one; its first half is that of the cell
  VCellId cell;        ///< the new V-cell; none if the cycle does not separate the cell's boundary
};
/// Adds a V-surface, a disk, that goes through a cell along a cycle of V-curves: each use is followed by one that
/// begins at the same corner of the cell where it ends; no corner and no V-curve use occurs twice. What is to the left
/// of the uses stays in the cell, and what is to their right is in the new one, with the boundary surfaces of `moved`,
/// a half-V-surface of each. If right and left are connected, the cell is cut but not split.
/// REQUIRES that the cycle bounds a disk in the cell. Integers do not show it, and it is not checked, but every cycle
/// on a boundary surface of genus 0 does.
Result<SplitCell> split_cell(VComplex& complex, std::span<const CurveUseId> cycle,
                             std::uint32_t trivariate, std::span<const HalfVSurfaceId> moved = {});
/// Removes an internal V-surface. Its two V-cells, if they are two, must have the same trivariates; the one of the
/// first half stays. If it is in one V-cell, it must be a disk on one of its boundary surfaces: a cut is undone.
/// @error also if the V-surface meets itself in a cell, on both sides of a V-curve or in one corner
Status merge_cells(VComplex& complex, VSurfaceId surface);

}  // namespace veritope
