// SPDX-License-Identifier: LGPL-3.0-or-later
// topology/v_complex_boundary.h: the boundary of a V-model as a B-rep, [ME16] definition 3.5.
#pragma once
#include <cstdint>
#include <vector>

#include "topology/v_complex.h"

namespace veritope {

/// One component of the boundary: half-V-surfaces that are connected through V-curves.
struct VShell {
  HalfVSurfaceId first_half;  ///< the least one
  std::uint64_t vertices = 0, edges = 0, faces = 0, loops = 0;
  /// A face with k loops has the Euler characteristic 2 - k.
  std::int64_t euler() const {
    return static_cast<std::int64_t>(vertices) - static_cast<std::int64_t>(edges) +
           2 * static_cast<std::int64_t>(faces) - static_cast<std::int64_t>(loops);
  }
  std::int64_t genus() const { return (2 - euler()) / 2; }
};

/// The half-V-surfaces without a mate as a closed oriented 2-manifold; outside is on the side that they are seen from.
/// Sheets of it that meet at a V-curve with several fans, or at a V-point whose link has several components or boundary
/// circles, are separate here.
struct BoundaryBrep {
  std::vector<HalfVSurfaceId> faces;    ///< ascending
  std::vector<std::uint32_t> shell_of;  ///< of each of the faces
  std::vector<VShell> shells;           ///< by first halves
  std::vector<CurveUseId> uses;         ///< all uses of these faces, ascending
  std::vector<CurveUseId>
      across;  ///< of each of the uses the other use of the same edge of the boundary

  std::uint64_t num_vertices() const;
  std::uint64_t num_edges() const { return uses.size() / 2; }
};

/// @cost O(n log n)
BoundaryBrep boundary_brep(const VComplex& complex);

}  // namespace veritope
