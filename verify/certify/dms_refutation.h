// SPDX-License-Identifier: LGPL-3.0-or-later
// verify/certify/dms_refutation.h: what is wrong with a simplex-spline solid, as certificates and reports have it.
// Theory: docs/THEORY.md, DMS-2. The page: docs/certificates/dms-invalid.md.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "solids/base/finding.h"
#include "solids/dms/dms_defects.h"
#include "solids/dms/dms_evaluator.h"
#include "solids/dms/dms_jacobian.h"
#include "solids/dms/dms_tiles.h"
#include "solids/dms/fast/overlap_search.h"
#include "verify/certify/dms_facts.h"
#include "verify/certify/patch_decision.h"
#include "verify/format/dms_invalid_certificate.h"

namespace veritope {

/// A finding, what belongs to it, and the witness for the certificate.
struct DmsRefutation {
  Finding finding;
  DmsDefectFacts facts;
  certificate::DmsInvalidFinding proof;
};

std::vector<certificate::DmsPlaneProof> proofs_of(const std::vector<DmsPlane>& planes);

/// REQUIRES the complex of the model.
DmsRefutation refutation_of(const DmsDefect& defect, const TetrahedralComplex& complex);
/// Nothing if the leaf is only not proved.
std::optional<DmsRefutation> refutation_of(const DmsOpenLeaf& leaf);

/// A tile of a face of the boundary.
struct DmsPiece {
  TetrahedronFace face = 0;
  DmsTile tile;
};
/// What a refutation of the surface says of the map: points of the domain with one image, or a crossing of two pieces.
/// Nothing for a reversed shell, and if both points of a contact are one point of the domain.
/// @param pieces  one for each patch, in order
std::optional<DmsRefutation> refutation_of(const PatchRefutation& refutation,
                                           const std::vector<DmsPiece>& pieces,
                                           DmsEvaluator& evaluator);

/// A point of a tetrahedron's image inside of that of another one.
/// REQUIRES degree 1, and positive determinants. @cost near-linear if few images are near each other
std::optional<DmsRefutation> find_image_overlap(const DmsModel& model);

DmsRefutation refutation_of(const DmsCoveredPlace& overlap);

/// Whether the numbers of a body are as short as its page demands.
bool has_short_numbers(const certificate::DmsInvalidBody& body);
bool are_short(const std::vector<certificate::DmsPlaneProof>& planes);

}  // namespace veritope
