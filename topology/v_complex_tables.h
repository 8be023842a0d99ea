// SPDX-License-Identifier: LGPL-3.0-or-later
// topology/v_complex_tables.h: the elements of a V-complex and their references: half-edges, one dimension higher.
// Sources: [ME16] definitions 3.3 to 3.9. What definition 3.6 calls trimming loops is stored as uses of V-curves.
#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "topology/id_table.h"

namespace veritope {

using VCellId = TopologyId<struct VCellTag>;
using VSurfaceId = TopologyId<struct VSurfaceTag>;
using HalfVSurfaceId = TopologyId<struct HalfVSurfaceTag>;
using CurveUseId = TopologyId<struct CurveUseTag>;
using VCurveId = TopologyId<struct VCurveTag>;
using VPointId = TopologyId<struct VPointTag>;

/// A connected open set of space whose boundary is the closed oriented surface, or the several surfaces, of its
/// half-V-surfaces.
struct VCell {
  std::vector<std::uint32_t>
      trivariates;  ///< the numbers of the trivariates that contain it; at least one
  std::vector<HalfVSurfaceId> half_surfaces;  ///< at least one
  friend bool operator==(const VCell&, const VCell&) = default;
};

/// One side of a V-surface: a sphere with as many holes as it has loops, seen from outside of its cell.
struct HalfVSurface {
  VCellId cell;
  std::uint32_t trivariate = 0;   ///< it bounds or trims this one, one of its cell's
  VSurfaceId surface;             ///< the other side, its mate, is the other half of this
  std::vector<CurveUseId> loops;  ///< one use of each loop; at least one
  friend bool operator==(const HalfVSurface&, const HalfVSurface&) = default;
};

/// On the boundary of the V-model it has one half; inside it has two, of two cells or of one.
struct VSurface {
  std::array<HalfVSurfaceId, 2> halves;  ///< the second one may be none
  bool is_internal() const { return !halves[1].is_none(); }
  friend bool operator==(const VSurface&, const VSurface&) = default;
};

/// A V-curve as a part of a loop of a half-V-surface. Seen from outside of the cell a loop has its half-V-surface on
/// its left.
struct CurveUse {
  HalfVSurfaceId half_surface;
  CurveUseId next, previous;  ///< in the loop
  VCurveId curve;
  bool is_forward = true;  ///< the loop runs along the curve
  CurveUseId across;  ///< the use on the other side of the curve, in the boundary of the same cell
  CurveUseId mate;    ///< the same use in the mate of the half-V-surface; none if it has no mate
  friend bool operator==(const CurveUse&, const CurveUse&) = default;
};

/// A V-curve with its fans. A sector is a place at the curve where a cell lies: a use against the curve, and the use
/// across it, which runs along the curve. The mate of the latter begins the next sector of the fan, in the right-handed
/// sense around the curve. Fans are cyclic (inside), or open: they begin and end with half-V-surfaces without a mate.
struct VCurve {
  std::array<VPointId, 2> ends;  ///< where it begins and where it ends; equal for a closed one
  std::vector<CurveUseId>
      fans;  ///< a use against the curve of each fan: the first one of an open fan
  friend bool operator==(const VCurve&, const VCurve&) = default;
};

struct VPoint {
  std::vector<VCurveId> curves;  ///< the curves that begin or end here, each once; at least one
  friend bool operator==(const VPoint&, const VPoint&) = default;
};

/// All elements of a V-complex. Code outside of this folder reads them through VComplex.
struct VComplexTables {
  IdTable<VCellId, VCell> cells;
  IdTable<VSurfaceId, VSurface> surfaces;
  IdTable<HalfVSurfaceId, HalfVSurface> half_surfaces;
  IdTable<CurveUseId, CurveUse> uses;
  IdTable<VCurveId, VCurve> curves;
  IdTable<VPointId, VPoint> points;

  /// The use begins at this end of its curve: 0 or 1.
  unsigned start_end(CurveUseId u) const { return uses[u].is_forward ? 0 : 1; }
  VPointId start(CurveUseId u) const { return curves[uses[u].curve].ends[start_end(u)]; }
  VPointId end(CurveUseId u) const { return curves[uses[u].curve].ends[1 - start_end(u)]; }
  /// The other half of the same V-surface, or none.
  HalfVSurfaceId mate(HalfVSurfaceId h) const {
    const auto& halves = surfaces[half_surfaces[h].surface].halves;
    return halves[halves[0] == h ? 1 : 0];
  }
  friend bool operator==(const VComplexTables&, const VComplexTables&) = default;
};

}  // namespace veritope
