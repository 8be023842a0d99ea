// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/chain/plane_cell.h: free-form cells of the plane, and the normal chain of closed loops of curves.
// Theory: docs/THEORY.md, CHAIN-5.
#pragma once
#include <memory>
#include <span>

#include "solids/chain/cell.h"
#include "solids/chain/chain.h"
#include "solids/chain/plane_arc.h"

namespace veritope {

/// What lies between a curve and its chord: the closed chain of the curve and of the chord backward.
class ArcCell : public Cell<2> {
 public:
  explicit ArcCell(PlaneArc arc);

  const PlaneArc& arc() const { return arc_; }
  CellKind kind() const override { return CellKind::kFreeForm; }
  /// -1 if the curve is on the left of its chord, where a region that it bounds lies; else 1.
  int sign() const { return sign_; }
  std::optional<int> value(const ChainPoint<2>& q) const override;
  std::optional<CellGerm<2>> germ(const ChainPoint<2>& q) const override;
  bool add_facets(std::vector<FacetIn<2>>&) const override { return false; }

 private:
  PlaneArc arc_;
  int sign_;
};

/// The normal chain of a closed chain of curves: original simplices over the chords, with the signs of their areas, and
/// the cells of curves that are not their chords, with theirs. Its f is the winding number of the curves off all walls,
/// for every origin.
Chain<2> plane_chain(std::span<const PlaneArc> arcs, const PointIn<2>& origin);

}  // namespace veritope
