// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/dms/domain/auto_domain.h: a coarse domain of dense data, from the data alone.
// Source: [HHQ04], section 5.2.  Design: docs/design/0102-refined-domains.md.
#pragma once
#include <cstddef>
#include <span>
#include <vector>

#include "predicates/exact_point.h"
#include "robust/base/result.h"
#include "solids/dms/dms_model.h"

namespace veritope {

struct AutoDomainOptions {
  std::size_t interior_samples = 100;  ///< at most
  std::size_t max_samples = 4'000;     ///< vertices of an occupancy domain
  int max_rounds = 12;                 ///< of adding data that lie outside
};

enum class AutoDomainKind {
  kHull,       ///< the data fill their convex hull
  kOccupancy,  ///< they do not
};
/// "hull", "occupancy"
const char* auto_domain_name(AutoDomainKind kind);

struct AutoDomain {
  DmsModel model;  ///< of degree 1, the identity
  AutoDomainKind kind = AutoDomainKind::kHull;
  double spacing = 0;       ///< the median distance of a point from the nearest other one
  std::size_t samples = 0;  ///< vertices that are points of the data
  int rounds = 0;
  std::size_t outside = 0;  ///< points that the domain does not contain, exactly
  std::vector<TetrahedronCorners> data_tetrahedra;  ///< those of Delaunay of all data
};

/// The tetrahedra that the data occupy (solids/tetrahedra/occupancy.h) say what the object is. If their boundary is one
/// sphere and they fill nine tenths of the hull, the domain is the hull: the corners of the hull only, so it contains
/// all data. Else a part of the data is chosen as in domain_samples.h, and those of their Delaunay tetrahedra are taken
/// whose barycentre is in the object, less what keeps the boundary from being a 2-manifold; data that these do not
/// contain, though the object does, are added, as long as there are any and the options allow it.
/// @error kBadArgument as delaunay_tetrahedra
Result<AutoDomain> auto_domain(std::span<const ExactPoint3> points,
                               const AutoDomainOptions& options);

}  // namespace veritope
