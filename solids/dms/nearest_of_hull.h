// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/dms/nearest_of_hull.h: directions that have positive products with many vectors, sought in binary64.
#pragma once
#include <array>
#include <functional>
#include <optional>

namespace veritope::internal {

using PlainVector = std::array<double, 3>;

double dot_product(const PlainVector& a, const PlainVector& b);

/// Seeks the point nearest to the origin of the convex hull of some vectors, of which least(w) is one with the least
/// product with w. Where the hull misses the origin, that point has positive products with all vectors, and the least
/// one is greater than for all other directions. What is found is near it; nothing if the origin seems to be inside.
/// @cost  some ten calls of least()
/// Source: [GJK88]
std::optional<PlainVector> nearest_of_hull(
    const std::function<PlainVector(const PlainVector& w)>& least);

}  // namespace veritope::internal
