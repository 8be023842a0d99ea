// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/dms/domain/tetrahedra_cover.h"

#include <utility>

#include "robust/base/box3d.h"

namespace veritope {
namespace {

Point3d rounded_place(const ExactPoint3& p) {
  return {p.rounded().x, p.rounded().y, p.rounded().z};
}

}  // namespace

// Rounding to nearest is monotone, so the box of the rounded corners contains the rounded points of a tetrahedron.
TetrahedraCover::TetrahedraCover(std::span<const ExactPoint3> points,
                                 std::vector<TetrahedronCorners> tetrahedra)
    : points_(points), tetrahedra_(std::move(tetrahedra)) {
  std::vector<Box3d> boxes;
  for (const TetrahedronCorners& t : tetrahedra_) {
    Box3d box = empty_box();
    for (const std::uint32_t v : t) add(rounded_place(points[v]), &box);
    boxes.push_back(box);
  }
  boxes_ = BoxHierarchy(boxes);
}

bool TetrahedraCover::is_in(std::uint32_t t, const ExactPoint3& p) const {
  for (std::size_t m = 0; m < 4; ++m) {
    std::array<const ExactPoint3*, 4> at;
    for (std::size_t i = 0; i < 4; ++i) at[i] = &points_[tetrahedra_[t][i]];
    at[m] = &p;
    if (orient3d(*at[0], *at[1], *at[2], *at[3]) == Sign::kNegative) return false;
  }
  return true;
}

std::optional<std::uint32_t> TetrahedraCover::find(const ExactPoint3& p) const {
  const Point3d at = rounded_place(p);
  const Box3d place{at, at};
  std::optional<std::uint32_t> out;
  boxes_.visit([&](const Box3d& box) { return meets(box, place); },
               [&](std::uint32_t t) {
                 if ((!out || t < *out) && is_in(t, p)) out = t;
               });
  return out;
}

}  // namespace veritope
