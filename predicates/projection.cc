// SPDX-License-Identifier: LGPL-3.0-or-later
#include "predicates/projection.h"

namespace veritope {

AxisProjection projection_of(const Vec3d& a, const Vec3d& b, const Vec3d& c) noexcept {
  for (const int axis : {2, 0, 1}) {
    const Sign3 s = orient2d_filter(drop_axis(a, axis), drop_axis(b, axis), drop_axis(c, axis));
    if (is_certain(s)) return {axis, to_sign(s)};
  }
  for (const int axis : {2, 0, 1}) {
    const Sign s = internal::orient2d_after_filter(drop_axis(a, axis), drop_axis(b, axis),
                                                   drop_axis(c, axis), nullptr);
    if (s != Sign::kZero) return {axis, s};
  }
  return {2, Sign::kZero};
}

}  // namespace veritope
