// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/dms/fast/boundary_volume.h: the volume of a simplex-spline solid from values on its boundary.
#pragma once
#include <cstddef>
#include <span>

#include "interval/interval.h"
#include "solids/dms/dms_face_pairs.h"

namespace veritope {

struct BoundaryVolumeOptions {
  std::size_t max_points = 100000;  ///< of the boundary, at least ten on each face
};

/// An enclosure of the volume of the image of the domain, for a map that is one to one with a positive determinant: the
/// volume of triangles with corners on the surface, and for each the distance of the surface from it times the area
/// between them. `bounds` are those of prove_face_pairs.
/// REQUIRES the complex of the model, and a model without defects (solids/dms/dms_defects.h).
/// @cost  a value at each point; the width is inversely proportional to the root of their number
Interval boundary_volume(const DmsModel& model, const TetrahedralComplex& complex,
                         std::span<const DmsFaceBounds> bounds,
                         const BoundaryVolumeOptions& options = {});

}  // namespace veritope
