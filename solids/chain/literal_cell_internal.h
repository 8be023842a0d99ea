// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/chain/literal_cell_internal.h: the cell of definition 9 of seed 001 [GRF03] over one base triangle: the part
// of its wedge between the plane of the base and the patch, along the base's normal.  Theory: docs/THEORY.md, CHAIN-6.
// Internal to solids/chain.
#pragma once
#include <array>
#include <optional>
#include <vector>

#include "robust/base/box3d.h"
#include "solids/chain/local_cones_internal.h"
#include "solids/chain/patch_line_internal.h"

namespace veritope::internal {

/// The box grows to hold the point.
void add_rounded(const ExactPoint& p, Box3d& box);

/// Whether there is one: the facet has a wedge, and its patch is not in the plane of the base.
bool has_cell(const LiteralFacet& facet);

class LiteralCell {
 public:
  /// REQUIRES has_cell(facet), which outlives the cell.
  explicit LiteralCell(const LiteralFacet& facet);

  const LiteralFacet& facet() const { return *facet_; }
  const PatchLine& line() const { return line_; }
  /// Around the control points and their projections onto the plane of the base, rounded outward.
  const Box3d& box() const { return box_; }

  /// Whether there is a plus part, or a minus part: whether the patch has points on that side. Nothing: open.
  std::optional<bool> has_part(bool is_plus) const { return has_part_[is_plus ? 1 : 0]; }

  /// Whether the closed plus part (or minus part) holds the point. kSome, kNone: near it the part is that of the wedge
  /// and of the base's half-space, or is empty. kTouches, kOn: it holds it.
  Meets part_holds(const ExactPoint& q, bool is_plus) const;
  /// Adds the parts that hold the point: kSome if all of them are cones near it, or none is there; kTouches if not.
  /// kOpen: open.
  Meets add_cones(const ExactPoint& q, std::vector<LocalCone>& out) const;

 private:
  const LiteralFacet* facet_;
  PatchLine line_;
  Box3d box_;
  std::array<std::optional<bool>, 2> has_part_;
};

}  // namespace veritope::internal
