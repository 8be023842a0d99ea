// SPDX-License-Identifier: Apache-2.0 OR MIT
#include "dms_reach.h"

#include "dms_pieces.h"

const std::vector<DmsTerm>& DmsReach::terms(size_t tetrahedron) {
  const auto found = known.find(tetrahedron);
  if (found != known.end()) return found->second;
  std::vector<const DmsPoint*> corners;
  for (size_t c = 0; c < 4; ++c) corners.push_back(&model.corner(tetrahedron, c));
  DmsSides sides = dms_sides_of_leaf(corners, {}, {});
  return known[tetrahedron] = near.not_excluded(DmsBox(corners), &sides, units);
}
bool DmsReach::grows(size_t tetrahedron, const DmsVector& w, const DmsVector& along) {
  for (const DmsTerm& term : terms(tetrahedron)) {
    units->add(1);
    const std::vector<Big>& g = matrices.of(term);
    Big x;
    for (size_t k = 0; k < 3; ++k)
      x = x + (w[0] * g[k] + w[1] * g[3 + k] + w[2] * g[6 + k]) * along[k];
    if (x.sign() <= 0) return false;
  }
  return true;
}
DmsFaceValues DmsReach::values(const DmsFace& face) {
  DmsFaceValues r;
  for (const DmsTerm& term : terms(face.tetrahedron)) {
    units->add(3);
    add_values(term, face, &r);
  }
  return r;
}
// lambda_m(q|w) is, with homogeneous points, d with q in the place of the m-th times its denominator, divided by d of
// all and the denominator of q.
void DmsReach::add_values(const DmsTerm& term, const DmsFace& face, DmsFaceValues* r) const {
  const DmsPoint* w[4];
  const Ratio* c[4];
  dms_corners(model, term, w, c);
  std::vector<Ratio> numbers;
  for (size_t m = 0; m < 4; ++m) numbers.insert(numbers.end(), c[m], c[m] + 3);
  Big factor;
  const std::vector<Big> images = dms_integers(numbers, &factor);
  DmsPlane opposite[4];
  for (size_t m = 0; m < 4; ++m)
    opposite[m] = DmsPlane::of(*w[m == 0 ? 1 : 0], *w[m < 2 ? 2 : 1], *w[m < 3 ? 3 : 2]);
  const Big all = opposite[3].value(*w[3]);
  for (uint32_t vertex : face.vertex) {
    const DmsPoint& q = model.place(vertex);
    Big x[4];
    for (size_t m = 0; m < 4; ++m) {
      const Big d = opposite[m].value(q) * w[m]->x[3];
      for (size_t k = 0; k < 3; ++k) {
        const Big part = d * images[3 * m + k];
        x[k] = m % 2 == 1 ? x[k] + part : x[k] - part;
      }
    }
    x[3] = all * q.x[3] * factor;
    r->values.push_back(DmsPoint::of(x));
    r->box.add(r->values.back());
  }
}
