// SPDX-License-Identifier: Apache-2.0 OR MIT
// dms_invalid_crossing.cc: W12 of docs/certificates/dms-invalid.md.
#include "dms_invalid.h"
#include "dms_pieces.h"
#include "dms_rule_h.h"

namespace {

const char kId[] = "W12";

struct DmsPiece {
  const DmsFace* face;
  DmsPlane plane;  // of the face
  std::vector<DmsPoint> points;

  std::vector<const DmsPoint*> corners() const { return {&points[0], &points[1], &points[2]}; }
};
DmsPlane plane_of(const std::vector<const DmsPoint*>& p) {
  return DmsPlane::of(*p[0], *p[1], *p[2]);
}
// -1, 0 or 1 on a line, or 2 on both of its sides: where the points lie.
int side_of(const DmsPlane& upright, const std::vector<const DmsPoint*>& points) {
  int r = 0;
  for (const DmsPoint* p : points) {
    const int side = upright.side(*p);
    if (side != 0 && r != 0 && side != r) return 2;
    r = side != 0 ? side : r;
  }
  return r;
}

DmsPiece piece(const DmsModel& model, const DmsFinding& f, size_t number) {  // part (p)
  const size_t at = place_in_boundary(model, f.faces[number]);
  require(at < model.faces.size(), kId, "not of the boundary: the face of piece", number);
  DmsPiece r;
  r.face = &model.faces[at];
  for (size_t i = 0; i < 3; ++i) r.points.push_back(f.point(3 * number + i));
  std::vector<const DmsPoint*> q;
  for (uint32_t v : r.face->vertex) q.push_back(&model.place(v));
  r.plane = plane_of(q);
  for (const DmsPoint& p : r.points)
    require(r.plane.value(p).sign() == 0, kId, "a point is not in the plane of piece", number);
  for (size_t c = 0; c < 3; ++c) {
    const DmsPlane upright = upright_plane(*q[c], *q[(c + 1) % 3], r.plane);
    std::vector<const DmsPoint*> all = r.corners();
    all.push_back(q[(c + 2) % 3]);
    require(side_of(upright, all) != 2, kId, "a point is outside of the face of piece", number);
  }
  require(dms_dot(plane_of(r.corners()), r.plane).sign() > 0, kId, "turned, or flat: piece",
          number);
  return r;
}

// Part (d): why points inside of the first piece are none of the points of B.
bool are_parted_by_a_side(const DmsPiece& s, const DmsPiece& t) {
  for (const DmsPiece* of : {&s, &t})
    for (size_t c = 0; c < 3; ++c) {
      const DmsPlane line = upright_plane(of->points[c], of->points[(c + 1) % 3], s.plane);
      if (side_of(line, s.corners()) * side_of(line, t.corners()) == -1) return true;
    }
  return false;
}
bool are_disjoint(const DmsPiece& s, const DmsPiece& t, const Crossing& x) {
  if (!have_equal_vertices(*s.face, *t.face) || are_parted_by_a_side(s, t)) return true;
  for (size_t i = 0; i < 3; ++i)
    if (!dms_equal(s.points[i], t.points[i])) return false;
  return are_apart(x.sheet[0].t[0], x.sheet[1].t[0]) || are_apart(x.sheet[0].t[1], x.sheet[1].t[1]);
}

}  // namespace

void check_dms_crossing(const DmsModel& model, const DmsFinding& f, Units* units) {
  units->id = kId;
  const DmsPiece pieces[2] = {piece(model, f, 0), piece(model, f, 1)};
  const DmsRuleH rule(model, units);
  std::vector<DmsTerm> terms[2];
  for (size_t i = 0; i < 2; ++i)
    terms[i] = terms_on_triangle(rule.near, pieces[i].corners(), f.planes[i], units, i);
  check_intervals(f.crossing, true, kId);
  require(are_disjoint(pieces[0], pieces[1], f.crossing), kId, "A and B may have a common point");
  const int n = model.file.n;
  const DmsInterpolation interpolation(n, 3);
  Patch patches[2];
  for (size_t i = 0; i < 2; ++i) {
    patches[i].shape = Shape{true, n, n};
    const std::vector<Ratio> b = interpolation.coefficients(
        pieces[i].corners().data(), [&](const DmsPoint& u) { return rule.value(u, terms[i]); });
    Big scale;
    const std::vector<Big> integers = dms_integers(b, &scale);
    for (size_t k = 0; k < integers.size(); ++k) {
      patches[i].net.push_back(integers[k]);
      if (k % 3 == 2) patches[i].net.push_back(scale);
    }
  }
  check_signs(f.crossing, patches[0], patches[1], kId, kId);
}
