// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/polyhedron/volume.h: the exact volume that each shell encloses.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "robust/rational.h"
#include "solids/polyhedron/triangle_mesh.h"

namespace veritope {

/// The signed volume of each of `num_shells` shells, positive if its facets are seen counter-clockwise from outside:
/// the sum of (area of the projection to the xy plane) * (mean z), which for a cycle equals the sum of det(v0, v1, v2)
/// / 6. REQUIRES the facets of each shell to form a cycle (every edge used equally often in both directions); facets
/// with shell_of_face >= num_shells are left out. The result does not depend on jobs.
/// @cost O(F), machine integers while all coordinates fit a lattice of 120 bits, otherwise GMP.
std::vector<Rational> shell_volumes(const TriangleMesh& mesh, std::span<const std::uint32_t> shell_of_face,
                                    std::size_t num_shells, unsigned jobs);

}  // namespace veritope
