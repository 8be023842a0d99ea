// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/polyhedron/reversal.h: meshes that bound a solid once some faces are reversed.
// Certificate: docs/certificates/mesh-reversed.md.  Design: docs/design/0050-reversed-meshes.md.
#pragma once
#include <cstdint>
#include <vector>

#include "solids/polyhedron/triangle_mesh.h"
#include "solids/polyhedron/validity.h"

namespace veritope {

/// The faces that are reversed.
struct Reversal {
  struct OfShell {
    std::uint64_t faces = 0, reversed = 0;
  };
  std::vector<bool> is_reversed;   ///< for each face
  std::vector<OfShell> shells;     ///< for each shell of the report
  std::uint64_t faces = 0;         ///< reversed in all
  std::uint64_t whole_shells = 0;  ///< all of their faces are reversed: they were inside out
  std::uint64_t mixed_shells = 0;  ///< others of which some faces are reversed
};

struct ReversedSolid {
  TriangleMesh mesh;
  ValidityReport report;  ///< of `mesh`: valid
  Reversal reversal;
};

/// Whether the mesh is invalid, and rules M5, M8 and M9 are the only ones that it breaks. Its shells are then embedded
/// closed surfaces, which have two sides, so that reversing faces makes it valid.
bool is_valid_once_reversed(const ValidityReport& report);

/// The mesh with the reversed faces: (a, b, c) becomes (a, c, b). It is the only valid mesh that differs from `mesh` in
/// the orientation of faces alone. REQUIRES report = decide_validity(mesh, ...), is_valid_once_reversed(report).
/// @cost linear, and that of another decision if M5 is broken
ReversedSolid reverse_to_solid(TriangleMesh mesh, ValidityReport report, unsigned jobs);

}  // namespace veritope
