// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/vmodel/v_faces.h: the border of a V-model as oriented surfaces, and their patches.
// docs/certificates/vmodel.md, section 6.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "robust/base/result.h"
#include "solids/patches/patch.h"
#include "solids/vmodel/v_model.h"
#include "splines/bspline.h"

namespace veritope {

/// The border faces, in ascending order of their numbers; the normal points out of the cell where the determinant of
/// the cell, reversed if the model says so, is positive.
struct VFaces {
  std::vector<BSplineSurface<Rational>> surfaces;
  std::vector<VFaceNumber> faces;                            ///< the number of each
  std::vector<std::array<std::size_t, 2>> axes;              ///< of the cell, which are u and v
  std::vector<std::array<std::vector<Rational>, 2>> breaks;  ///< along u and v, in their parameters
};
VFaces border_of(const VModel& model);

/// The pieces of the surfaces between the breaks, surface by surface, along u slowest. Origins: kSurface, with the
/// number of the surface in the list. @error kOverLimit for over kMaxPatches patches
Result<std::vector<Patch>> patches_of(const VFaces& border);

}  // namespace veritope
