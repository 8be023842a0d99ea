// SPDX-License-Identifier: LGPL-3.0-or-later
// io/splines/volume_faces.h: the boundary of the volumes of a spline model, as patches.
// Design: docs/design/0015-patch-complex.md.
#pragma once
#include <cstdint>
#include <vector>

#include "io/splines/spline_model.h"
#include "io/splines/volume_face.h"
#include "robust/base/result.h"
#include "solids/patches/patch.h"

namespace veritope {

struct VolumeFaces {
  std::vector<Patch> patches;           ///< Bezier pieces; numbers: 6 piece + 2 axis + end
  std::vector<VolumeFace> places;       ///< where each of the patches lies; each is a piece
  std::uint64_t num_volumes = 0;        ///< entities
  std::uint64_t num_others = 0;         ///< entities that are not volumes; they are not examined
  std::uint64_t num_flat = 0;           ///< faces without area that were left out
  std::vector<std::uint64_t> mirrored;  ///< entities that are left-handed
  /// Entities with coordinates from the fourth on, which the patches do not have.
  std::vector<std::uint64_t> with_attributes;
};
/// The faces of the Bezier pieces of all volumes, except walls, which two pieces share as a whole and exactly
/// (faces_of), and faces without area: points, and faces whose homogeneous control points are equal along an axis up to
/// a factor (where a volume is collapsed onto an axis, for example). The sign of the Jacobian determinant in the middle
/// of a piece, the first piece where it is not 0, decides: if it is positive, normals point out of the volume; if it is
/// negative, the volume is mirrored first (its first two axes change places). It is not tested whether the determinant
/// has one sign everywhere, nor whether the patches bound a solid.
/// At an inner knot where a volume is torn, both of its sides are faces.
/// @error kEmpty without a volume, and where no face is left (a flat volume). With the entity: kBadArgument for one
/// with fewer than three coordinates, kOverLimit for over kMaxPatches faces before walls go, and for a determinant that
/// rounded numbers do not decide and whose exact numbers are longer than 2^16 bits.
Result<VolumeFaces> volume_faces(const SplineModel& model);

}  // namespace veritope
