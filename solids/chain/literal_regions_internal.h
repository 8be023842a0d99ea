// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/chain/literal_regions_internal.h: whether the part of a triangle where a polynomial is positive is connected.
// Internal to solids/chain.
#pragma once
#include <array>

#include "solids/chain/literal_sign_internal.h"

namespace veritope::internal {

/// kHolds: the closure of { f > 0 } is connected. kViolated: it is not, and `where` has points of two of its
/// components. Within 4^kRegionLevels pieces, else kOpen.
struct PositiveRegion {
  Decision decision = Decision::kOpen;
  std::array<Barycentric<Rational>, 2> where;
};
/// REQUIRES one component, and a place where f > 0.
PositiveRegion positive_region(const BezierTriangle<Rational>& f);
inline constexpr int kRegionLevels = 5;

}  // namespace veritope::internal
