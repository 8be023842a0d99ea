// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/dms/domain/refine_domain.h: a domain with more vertices, until tetrahedra are small and not too long. The
// domain stays the same set of points.
// Source: [She98].  Design: docs/design/0102-refined-domains.md.
#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

#include "robust/base/result.h"
#include "solids/dms/dms_model.h"
#include "solids/dms/domain/refine_limits.h"
#include "solids/dms/domain/small_angles.h"

namespace veritope {

struct RefinedDomain {
  /// Degree 1, the identity. The first vertices are those of the domain, without those that were taken away.
  DmsModel model;
  std::size_t on_boundary = 0, inside = 0;  ///< vertices that were inserted
  std::size_t removed = 0;                  ///< vertices of the domain that were taken away
  RefineEnd end = RefineEnd::kLimits;
  std::size_t over_volume = 0,
              over_radius_edge = 0;  ///< tetrahedra over a limit, protected ones not counted
  /// Tetrahedra over the ratio whose shortest edge joins segments or facets that enclose less than 60 degrees.
  std::vector<std::uint32_t> protected_tetrahedra;
  std::vector<SmallAngle> small_angles;                ///< of the domain, if the ratio is limited
  double largest_volume = 0, largest_radius_edge = 0;  ///< rounded; protected ones counted
};

/// New vertices inside are near circumcentres; those on the boundary lie on its facets and edges, exactly. Which
/// tetrahedra are over a limit is decided exactly.
/// @param domain  REQUIRES degree 1, the identity, without defects
/// @error kBadArgument if an edge of the boundary belongs to more than two of its faces; a limit outside its range
/// @cost  some 100 us for each vertex that is inserted
Result<RefinedDomain> refine_domain(const DmsModel& domain, const RefineLimits& limits);

}  // namespace veritope
