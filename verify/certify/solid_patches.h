// SPDX-License-Identifier: LGPL-3.0-or-later
// verify/certify/solid_patches.h: a spline file as the solid that a certificate about something else speaks of:
// docs/certificates/micro-inside.md, section 8.
#pragma once
#include <string>
#include <variant>

#include "io/splines/read_splines.h"
#include "solids/base/finding.h"
#include "verify/certify/certify.h"
#include "verify/certify/file_patches.h"
#include "verify/format/star_box_certificate.h"

namespace veritope {

/// Patches that bound a solid, none of them reversed.
struct SolidPatches {
  FilePatches patches;
  certificate::StarBoxBody body;  ///< of star-box-2
  std::string format;             ///< "vjson", or "vjson-faces" for the boundary faces of volumes
};

/// The surfaces and triangles of the file, or the boundary faces of its volumes; or why they are no such solid:
/// "model-invalid" if they are not proved to bound one, "not-covered" if checkers cannot read them in the file's own
/// bytes.
std::variant<SolidPatches, Finding> solid_patches_of(const SplineFile& file,
                                                     const CertifyOptions& options);

}  // namespace veritope
