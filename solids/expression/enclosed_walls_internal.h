// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/expression/enclosed_walls_internal.h: what a Boolean function of solids is near a point at irrational
// parameters of some of them.  Theory: docs/THEORY.md, POINT-7 and POINT-8.D1.
#pragma once
#include <span>

#include "solids/expression/directions.h"

namespace veritope::internal {

enum class ValuesNear : std::uint8_t { kOnlyZero, kOnlyOne, kBoth, kUnknown };

/// Boundaries inside patches that are one surface have equal or opposite bits, for any of which f may have one value,
/// or depend on a single surface; so has the boundary along an edge, whose bit is known on one side of a flat patch's
/// plane. Otherwise directions are tried, in which the enclosed normals tell the bits: both values may occur in them.
/// @param cones  with an enclosure, or with sectors
ValuesNear values_near(std::span<const TangentCone> cones, const NearbyFunction& f);

}  // namespace veritope::internal
