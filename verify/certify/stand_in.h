// SPDX-License-Identifier: LGPL-3.0-or-later
// verify/certify/stand_in.h: what certificates speak of where that is not the entities of the spline file itself: the
// boundary faces of its volumes, or a .vjson model with its surfaces and triangles or these faces.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "io/splines/boundary_faces.h"
#include "io/splines/read_splines.h"
#include "robust/base/result.h"
#include "solids/patches/patch_complex.h"
#include "solids/vmodel/v_model.h"
#include "verify/certify/file_patches.h"

namespace veritope {

struct StandIn {
  std::string
      bytes;  ///< of a .vjson file, the copy; empty: certificates speak of the file's own bytes
  SplineFile file;  ///< the copy, read; or the file with its boundary faces as its model
  /// For volumes, where each of the model's surfaces lies on those of the file, in a copy, too. Without volumes the
  /// model's entities have the numbers of the file's.
  std::vector<VolumeFace> faces;
  std::string what;  ///< "its 7 surfaces", "the 24 boundary faces of its 7 volumes"
  bool is_of_volumes = false;

  /// Whether certificates number the boundary faces of the file's own volumes.
  bool is_by_own_faces() const { return is_of_volumes && !is_copy(); }
  bool is_copy() const { return !bytes.empty(); }
};

/// Nothing for a file of surfaces and triangles that the checkers read, and nothing where there is no such model:
/// entities that are not in space, or that are neither surfaces, triangles nor volumes; volumes beside others; a file
/// from which shapes were left out. Volumes of a file that the checkers read have a copy only where the faces of
/// boundary_faces do not have the pieces of volume_faces.
/// @error as volume_faces, with the entity; kOverLimit, before anything is computed, for a volume of a degree over
/// kMaxPatchDegree; kBadArgument for a volume whose Jacobian determinant has different signs at
/// its corners, or there and in its middle
Result<std::optional<StandIn>> stand_in_of(const SplineFile& file);

/// The numbers of the volumes' faces on which these lie: 6 volume + 2 axis + end, ascending.
std::vector<VFaceNumber> whole_faces(const std::vector<VolumeFace>& faces);

/// The patches of the file's surfaces and triangles, or of the boundary faces of its volumes, as they are decided when
/// nothing is reversed. @param stand_in  that of the file. @error as file_patches
Result<FilePatches> patches_of(const SplineFile& file, const std::optional<StandIn>& stand_in);

/// The file with the first three coordinates of its volumes. Checkers, which leave out the others, too, read its own
/// bytes, unless these others have longer numbers than they may.
SplineFile without_attributes(const SplineFile& file);

/// Whether the checkers have a reading rule for the file's own bytes: docs/certificates.
bool is_read_by_checkers(const SplineFile& file);

/// Why certificates cannot speak of the file or of a stand-in for it, in words that say what the file holds, and what
/// helps if something does. Nothing if they can.
std::optional<std::string> uncovered_shapes(const SplineFile& file);

}  // namespace veritope
