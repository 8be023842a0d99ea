// SPDX-License-Identifier: Apache-2.0 OR MIT
#include "dms_rule_h.h"

DmsRuleH::DmsRuleH(const DmsModel& m, Units* units)
    : model(m), near(m), units_(units), boxes_(dms_boxes_of_corners(m)), tree_(boxes_) {}

bool DmsRuleH::find_path(const DmsPoint& u, DmsPoint* inside) const {
  bool is_found = false;
  size_t first = 0;
  for (uint32_t t : tree_.near(DmsBox({&u}))) {
    const DmsPoint* corner[4];
    for (size_t c = 0; c < 4; ++c) corner[c] = &model.corner(t, c);
    std::vector<DmsPlane> planes;
    add_dms_faces(corner, &planes);
    bool is_closed = true, is_entered = true;
    for (const DmsPlane& plane : planes) {
      int side = plane.side(u);
      is_closed = is_closed && side <= 0;
      for (int k = 0; k < 3 && side == 0; ++k) side = plane.a[k].sign();
      is_entered = is_entered && side < 0;
    }
    if (is_entered) {
      inside->x[3] = Big();
      return true;
    }
    if (is_closed && !is_found) first = t;
    is_found = is_found || is_closed;
  }
  if (is_found) *inside = dms_middle(model, first);
  return is_found;
}
std::vector<DmsTerm> DmsRuleH::terms(const DmsPoint& u) const {
  DmsSides sides({&u}, {}, true);
  return near.not_excluded(DmsBox({&u}), &sides, units_);
}
std::vector<Ratio> DmsRuleH::value(const DmsPoint& u, const std::vector<DmsTerm>& terms) const {
  DmsPoint inside;
  find_path(u, &inside);
  return DmsPlace(model, u, inside.x[3].sign() == 0 ? nullptr : &inside).value(terms, units_);
}
std::vector<Ratio> DmsRuleH::derivative(const DmsPoint& u,
                                        const std::vector<DmsTerm>& terms) const {
  DmsPoint inside;
  find_path(u, &inside);
  return DmsPlace(model, u, inside.x[3].sign() == 0 ? nullptr : &inside).derivative(terms, units_);
}
