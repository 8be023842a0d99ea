// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/dms/dms_change.h: how much the map of a simplex-spline solid changes where tetrahedra are cut at a new vertex.
// Theory: docs/THEORY.md, DMS-3.
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "solids/dms/dms_model.h"
#include "splines/dms_blossom.h"

namespace veritope {

/// The polynomial of a tetrahedron: its control points as a B-patch, with `count` components from `first` on, or all.
/// REQUIRES d(W_γ) != 0 for |γ| < degree, a model that validate() accepts.
BPatch<Rational> patch_of_tetrahedron(const DmsModel& model, std::uint32_t tetrahedron);
BPatch<Rational> patch_of_tetrahedron(const DmsModel& model, std::uint32_t tetrahedron,
                                      std::size_t first, std::size_t count);

/// Where a new vertex lies, and which tetrahedra it cuts.
struct DmsCut {
  /// Two vertices of an edge, three of a face, four of a tetrahedron; ascending. The new vertex is inside of it.
  std::vector<std::uint32_t> simplex;
  std::vector<std::uint32_t> tetrahedra;  ///< all that have these vertices, ascending

  bool has(std::uint32_t vertex) const;
};

/// lo <= the greatest |after - before| over the domain <= hi.
struct DmsChange {
  Rational lo, hi;
};

/// One for each component. hi is 0 if the component is proved to stay equal: where the polynomials of the tetrahedra
/// are one, or where all knots of each face that is cut lie in its plane. lo is the greatest change at a few points.
/// @param after  `before` with the vertex inserted as insert_dms_vertex does, with any control points at it
/// REQUIRES shared control points, two models without defects.
/// @cost for each face that is cut as many differences of blossoms as there are multisets of its knots; a few exact
///       values
std::vector<DmsChange> bound_dms_change(const DmsModel& before, const DmsModel& after,
                                        const DmsCut& cut);

}  // namespace veritope
