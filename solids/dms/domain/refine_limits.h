// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/dms/domain/refine_limits.h: limits of tetrahedra in a domain, decided exactly.
// Design: docs/design/0102-refined-domains.md.
#pragma once
#include <array>
#include <cstddef>
#include <optional>

#include "predicates/exact_point.h"
#include "robust/rational.h"
#include "solids/dms/dms_model.h"

namespace veritope {

struct RefineLimits {
  std::optional<Rational> max_volume;       ///< of each tetrahedron; positive
  std::optional<Rational> max_radius_edge;  ///< circumradius over shortest edge; at least 1
  std::size_t max_points = 100'000;         ///< that may be inserted
  /// Vertices from this number on may be taken away first, where the set stays the same without them: those that cuts
  /// made are often near others.
  std::size_t num_fixed = kMaxDmsVertices;
};

enum class RefineEnd {
  kLimits,  ///< every tetrahedron is within the limits, but for those between small angles of the domain
  kBudget,  ///< max_points are inserted
  kStuck,   ///< no place for a further vertex was found
};
/// "limits", "budget", "stuck"
const char* refine_end_name(RefineEnd end);

/// Whether the volume of the tetrahedron, whose d is positive, is greater than the limit, if there is one.
bool is_over_volume(const std::array<const ExactPoint3*, 4>& tetrahedron,
                    const RefineLimits& limits);
/// Whether its circumradius is greater than the limit, if there is one, times its shortest edge.
bool is_over_ratio(const std::array<const ExactPoint3*, 4>& tetrahedron,
                   const RefineLimits& limits);

}  // namespace veritope
