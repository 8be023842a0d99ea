// SPDX-License-Identifier: LGPL-3.0-or-later
#include "predicates/orient3d.h"
#include "predicates/projection.h"
#include "solids/classify/facet_box_internal.h"

namespace veritope::internal {
namespace {

Vec3d corner_of(const Box3d& box, unsigned i) {
  return {(i & 1u) != 0 ? box.hi[0] : box.lo[0], (i & 2u) != 0 ? box.hi[1] : box.lo[1],
          (i & 4u) != 0 ? box.hi[2] : box.lo[2]};
}

// Whether the plane of the triangle misses the box. A degenerate triangle has none.
bool plane_misses(const std::array<Vec3d, 3>& t, const Box3d& box) {
  const Sign first = orient3d(t[0], t[1], t[2], corner_of(box, 0));
  if (first == 0) return false;
  for (unsigned i = 1; i < 8; ++i)
    if (orient3d(t[0], t[1], t[2], corner_of(box, i)) != first) return false;
  return true;
}

// Whether the line through a and b, seen along the axis, has the box strictly on one side, and c not on that side.
bool line_separates(const Vec2d& a, const Vec2d& b, const Vec2d& c, const Box3d& box, int axis) {
  Sign side = Sign::kZero;
  for (unsigned i = 0; i < 8; ++i) {
    if ((i >> axis & 1u) != 0) continue;  // the opposite side of the box looks the same
    const Sign s = orient2d(a, b, drop_axis(corner_of(box, i), axis));
    if (s == 0 || s * side == Sign::kNegative) return false;
    side = s;
  }
  return orient2d(a, b, c) != side;
}

}  // namespace

bool facet_meets(const std::array<Vec3d, 3>& t, const Box3d& box) {
  Box3d around = empty_box();
  for (const Vec3d& p : t) add(to_point(p), &around);
  if (!meets(around, box)) return false;
  if (is_inside(around, box)) return true;
  if (plane_misses(t, box)) return false;
  for (int axis = 0; axis < 3; ++axis) {
    const std::array<Vec2d, 3> s = {drop_axis(t[0], axis), drop_axis(t[1], axis),
                                    drop_axis(t[2], axis)};
    for (std::size_t i = 0; i < 3; ++i)
      if (line_separates(s[i], s[(i + 1) % 3], s[(i + 2) % 3], box, axis)) return false;
  }
  return true;
}

}  // namespace veritope::internal
