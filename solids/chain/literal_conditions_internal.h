// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/chain/literal_conditions_internal.h: how each condition of definition 1 is decided for one cell. Internal to
// solids/chain.
#pragma once
#include "solids/chain/literal_cell_internal.h"
#include "solids/chain/literal_conditions.h"
#include "solids/chain/literal_hypotheses_internal.h"

namespace veritope::internal {

/// One side of the plane of the base.
struct LiteralCellPart {
  const LiteralCell* cell = nullptr;
  bool is_plus = true;
  bool is_all = true;  ///< the patch is nowhere on the other side
};

PlaceAnswer is_connected(const LiteralCellPart& part);
PlaceAnswer is_on_one_side(const LiteralCellPart& part);
PlaceAnswer has_vertices_on_patch(const LiteralCellPart& part);

void judge_cells(const PatchComplex& complex, const std::vector<LiteralCell>& cells, unsigned jobs,
                 LiteralCells& out);

}  // namespace veritope::internal
