// SPDX-License-Identifier: LGPL-3.0-or-later
// verify/certify/micro_inside_certifier.h: certify for microstructures inside of solids. Theory: docs/THEORY.md,
// MICRO-2. The page: docs/certificates/micro-inside.md. Design: docs/design/0080-microstructures-inside-solids.md.
#pragma once
#include "verify/certify/micro_certifier.h"

namespace veritope {

/// VALID with its certificate (micro-inside-1); or UNDECIDED: as certify_microstructure; "model-invalid", if the mesh
/// or the splines are not a solid; "not-inside", with the condition of the page that is not proved to hold, the cell
/// and the triangle or patch.
/// @param subject  the bytes of the microstructure's file
/// REQUIRES validate(micro).
/// @cost  those of certify_microstructure and of certify for the model, and that of prove_inside
Certified certify_inside(const Microstructure& micro, const certificate::Subject& subject,
                         const ModelFile& model, const CertifyOptions& options);

}  // namespace veritope
