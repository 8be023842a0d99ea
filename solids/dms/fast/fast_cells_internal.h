// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/dms/fast/fast_cells_internal.h: the tetrahedra of a domain, and in which of them a point is, by filters.
#pragma once
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "predicates/vec.h"
#include "solids/dms/fast/fast_grid_internal.h"
#include "solids/dms/fast/fast_region_internal.h"

namespace veritope::internal {

inline bool is_in_box(const Box3d& b, const Vec3d& p) {
  return p.x >= b.lo[0] && p.x <= b.hi[0] && p.y >= b.lo[1] && p.y <= b.hi[1] && p.z >= b.lo[2] &&
         p.z <= b.hi[2];
}

class FastCells {
 public:
  /// All arguments must outlive this.
  FastCells(const DmsModel& model, const DmsEvaluator& evaluator, const FastDmsKernels& kernels);

  /// Made when it is needed first; null if its numbers are out of range.
  const FastCell* cell(std::uint32_t tetrahedron);

  /// The number of the tetrahedron in which the point is, by more than rounding errors, also if it was rounded (1, else
  /// 0); kFastUndecided or kFastNowhere.
  std::uint32_t locate(const Vec3d& u, double rounded);

 private:
  FastGrid make_grid();

  const DmsModel& model_;
  const DmsEvaluator& evaluator_;
  const FastDmsKernels& kernels_;
  std::vector<std::optional<FastPlace>> places_;
  std::vector<std::unique_ptr<FastCell>> cells_;
  std::vector<Box3d> boxes_;            // wider than those of the tetrahedra
  std::vector<const FastSide*> sides_;  // null where there is no cell yet
  FastGrid grid_;
};

}  // namespace veritope::internal
