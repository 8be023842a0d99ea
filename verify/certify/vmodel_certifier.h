// SPDX-License-Identifier: LGPL-3.0-or-later
// verify/certify/vmodel_certifier.h: certify for files of volumes, the cells of a V-model.
// Theory: docs/THEORY.md, VMODEL-1. Design: docs/design/0063-v-models.md.
#pragma once
#include <optional>
#include <vector>

#include "io/splines/read_splines.h"
#include "verify/certify/certify.h"
#include "verify/certify/volume_fold.h"

namespace veritope {

struct VModelAnswer {
  /// VALID with its certificate (vmodel-1), if the file's volumes are mapped one to one and bound a solid; INVALID with
  /// that of a fold (volume-folded-1) or of something else that is wrong (vmodel-invalid-1); or UNDECIDED with the
  /// reason, cell and place named.
  Certified certified;
  std::vector<VFaceNumber> border;  ///< the faces that are neither glued nor collapsed, ascending
  bool has_proved_cells = false;    ///< what is not decided, if anything, is the boundary
  std::vector<VolumeFold> folds;    ///< of cells whose determinants were found to have both signs
};

/// kAuto reverses left-handed cells. Nothing for a file with other entities than volumes in space, or where no
/// certificate can speak of its volumes.
std::optional<VModelAnswer> certify_vmodel(const SplineFile& file, const CertifyOptions& options);

}  // namespace veritope
