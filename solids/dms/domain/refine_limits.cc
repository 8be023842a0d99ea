// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/dms/domain/refine_limits.h"

#include "predicates/distance.h"

namespace veritope {

const char* refine_end_name(RefineEnd end) {
  switch (end) {
    case RefineEnd::kLimits: return "limits";
    case RefineEnd::kBudget: return "budget";
    case RefineEnd::kStuck: return "stuck";
  }
  return "";
}

bool is_over_volume(const std::array<const ExactPoint3*, 4>& tetrahedron,
                    const RefineLimits& limits) {
  return limits.max_volume && compare_volume(tetrahedron, *limits.max_volume) == Sign::kPositive;
}

bool is_over_ratio(const std::array<const ExactPoint3*, 4>& tetrahedron,
                   const RefineLimits& limits) {
  if (!limits.max_radius_edge) return false;
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = i + 1; j < 4; ++j)
      if (compare_circumradius(tetrahedron, *tetrahedron[i], *tetrahedron[j],
                               *limits.max_radius_edge) == Sign::kPositive)
        return true;
  return false;
}

}  // namespace veritope
