// SPDX-License-Identifier: Apache-2.0 OR MIT
// dms_reach.h: the V_gamma that reach tetrahedra, in which directions they grow, and values of faces
// (docs/certificates/dms-solid-2.md, section 4).
#pragma once
#include <map>

#include "dms_near.h"

typedef std::vector<Big> DmsVector;  // three numbers

inline Big dms_product(const DmsVector& v, const Big* x) {
  return v[0] * x[0] + v[1] * x[1] + v[2] * x[2];
}

struct DmsFaceValues {  // L_gamma at the three corners, term after term
  std::vector<DmsPoint> values;
  DmsBox box;
};

struct DmsReach {
  const DmsModel& model;
  Units* units;
  const DmsNear near;
  DmsMatrices matrices;

  DmsReach(const DmsModel& m, Units* u) : model(m), units(u), near(m), matrices(m) {}

  // The V_gamma that reach a tetrahedron.
  const std::vector<DmsTerm>& terms(size_t tetrahedron);
  // Whether all G that reach a tetrahedron, along this vector, grow in the direction w.
  bool grows(size_t tetrahedron, const DmsVector& w, const DmsVector& along);
  DmsFaceValues values(const DmsFace& face);

 private:
  void add_values(const DmsTerm& term, const DmsFace& face, DmsFaceValues* r) const;

  std::map<size_t, std::vector<DmsTerm>> known;
};
