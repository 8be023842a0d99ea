// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/patches/finite_points_internal.h: whether a point can be a corner of a patch at all.
#pragma once
#include "predicates/vec.h"
#include "robust/binary64.h"

namespace veritope::internal {

inline bool is_finite(const Vec3d& v) {
  return veritope::is_finite(v.x) && veritope::is_finite(v.y) && veritope::is_finite(v.z);
}

}  // namespace veritope::internal
