// SPDX-License-Identifier: LGPL-3.0-or-later
// topology/trim_to_manifold.h: takes tetrahedra away until the boundary of the rest is a surface. Integers only.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "topology/tetrahedral_complex.h"

namespace veritope {

enum class TrimReason {
  kEdge,  ///< tetrahedra at an edge formed several fans, and this one was not in the largest
  kVertex,  ///< those at a vertex were not connected through faces, and this one was not in the largest part
  kRing,  ///< they were connected, but not like a ball or half of one: the boundary touched itself at the vertex
};

struct TrimmedTetrahedron {
  std::uint32_t tetrahedron = 0;
  TrimReason reason = TrimReason::kVertex;
};

/// Takes tetrahedra of the complex out of `kept` until the link of each vertex in the others is a sphere, a disc or
/// empty: then their boundary is a 2-manifold. What is taken, in order. At a bad place the largest part stays, by the
/// number of tetrahedra, on a tie that with the least number; from a ring the tetrahedron at its border goes that comes
/// first in `order`.
/// REQUIRES a complex without overused faces whose links are spheres or discs, such as the tetrahedra of a convex hull;
/// kept and order have one entry for each tetrahedron, and order is a permutation of their ranks.
/// @cost linear, times the number of times that a vertex is looked at again
std::vector<TrimmedTetrahedron> trim_to_manifold(const TetrahedralComplex& complex,
                                                 std::span<const std::uint32_t> order,
                                                 std::vector<bool>& kept);

}  // namespace veritope
