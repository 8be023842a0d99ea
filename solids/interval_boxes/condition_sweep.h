// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/interval_boxes/condition_sweep.h: which conditions hold at eps, eps / 2, eps / 4, ...: the paper's boxes
// against A, B1, B2, C1, C2, C3 and C3*, and the octree cells of that size that V meets against K1-K3. Sources: [SSP01]
// 3, docs/THEORY.md, SWEEP-1. Neither is monotone in eps.
#pragma once
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "robust/base/result.h"
#include "solids/interval_boxes/conditions.h"
#include "solids/interval_boxes/surface_boxes.h"

namespace veritope {

struct SweepRow {
  double eps = 0;
  std::uint64_t face_boxes = 0, edge_boxes = 0, vertex_boxes = 0;
  std::array<ConditionResult, kNumPaperConditions> conditions;  ///< by PaperCondition
  std::uint64_t cells = 0;                                      ///< of the octree cover
  /// K1, K2, K3 of the cells: |K| is a manifold; each body lies between two components of one genus (K2 with its d+);
  /// it collapses (K3). A condition that is not asked because one before it fails is undecided.
  std::array<Answer, 3> collar{Answer::kUndecided, Answer::kUndecided, Answer::kUndecided};
  std::string
      why_not;  ///< the limit that the boxes met, or the cells: what they were to decide is undecided
};

struct SweepOptions {
  SurfaceBoxOptions boxes;
  ConditionOptions conditions;
  std::uint64_t max_cells = 1'000'000;
};

inline constexpr int kMaxSweep = 20;

/// Rows for eps, eps / 2, ..., eps / 2^halvings. No collar is sought for a planar model.
/// @error kBadArgument unless eps is finite and positive and 0 <= halvings <= kMaxSweep. Limits end a row, not the
/// sweep.
Result<std::vector<SweepRow>> sweep_conditions(BoundaryModel& model, double eps, int halvings,
                                               const SweepOptions& options = {});

/// A table in text, one line a row: "yes", "no" or "?" for each condition.
std::string to_table(const std::vector<SweepRow>& rows);

}  // namespace veritope
