// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/polyhedron/nesting.h: how deep each shell lies inside the others.
// Theory: docs/THEORY.md, nesting lemma.  Certificate: docs/certificates/mesh.md section 6.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "solids/polyhedron/broad_phase.h"
#include "solids/polyhedron/triangle_mesh.h"

namespace veritope {

/// Whether the ray from `from` along +axis (or -axis) meets facet f, for `from` moved by (e, e^2), e -> 0+, in the two
/// other axes (cyclic order).
enum class Stab { kMiss, kHit, kTouch };
/// kTouch: `from` lies on the plane of f where the ray would meet it. REQUIRES f not degenerate.
Stab stab_facet(const TriangleMesh& mesh, std::uint32_t facet, const Vec3d& from, int axis, bool positive);

struct Nesting {
  std::vector<std::uint32_t> depth;    ///< for each shell, the number of other shells around it
  std::vector<std::uint8_t> axis_code; ///< 2 * axis, + 1 for the negative direction: the ray that proved it
};

/// REQUIRES the shells (numbers 0.. of shell_of_face) to be closed surfaces that are embedded and disjoint. Independent
/// of jobs.
/// @cost O(log F + hits) exact tests per shell; of six directions one with few boxes on its way is taken.
Nesting nest_shells(const TriangleMesh& mesh, const BoxGroups& boxes,
                    std::span<const std::uint32_t> shell_of_face, std::size_t num_shells, unsigned jobs);

}  // namespace veritope
