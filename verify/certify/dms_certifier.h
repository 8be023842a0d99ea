// SPDX-License-Identifier: LGPL-3.0-or-later
// verify/certify/dms_certifier.h: certify for simplex-spline solids. Theory: docs/THEORY.md, DMS-1, DMS-2. Pages:
// docs/certificates/dms-solid.md, dms-solid-2.md, dms-invalid.md. Design:
// docs/design/0091-certified-simplex-spline-solids.md, 0109-boundaries-by-pairs-of-faces.md.
#pragma once
#include "solids/dms/dms_model.h"
#include "verify/certify/certify.h"

namespace veritope {

/// What is known without a proof.
DmsFacts dms_facts_of(const DmsModel& model);

/// VALID with its certificate (dms-solid-1 or dms-solid-2); INVALID with one (dms-invalid-1) of the first finding; or
/// UNDECIDED: "not-certified", with the condition of the page that is not proved to hold and its place; or
/// "not-covered". Findings have the codes of fault_name, "jacobian", "patches-crossing" and "patches-touching".
/// @param subject  the bytes of the file
/// REQUIRES a model that validate() accepts.
/// @cost  an exact derivative for each tetrahedron and term; that of certify for the boundary
Certified certify_dms(const DmsModel& model, const certificate::Subject& subject,
                      const CertifyOptions& options);

}  // namespace veritope
