// SPDX-License-Identifier: LGPL-3.0-or-later
// verify/certify/pair_codes.h: which axes prove that two facets meet exactly in their common simplex.
// The codes and their test: docs/certificates/mesh.md section 5.
#pragma once
#include <cstdint>
#include <vector>

#include "solids/polyhedron/triangle_mesh.h"

namespace veritope {

/// The code bytes for the leaf pair (a, b): at most four, each but the last with the bit for "another byte follows".
/// Empty if no axes were found. For a pair of disjoint facets there is always one axis (separating axes of two
/// triangles); for facets that share a vertex or an edge see docs/design/0002-mesh-certificate.md. REQUIRES neither
/// facet degenerate; they meet exactly in their common simplex.
/// @cost a few orient3d for most pairs; integers of any size for the rest.
std::vector<std::uint8_t> find_pair_codes(const TriangleMesh& mesh, std::uint32_t a, std::uint32_t b);

}  // namespace veritope
