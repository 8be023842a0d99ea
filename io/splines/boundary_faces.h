// SPDX-License-Identifier: LGPL-3.0-or-later
// io/splines/boundary_faces.h: the boundary faces of volumes as B-spline surfaces, as certificates number them.
// The rule: docs/certificates/reading-rule-faces.md, which the checkers implement independently.
#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "io/splines/spline_model.h"
#include "io/splines/volume_face.h"
#include "robust/base/result.h"
#include "solids/patches/patch.h"

namespace veritope {

/// The sign of the Jacobian determinant at those corners of a volume where it is not 0; kZero if it is 0 at all of
/// them, and for a volume that the rule refuses for another reason. Nothing if it has different signs: then the volume
/// folds.
std::optional<Sign> hand_at_corners(const ExactVolume& volume);

/// Whether section 1 of the rule holds: all entities are volumes with at least three coordinates and clamped axes,
/// not torn at inner knots, and with numbers of bounded length.
bool are_clamped_volumes(const SplineModel& model);

struct BoundaryFaces {
  SplineModel model;              ///< surfaces, without groups and attributes
  std::vector<VolumeFace> faces;  ///< one for each of them; by volume, axis and end
  std::uint64_t num_flat = 0;     ///< faces without area that were left out
  std::uint64_t num_walls = 0;    ///< pairs of faces that were left out
};
/// Coordinates from the fourth on, attributes, are left out.
/// @error  where the rule refuses the model, with the entity: kBadArgument for one that is not a volume, that has fewer
/// than three coordinates, an axis without clamped ends or with a knot at which it may be torn, or too long numbers, or
/// that folds at its corners. kEmpty if no face is left.
/// @cost  near-linear in the control points of the faces
Result<BoundaryFaces> boundary_faces(const SplineModel& model);

/// Whether the Bezier pieces of the faces are these patches, in whatever order and parametrisation by turned domains,
/// with the same normals.
bool have_same_pieces(const BoundaryFaces& faces, std::span<const Patch> patches);

}  // namespace veritope
