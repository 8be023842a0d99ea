// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/chain/patch_cell.h: the free-form cells of patches as cells of chains in space.
// Theory: docs/THEORY.md, CHAIN-1 and CHAIN-2.
#pragma once
#include <cstdint>
#include <memory>
#include <vector>

#include "solids/chain/cell.h"
#include "solids/chain/free_form_cell.h"
#include "solids/classify/patch_rays.h"

namespace veritope {

/// The cell between a patch and its base triangles, with ruled strips along its sides.
class PatchCell : public Cell<3> {
 public:
  /// Patches first, ..., last - 1 of `rays` are the cell's boundary chain as free_form_cell() makes it, whose bases are
  /// the last ones. `sign` is 1 or -1: where the patch is below its bases the winding number is -1 in the cell.
  PatchCell(std::shared_ptr<const PatchRays> rays, std::uint32_t first, std::uint32_t last,
            std::vector<BaseTriangle> bases, int sign);
  /// A cell by itself. REQUIRES weights > 0.
  explicit PatchCell(const Patch& patch);

  CellKind kind() const override { return CellKind::kFreeForm; }
  int sign() const { return sign_; }
  std::optional<int> value(const ChainPoint<3>& q) const override;
  /// On a base the cell is two half-spaces with a value each; on a diagonal only if both triangles are in one plane.
  std::optional<CellGerm<3>> germ(const ChainPoint<3>& q) const override;
  bool add_facets(std::vector<FacetIn<3>>&) const override { return false; }

 private:
  std::optional<int> winding(const PointIn<3>& q) const;
  bool is_off_curved_walls(const PointIn<3>& a, const PointIn<3>& b) const;

  std::shared_ptr<const PatchRays> rays_;
  std::uint32_t first_, last_;
  std::vector<BaseTriangle> bases_;
  int sign_;
};

/// The sign that a patch's cell has in the paper: 1 for CellSign::kPlus and kMixed, -1 for kMinus, 0 for kZero.
int coefficient_of(CellSign sign);

}  // namespace veritope
