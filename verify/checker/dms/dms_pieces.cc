// SPDX-License-Identifier: Apache-2.0 OR MIT
#include "dms_pieces.h"

namespace {

// T2: from a triangle in the plane `own`.
bool is_excluded(const DmsModel& model, const std::vector<uint32_t>& knots, const DmsPlane& own,
                 DmsSides* sides) {
  bool above = false, below = false;
  DmsMask whole = sides->all(), inside = whole;
  for (uint32_t k : knots) {
    const int side = own.side(model.points[k]);
    above = above || side > 0;
    below = below || side < 0;
    whole &= sides->mask(model, k);
    if (side == 0) inside &= sides->mask(model, k);
  }
  if (whole.any()) return true;
  if (above && below) return false;
  return inside.any();  // without knots in the plane it has all bits
}

}  // namespace

DmsSides dms_sides_of_leaf(const std::vector<const DmsPoint*>& leaf, std::vector<DmsPlane> planes,
                           const std::vector<Ratio>& listed) {
  add_dms_faces(leaf.data(), &planes);
  for (size_t i = 0; i < listed.size(); i += 4) planes.push_back(DmsPlane::of(&listed[i]));
  return DmsSides(leaf, planes, false);
}
DmsPlane upright_plane(const DmsPoint& a, const DmsPoint& b, const DmsPlane& along) {
  Big e[3], v[4];
  for (int k = 0; k < 3; ++k) e[k] = b.x[k] * a.x[3] - a.x[k] * b.x[3];
  for (int k = 0; k < 3; ++k) {
    const int i = (k + 1) % 3, j = (k + 2) % 3;
    const Big x = e[i] * along.a[j] - e[j] * along.a[i];
    v[k] = x * a.x[3];
    v[3] = v[3] - x * a.x[k];
  }
  return DmsPlane::of(v);
}
std::vector<DmsTerm> terms_on_triangle(const DmsNear& near,
                                       const std::vector<const DmsPoint*>& corners,
                                       const std::vector<Ratio>& listed, Units* units,
                                       size_t number) {
  const DmsPlane own = DmsPlane::of(*corners[0], *corners[1], *corners[2]);
  std::vector<DmsPlane> upright;
  for (size_t c = 0; c < 3; ++c)
    upright.push_back(upright_plane(*corners[c], *corners[(c + 1) % 3], own));
  for (size_t i = 0; i < listed.size(); i += 4) upright.push_back(DmsPlane::of(&listed[i]));
  DmsSides sides(corners, upright, true);
  const std::vector<DmsTerm> terms =
      near.filtered(DmsBox(corners), &sides, units, [&](const std::vector<uint32_t>& knots) {
        return !is_excluded(near.model, knots, own, &sides);
      });
  near.each_cut(terms, units, [&](const std::array<uint32_t, 3>& knots) {
    if (is_excluded(near.model, std::vector<uint32_t>(knots.begin(), knots.end()), own, &sides))
      return;
    const DmsPlane plane = near.plane_of(knots);
    bool is_inside = true;
    for (uint32_t k : knots) is_inside = is_inside && own.side(near.model.points[k]) == 0;
    require(plane.is_zero() || is_inside || sides.is_beside(plane), units->id,
            "a cut is in the way of tile", number);
  });
  return terms;
}
