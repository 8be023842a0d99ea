// SPDX-License-Identifier: Apache-2.0 OR MIT
// dms_rule_h.h: values and derivatives of s along the paths of rule H of docs/formats/dms-files.md.
#pragma once
#include "dms_near.h"

struct DmsRuleH {  // REQUIRES D1
  DmsRuleH(const DmsModel& model, Units* units);

  // False if u lies in no closed tetrahedron. Else *inside gets the point towards which the path leads; its W is 0
  // where the path is u + e(epsilon).
  bool find_path(const DmsPoint& u, DmsPoint* inside) const;
  // x, y, z of s, and Ds / n row by row. REQUIRES that u lies in a closed tetrahedron. terms: those that are not 0
  // near u on the path, and any other ones.
  std::vector<Ratio> value(const DmsPoint& u, const std::vector<DmsTerm>& terms) const;
  std::vector<Ratio> derivative(const DmsPoint& u, const std::vector<DmsTerm>& terms) const;
  std::vector<DmsTerm> terms(const DmsPoint& u) const;  // those that may differ from 0 near u

  const DmsModel& model;
  const DmsNear near;

 private:
  Units* units_;
  const std::vector<DmsBox> boxes_;  // of the tetrahedra of knots 0
  const DmsBoxes tree_;
};
