// SPDX-License-Identifier: LGPL-3.0-or-later
// verify/certify/mesh_facts.h: what certify says of a mesh beside its verdict.
#pragma once
#include "solids/polyhedron/validity.h"

namespace veritope {

/// The decision, without its defects (they are the findings) and without the stars (they are in the certificate).
struct MeshFacts {
  ValidityReport decision;
};

}  // namespace veritope
