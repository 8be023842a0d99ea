// SPDX-License-Identifier: LGPL-3.0-or-later
// verify/certify/mesh_certifier.h: from a decided mesh to its certificate. All searching is done here; the checkers do
// not search.
#pragma once
#include <span>

#include "robust/base/work_share.h"
#include "solids/polyhedron/reversal.h"
#include "solids/polyhedron/triangle_mesh.h"
#include "solids/polyhedron/validity.h"
#include "verify/format/mesh_certificate.h"

namespace veritope {

/// The certificate of what `report` says of `mesh`: mesh-valid-1, or mesh-invalid-1 with one witness for each broken
/// rule (except M7 if only M2's pairs break it: then M2 has the witness). REQUIRES report = decide_validity(mesh,
/// options) with max_defects >= 1, and its defects. The bytes do not depend on `jobs`. The search of a valid
/// mesh's pairs of facets and the search of their axes are steps of `work`, if it is not null; where facets are long
/// and thin, both are one step.
/// @cost approximately that of the decision. Throws InternalError if a proper pair has no code: a bug, never a property
/// of the model.
certificate::Bytes make_mesh_certificate(const TriangleMesh& mesh, const ValidityReport& report,
                                         std::span<const Finding> defects,
                                         const certificate::Subject& subject, unsigned jobs,
                                         WorkShare* work = nullptr);

/// The body of mesh-valid-1. REQUIRES a report of a valid mesh, as above.
certificate::ValidBody make_valid_body(const TriangleMesh& mesh, const ValidityReport& report,
                                       unsigned jobs, WorkShare* work = nullptr);

/// The certificate mesh-reversed-1 of a file whose triangles, with those of the reversal reversed, are `solid.mesh`.
certificate::Bytes make_mesh_certificate(const ReversedSolid& solid,
                                         const certificate::Subject& subject, unsigned jobs,
                                         WorkShare* work = nullptr);

}  // namespace veritope
