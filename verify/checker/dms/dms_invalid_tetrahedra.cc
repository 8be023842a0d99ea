// SPDX-License-Identifier: Apache-2.0 OR MIT
// dms_invalid_tetrahedra.cc: W0 to W4 and W10 of docs/certificates/dms-invalid.md.
#include "dms_invalid.h"

int sign_of_d(const DmsPoint* const* w) { return DmsPlane::of(*w[0], *w[1], *w[2]).side(*w[3]); }
bool is_in_tetrahedron(const DmsModel& model, size_t tetrahedron, const DmsPoint& u,
                       bool strictly) {
  const DmsPoint* corner[4];
  for (size_t c = 0; c < 4; ++c) corner[c] = &model.corner(tetrahedron, c);
  std::vector<DmsPlane> planes;
  add_dms_faces(corner, &planes);
  for (const DmsPlane& plane : planes)
    if (plane.side(u) > (strictly ? -1 : 0)) return false;
  return true;
}

namespace {

typedef std::array<const DmsPoint*, 4> DmsFour;

DmsFour corners_of(const DmsModel& model, size_t t) {
  return DmsFour{
      {&model.corner(t, 0), &model.corner(t, 1), &model.corner(t, 2), &model.corner(t, 3)}};
}
// W_gamma. REQUIRES that no number of the index is over n.
DmsFour simplex_of(const DmsModel& model, size_t t, const DmsIndex& g) {
  DmsFour w;
  for (size_t c = 0; c < 4; ++c) w[c] = &model.points[model.knot(t, c, g[c])];
  return w;
}
int sum_of(const DmsIndex& g) { return g[0] + g[1] + g[2] + g[3]; }

void check_overused(const DmsModel& model, const DmsFinding& f) {
  std::array<uint32_t, 3> order[2];
  for (size_t i = 0; i < 2; ++i) {
    const int* const corner = kDmsFace[f.faces[i].number];
    for (size_t c = 0; c < 3; ++c)
      order[i][c] = model.file.tetrahedra[f.faces[i].tetrahedron][size_t(corner[c])];
    std::rotate(order[i].begin(), std::min_element(order[i].begin(), order[i].end()),
                order[i].end());
  }
  require(
      f.faces[0].tetrahedron != f.faces[1].tetrahedron || f.faces[0].number != f.faces[1].number,
      "W1", "the two faces are one");
  require(order[0] == order[1], "W1", "the faces have different cyclic orders");
}
void check_degenerate(const DmsModel& model, const DmsFinding& f) {
  const int sum = sum_of(f.indices[0]);
  require(0 < sum && sum <= model.file.sum(), "W2", "the index does not count");
  require(sign_of_d(simplex_of(model, f.tetrahedra[0], f.indices[0]).data()) <= 0, "W2",
          "d is positive");
}

void check_no_core(const DmsModel& model, const DmsFinding& f) {
  Ratio sum[4];  // an affine function: three factors and a constant
  for (size_t i = 0; i < f.indices.size(); ++i) {
    require(sum_of(f.indices[i]) <= model.file.sum(), "W3", "an index does not count, number", i);
    require(f.numbers[i].n.sign() > 0, "W3", "a factor is not positive, number", i);
    const DmsFour w = simplex_of(model, f.tetrahedra[0], f.indices[i]);
    require(sign_of_d(w.data()) > 0, "W3", "d is not positive, number", i);
    // With u behind the three others in their order d changes its sign 3 - m times.
    const size_t m = f.replaced[i];
    const DmsPoint* others[3];
    Big scale = f.numbers[i].d;
    for (size_t c = 0, k = 0; c < 4; ++c)
      if (c != m) {
        others[k++] = w[c];
        scale = scale * w[c]->x[3];
      }
    const DmsPlane plane = DmsPlane::of(*others[0], *others[1], *others[2]);
    const Big factor = m % 2 == 0 ? -f.numbers[i].n : f.numbers[i].n;
    for (size_t k = 0; k < 4; ++k)
      sum[k] = dms_sum(sum[k], dms_lowest(Ratio(factor * plane.a[k], scale)));
  }
  for (size_t k = 0; k < 3; ++k)
    require(sum[k].n.sign() == 0, "W3", "the sum is not constant along axis", k);
  require(sum[3].n.sign() <= 0, "W3", "the sum is positive");
}

void check_inside(const DmsModel& model, const DmsFinding& f) {
  const size_t at = place_in_boundary(model, f.faces[0]), j = f.tetrahedra[0];
  require(at < model.faces.size(), "W4", "the face is not one of the boundary");
  const DmsIndex& g = f.indices[0];
  require(sum_of(g) == model.file.sum(), "W4", "the index does not count");
  std::vector<const DmsPoint*> knots;
  for (size_t c = 0; c < 3; ++c)
    for (int i = 0; i <= g[c + 1]; ++i)
      knots.push_back(&model.points[model.clouds[model.faces[at].vertex[c]][size_t(i)]]);
  const DmsPoint u = dms_mean(knots, f.numbers.data(), "W4");
  require(sign_of_d(corners_of(model, j).data()) > 0, "W4", "d is not positive, of tetrahedron", j);
  require(is_in_tetrahedron(model, j, u, true), "W4", "the point is not inside of tetrahedron", j);
}
void check_overlap(const DmsModel& model, const DmsFinding& f) {
  require(f.tetrahedra[0] != f.tetrahedra[1], "W10", "the two tetrahedra are one");
  for (size_t t : f.tetrahedra) {
    require(sign_of_d(corners_of(model, t).data()) > 0, "W10", "d is not positive, of tetrahedron",
            t);
    require(is_in_tetrahedron(model, t, f.point(0), true), "W10",
            "the point is not inside of tetrahedron", t);
  }
}

}  // namespace

DmsPoint dms_mean(const std::vector<const DmsPoint*>& points, const Ratio* weights,
                  const char* id) {
  const std::vector<Ratio> all(weights, weights + points.size());
  for (const Ratio& w : all) require(w.n.sign() >= 0, id, "a weight is negative");
  const std::vector<Big> w = dms_integers(all, nullptr);
  Big scale = 1, x[4];
  for (const DmsPoint* p : points)
    scale = scale * divide(p->x[3], dms_gcd(scale, p->x[3]), nullptr);
  for (size_t i = 0; i < points.size(); ++i) {
    const Big factor = w[i] * divide(scale, points[i]->x[3], nullptr);
    for (size_t k = 0; k < 4; ++k) x[k] = x[k] + factor * points[i]->x[k];
  }
  require(x[3].sign() > 0, id, "the sum of the weights is 0");
  return DmsPoint::of(x);
}

void check_dms_tetrahedra(const DmsModel& model, const DmsFinding& f) {
  switch (f.kind) {
    case kTetReversed:
      return require(sign_of_d(corners_of(model, f.tetrahedra[0]).data()) <= 0, "W0",
                     "d is positive, of tetrahedron", f.tetrahedra[0]);
    case kTetFaceOverused: return check_overused(model, f);
    case kCloudDegenerate: return check_degenerate(model, f);
    case kCloudNoCore: return check_no_core(model, f);
    case kCloudInside: return check_inside(model, f);
    default: return check_overlap(model, f);
  }
}
