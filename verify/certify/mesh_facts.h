// SPDX-License-Identifier: LGPL-3.0-or-later
// verify/certify/mesh_facts.h: what certify says of a mesh beside its verdict.
#pragma once
#include <optional>

#include "solids/polyhedron/reversal.h"
#include "solids/polyhedron/validity.h"

namespace veritope {

/// The decision, without its evidence (the defects are the findings) and without the stars (they are in the
/// certificate).
struct MeshFacts {
  ValidityReport decision;  ///< if faces are reversed: of the mesh with the reversed faces
  std::optional<OpenEdges> open_edges;  ///< as in DefectList
  std::optional<Reversal>
      reversal;  ///< the faces that PatchOrientation::kAuto reversed, if there are any
};

}  // namespace veritope
