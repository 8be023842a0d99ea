// SPDX-License-Identifier: LGPL-3.0-or-later
// verify/certify/fold_certifier.h: certify for files of volumes one of which folds.
#pragma once
#include <optional>

#include "io/splines/read_splines.h"
#include "verify/certify/certify.h"
#include "verify/certify/volume_fold.h"

namespace veritope {

/// INVALID with its certificate (volume-folded-1), if find_fold finds two points in one of the file's volumes and the
/// claim can be made about the file's own bytes or about a copy with all of its volumes. A copy is made of a file that
/// the checkers do not read, and of volumes with axes that are not clamped, which are clamped in it.
/// Nothing for a file with other entities than volumes in space, one whose numbers exceed the limits of certificates,
/// and one with a volume that may be torn at an inner knot.
std::optional<Certified> certify_fold(const SplineFile& file, const CertifyOptions& options);

/// INVALID with its certificate about two points that are known. Nothing if their numbers are too long. REQUIRES a file
/// with only volumes, and a fold of one of them.
std::optional<Certified> certify_fold_at(const SplineFile& file, const VolumeFold& fold,
                                         const CertifyOptions& options);

/// The finding about such points, "folded", whether or not it can be certified. REQUIRES as above.
Finding fold_finding(const SplineFile& file, const VolumeFold& fold);

}  // namespace veritope
