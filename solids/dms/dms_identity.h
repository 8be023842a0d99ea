// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/dms/dms_identity.h: a model from tetrahedra: the identity on them, of degree 1, as `make` takes it.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "robust/base/result.h"
#include "solids/dms/dms_model.h"

namespace veritope {

/// The vertices of the model are the points that are corners, in the order of the points; its tetrahedra are in the
/// order given. It has no attributes.
/// REQUIRES numbers of points, four different ones in each tetrahedron.
/// @error kBadArgument without tetrahedra; kOverLimit as validate(), with the point or the number that is over it
Result<DmsModel> identity_dms(std::span<const DmsPoint> points,
                              std::span<const TetrahedronCorners> tetrahedra);

}  // namespace veritope
