// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/expression/directions.h: what a Boolean function of solids is near a point, in the directions off their
// boundaries.  Theory: docs/THEORY.md, POINT-6 and POINT-7.
#pragma once
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "solids/expression/tangent_cone.h"

namespace veritope {

/// Bits of solids, in their order: whether each of them holds the points near the apex in one direction.
using NearbyBits = std::vector<bool>;
using NearbyFunction = std::function<bool(const NearbyBits&)>;

/// The value of `f` in all directions that are in no sector of the cones, if it is one value; nothing if both occur.
/// No general position: sectors may coincide, overlap, and meet in any number.
/// @param cones  one of each solid, all at one point; none is empty
/// @cost  with n sectors that have m common directions: O(n^2 + (n + m) n) exact operations; fewer if both values occur
std::optional<bool> common_value(std::span<const TangentCone> cones, const NearbyFunction& f);

}  // namespace veritope
