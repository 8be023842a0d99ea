// SPDX-License-Identifier: LGPL-3.0-or-later
// topology/v_complex.h: V-models on integers: V-cells, V-surfaces with their halves, V-curves, V-points.
// Design: docs/design/0064-v-complexes.md.  Source: [ME16] section 3.1.
#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "robust/base/result.h"
#include "topology/v_complex_tables.h"

namespace veritope {

namespace internal {
struct VComplexAccess;
}

/// What validate() demands of the tables, in this order: each condition may use those before it.
enum class VInvariant {
  /// 1. Every id that an element holds names an element, except where none is allowed: the second half of a V-surface,
  ///    the mate of a use.
  kReferences = 1,
  /// 2. A cell has half-V-surfaces and trivariates. It lists exactly those half-V-surfaces that name it, each once; the
  ///    trivariate of each is one of the cell's.
  kCells,
  /// 3. A V-surface has one half or two different ones; each half-V-surface is a half of exactly the V-surface that it
  ///    names.
  kSurfaces,
  /// 4. next and previous are inverse to each other and stay in a half-V-surface. It lists exactly one use of each of
  ///    its loops, and has at least one loop.
  kLoops,
  /// 5. In a loop each use begins at the V-point where the use before it ends.
  kEnds,
  /// 6. across pairs the uses: the two of a pair are different, in one cell, on one V-curve, in opposite directions. So
  ///    the boundary of a cell is a closed oriented surface.
  kAcross,
  /// 7. A use has a mate iff its half-V-surface has one, and it lies in that. mate pairs the uses, on one V-curve, in
  ///    opposite directions, and maps loops to loops: the mate of the next use is before the mate of the use.
  kMates,
  /// 8. A V-curve has fans; it lists one use against the curve of each, without a mate if the fan is open. These are
  ///    all fans of all its uses.
  kFans,
  /// 9. A V-point lists exactly the V-curves that begin or end there, each once, and at least one.
  kPoints,
};

struct VViolation {
  VInvariant invariant = VInvariant::kReferences;
  std::string message;  ///< a sentence with the id of an element
};

/// The first invariant that the tables violate; nothing if they are a V-complex. @cost O(size), and a sort for each
/// list of an element.
std::optional<VViolation> validate(const VComplexTables& tables);

struct VComplexCounts {
  std::uint64_t cells = 0, surfaces = 0, internal_surfaces = 0, half_surfaces = 0, curves = 0,
                points = 0;
  friend bool operator==(const VComplexCounts&, const VComplexCounts&) = default;
};

/// A class of sectors at a V-curve that are connected through V-surfaces, in the right-handed sense around it.
struct VFan {
  bool is_cyclic = false;
  std::vector<CurveUseId> uses;  ///< two for each sector: against the curve, along the curve
};

/// The elements that two cells have in common, ascending.
struct VCommon {
  std::vector<VSurfaceId> surfaces;
  std::vector<VCurveId> curves;
  std::vector<VPointId> points;
  bool is_exactly_one_point() const { return curves.empty() && points.size() == 1; }
};

/// A V-model without coordinates. Its tables always satisfy all VInvariants: it is made by make_v_complex
/// (v_complex_data.h) or hexahedral_v_complex, and changed by the edits of v_complex_edit.h. An element can meet
/// itself: a cell can be glued to itself, a V-curve can be used several times by one half-V-surface. Queries that
/// return lists take O(k log k) for k elements that they pass; lists of ids ascend unless stated otherwise.
class VComplex {
 public:
  VComplex() = default;
  /// @error kBadArgument with the first violated invariant
  static Result<VComplex> from_tables(VComplexTables tables);

  const VComplexTables& tables() const { return tables_; }
  VComplexCounts counts() const;

  const VCell& cell(VCellId c) const { return tables_.cells[c]; }
  const VSurface& surface(VSurfaceId s) const { return tables_.surfaces[s]; }
  const HalfVSurface& half_surface(HalfVSurfaceId h) const { return tables_.half_surfaces[h]; }
  const CurveUse& use(CurveUseId u) const { return tables_.uses[u]; }
  const VCurve& curve(VCurveId c) const { return tables_.curves[c]; }
  const VPoint& point(VPointId p) const { return tables_.points[p]; }

  HalfVSurfaceId mate(HalfVSurfaceId h) const { return tables_.mate(h); }
  VPointId start(CurveUseId u) const { return tables_.start(u); }
  VPointId end(CurveUseId u) const { return tables_.end(u); }

  /// The loop of a use, from this use on; the loops of a half-V-surface.
  std::vector<CurveUseId> loop(CurveUseId u) const;
  std::vector<std::vector<CurveUseId>> loops(HalfVSurfaceId h) const;
  /// The fans of a V-curve, each in radial order.
  std::vector<VFan> fans(VCurveId c) const;
  /// All uses that begin at a V-point; each is one corner of a half-V-surface.
  std::vector<CurveUseId> uses_from(VPointId p) const;

  /// In radial order, fan after fan; a half-V-surface that uses the curve twice occurs twice.
  std::vector<HalfVSurfaceId> half_surfaces_of_curve(VCurveId c) const;
  std::vector<VSurfaceId> surfaces_of_curve(VCurveId c) const;
  std::vector<VCellId> cells_of_curve(VCurveId c) const;
  std::vector<VSurfaceId> surfaces_of_point(VPointId p) const;
  std::vector<VCellId> cells_of_point(VPointId p) const;
  /// The other cells that share a V-surface with this one.
  std::vector<VCellId> neighbours(VCellId c) const;
  std::vector<VSurfaceId> surfaces_of_cell(VCellId c) const;
  std::vector<VCurveId> curves_of_cell(VCellId c) const;
  std::vector<VPointId> points_of_cell(VCellId c) const;
  VCommon common(VCellId a, VCellId b) const;

 private:
  friend struct internal::VComplexAccess;
  VComplexTables tables_;
};

/// Numbers the elements of each table 0, 1, ... and keeps their order.
VComplex compacted(const VComplex& complex);

}  // namespace veritope
