// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/dms/domain/short_vertices.h: vertices of tetrahedra moved to places with shorter numbers, without leaving the
// edge or the facet of a mesh on which they lie.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "predicates/exact_point.h"
#include "predicates/vec.h"
#include "topology/tetrahedral_complex.h"

namespace veritope {

/// Where a vertex may be: at its place, on the line through two points, on the plane through three, or anywhere.
struct VertexFlat {
  enum class Kind : std::uint8_t { kFixed, kLine, kPlane, kFree } kind = Kind::kFixed;
  std::array<Vec3d, 3> points{};
};

/// The length of the longest numerator or denominator.
std::uint64_t num_bits(const ExactPoint3& p);

/// Rounds coordinates along the flats, in the order of the vertices, to as few binary digits as leave all tetrahedra
/// positively oriented. Vertices whose numbers are short already, or for which nothing shorter is found, stay.
/// So the union of the tetrahedra stays the same set if vertices on its boundary have flats in it.
/// REQUIRES points on their flats, positively oriented tetrahedra, flats and points of equal number.
/// @cost a few signs for each tetrahedron at a vertex that moves
void shorten_vertices(std::span<const VertexFlat> flats,
                      std::span<const TetrahedronCorners> tetrahedra,
                      std::vector<ExactPoint3>& points);

}  // namespace veritope
