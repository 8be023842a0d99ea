// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/micro/bridge/skin_foot.h"

#include "interval/box_geometry.h"
#include "interval/ring_numbers.h"
#include "interval/upward.h"

namespace veritope {

SkinFeet feet_on(const MeshProjection& projection) {
  return [&projection](const ExactPoint& point) {
    const MeshProjectionAnswer answer = projection.project(point);
    SkinFoot out;
    for (std::size_t c = 0; c < 3; ++c) out.at[c] = nearest_double(answer.nearest.front().point[c]);
    const ScopedUpward upward;
    out.squared_distance = enclose(answer.squared_distance);
    return out;
  };
}

SkinFeet feet_on(const PatchProjection& projection) {
  return [&projection](const ExactPoint& point) {
    const PatchProjectionAnswer answer = projection.project(point);
    SkinFoot out;
    out.at = internal::approx_middle(answer.places.front().point);
    out.squared_distance = answer.squared_distance;
    return out;
  };
}

}  // namespace veritope
