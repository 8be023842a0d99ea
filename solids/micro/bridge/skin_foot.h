// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/micro/bridge/skin_foot.h: the point of a solid's surface that is nearest to a point, whatever bounds the
// solid.
#pragma once
#include <functional>

#include "interval/interval.h"
#include "robust/base/box3d.h"
#include "solids/classify/mesh_projection.h"
#include "solids/classify/patch_projection.h"

namespace veritope {

struct SkinFoot {
  Point3d at{};               ///< approximate: near a nearest point; on a tie near the first one
  Interval squared_distance;  ///< contains the square of the distance from the surface
};

/// PointProjection of [HPE22]. Several threads may call it.
using SkinFeet = std::function<SkinFoot(const ExactPoint&)>;

/// The projection must outlive the function.
SkinFeet feet_on(const MeshProjection& projection);
SkinFeet feet_on(const PatchProjection& projection);

}  // namespace veritope
