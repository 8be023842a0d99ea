// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/tetrahedra/delaunay.h: Delaunay tetrahedralizations of points, decided exactly.
// Design: docs/design/0093-delaunay-tetrahedra.md.  Source: [Bow81], [Wat81], [DT11].
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "predicates/exact_point.h"
#include "predicates/vec.h"
#include "robust/base/result.h"
#include "topology/tetrahedral_complex.h"

namespace veritope {

/// The tetrahedra are the cells of the convex hull of all points whose spheres contain no point inside. Where five or
/// more points lie on one sphere there are several ways to choose them; the one here is that of points which count as
/// lifted, off the paraboloid, by infinitesimal amounts, larger ones for points that are later in lexicographic order:
/// so the tetrahedra depend on the places of the points only, not on their numbers. (Orders of tetrahedra and of their
/// corners may.) Laws:
///   (1) d > 0 for each tetrahedron, no point is inside its sphere;
///   (2) they form a complex without overlaps or gaps, whose boundary is that of the convex hull, triangulated;
///   (3) each place of a point is a vertex.
struct DelaunayTetrahedra {
  std::vector<TetrahedronCorners> tetrahedra;  ///< numbers of points
  /// For each point the first one at the same place, itself if there is no earlier one. Only those are corners.
  std::vector<std::uint32_t> same_as;
};

struct DelaunayLimits {
  /// Tetrahedra of the hull and triangles of its boundary at any time. n points need approximately 6.8 n if they are
  /// uniform in a volume, and at most n^2.
  std::size_t max_tetrahedra = std::size_t{1} << 29;
};

/// @error kBadArgument for fewer than four points, or if all lie in one plane; kNotFinite, with the number of the point
///        as place.vertex; kOverLimit
/// @cost  O(n log n) expected for points that are uniform in a volume, O(n^2) at worst; 100 to 200 bytes a tetrahedron
Result<DelaunayTetrahedra> delaunay_tetrahedra(std::span<const Vec3d> points,
                                               const DelaunayLimits& limits = {});
/// At rational points. @error and @cost as above, in signs of integers where intervals do not decide
Result<DelaunayTetrahedra> delaunay_tetrahedra(std::span<const ExactPoint3> points,
                                               const DelaunayLimits& limits = {});

/// Whether no sphere of a tetrahedron contains the opposite corner of a neighbour. If the complex fills a convex set
/// then no sphere contains any vertex. REQUIRES positive tetrahedra, face to face.
bool is_locally_delaunay(std::span<const ExactPoint3> points, const TetrahedralComplex& complex);

}  // namespace veritope
