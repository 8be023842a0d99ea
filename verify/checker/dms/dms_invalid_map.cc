// SPDX-License-Identifier: Apache-2.0 OR MIT
// dms_invalid_map.cc: W5, W6, W11 and W13 of docs/certificates/dms-invalid.md.
#include "dms_invalid.h"
#include "dms_pieces.h"
#include "dms_rule_h.h"

namespace {

void require_in_domain(const DmsRuleH& rule, const DmsPoint& u, const char* id) {
  DmsPoint inside;
  require(rule.find_path(u, &inside), id, "a point lies in no tetrahedron");
}

void check_negative(const DmsFinding& f, const DmsRuleH& rule) {
  const DmsPoint u = f.point(0);
  require_in_domain(rule, u, "W5");
  const std::vector<Ratio> ds = rule.derivative(u, rule.terms(u));
  require(dms_determinant(dms_integers(ds, nullptr)).sign() < 0, "W5",
          "the determinant is not negative");
}
void check_meeting(const DmsFinding& f, const DmsRuleH& rule) {
  const DmsPoint u = f.point(0), v = f.point(1);
  require(!dms_equal(u, v), "W11", "the two points are one");
  require_in_domain(rule, u, "W11");
  require_in_domain(rule, v, "W11");
  const std::vector<Ratio> a = rule.value(u, rule.terms(u)), b = rule.value(v, rule.terms(v));
  for (size_t k = 0; k < 3; ++k)
    require(compare(a[k], b[k]) == 0, "W11", "the images differ along axis", k);
}

// The Bernstein polynomial of this index at the point (i + 1, ...) / (sum of i + 4), times a factor that depends only
// on the two sums. Sums of gamma are at most 5, those of i at most 15: the result is below 120 16^5.
int64_t weight_at(const DmsIndex& gamma, const DmsIndex& i) {
  int64_t r = 1;
  for (int k = 2; k <= gamma[0] + gamma[1] + gamma[2] + gamma[3]; ++k) r *= k;
  for (size_t c = 0; c < 4; ++c)
    for (int k = 2; k <= gamma[c]; ++k) r /= k;
  for (size_t c = 0; c < 4; ++c)
    for (int k = 0; k < gamma[c]; ++k) r *= i[c] + 1;
  return r;
}
// b: Bernstein coefficients of s on a tetrahedron, three coordinates each, times a common factor. Ds takes its edges
// from corner 0 to sums of differences of them, up to a factor; so the determinant of these is that of Ds, up to one.
void check_flat(const DmsModel& model, const std::vector<Big>& b) {
  const int n = model.file.n;
  std::vector<std::vector<Big>> columns;  // of each gamma: the images of the edges
  for (const DmsIndex& g : model.gammas) {
    std::vector<Big> e;
    for (size_t m = 1; m < 4; ++m)
      for (size_t k = 0; k < 3; ++k)
        e.push_back(b[3 * dms_place(dms_raised(g, m), n) + k] -
                    b[3 * dms_place(dms_raised(g, 0), n) + k]);
    columns.push_back(std::move(e));
  }
  for (const DmsIndex& i : dms_indices(3 * (n - 1))) {
    std::vector<Big> sum(9);
    for (size_t g = 0; g < columns.size(); ++g) {
      const Big weight = weight_at(model.gammas[g], i);
      for (size_t k = 0; k < 9; ++k) sum[k] = sum[k] + weight * columns[g][k];
    }
    require(dms_determinant(sum).sign() == 0, "W6", "the determinant is not 0");
  }
}

// A tetrahedron in the first one of a finding, where s is to be one polynomial; by the name units->id.
struct DmsPart {
  DmsPart(const DmsModel& m, const DmsFinding& f, const DmsRuleH& rule, Units* units);

  std::vector<Ratio> coefficients(Units* units) const;  // of s, three coordinates each

  const DmsModel& model;
  const DmsPoint tau[4];
  const std::vector<const DmsPoint*> corners;

 private:
  std::vector<DmsTerm> terms;
};
DmsPart::DmsPart(const DmsModel& m, const DmsFinding& f, const DmsRuleH& rule, Units* units)
    : model(m),
      tau{f.point(0), f.point(1), f.point(2), f.point(3)},
      corners{&tau[0], &tau[1], &tau[2], &tau[3]} {
  const size_t root = f.tetrahedra[0];
  require(sign_of_d(corners.data()) > 0, units->id, "d is not positive");
  for (const DmsPoint* p : corners)
    require(is_in_tetrahedron(model, root, *p, false), units->id, "a corner leaves tetrahedron",
            root);
  const DmsPoint* of_root[4];
  for (size_t c = 0; c < 4; ++c) of_root[c] = &model.corner(root, c);
  std::vector<DmsPlane> planes;
  add_dms_faces(of_root, &planes);
  DmsSides sides = dms_sides_of_leaf(corners, planes, f.planes[0]);
  terms = rule.near.not_excluded(DmsBox(corners), &sides, units);
  rule.near.check_cuts(terms, &sides, units, "a cut is in the way, in tetrahedron", root);
}
std::vector<Ratio> DmsPart::coefficients(Units* units) const {
  const DmsInterpolation interpolation(model.file.n, 4);
  return interpolation.coefficients(corners.data(), [&](const DmsPoint& u) {
    return DmsPlace(model, u, nullptr).value(terms, units);
  });
}

// e_m(y) of points with integer coordinates; m = 4 for e itself.
Big volume_with(const std::vector<const Big*>& p, size_t m, const Big* y) {
  const auto at = [&](size_t i) { return i == m ? y : p[i]; };
  std::vector<Big> edges;
  for (size_t i = 1; i < 4; ++i)
    for (size_t k = 0; k < 3; ++k) edges.push_back(at(i)[k] - at(0)[k]);
  return dms_determinant(edges);
}
void check_covering(const DmsModel& model, const DmsFinding& f, const DmsRuleH& rule,
                    Units* units) {
  const DmsPart part(model, f, rule, units);
  const DmsPoint u = f.point(4);
  require_in_domain(rule, u, "W13");
  bool is_outside = false;
  for (size_t m = 0; m < 4; ++m) {
    std::vector<const DmsPoint*> with_u = part.corners;
    with_u[m] = &u;
    is_outside = is_outside || sign_of_d(with_u.data()) < 0;
  }
  require(is_outside, "W13", "the point lies in the small tetrahedron");

  std::vector<Ratio> all = part.coefficients(units);
  for (const Ratio& x : rule.value(u, rule.terms(u))) all.push_back(x);
  const std::vector<Big> b = dms_integers(all, nullptr);
  const int n = model.file.n;
  const Big* const x = &b[b.size() - 3];
  std::vector<const Big*> corner;
  for (size_t m = 0; m < 4; ++m) {
    DmsIndex at = {{0, 0, 0, 0}};
    at[m] = n;
    corner.push_back(&b[3 * dms_place(at, n)]);
  }
  const int sign = volume_with(corner, 4, nullptr).sign();
  require(sign != 0, "W13", "the corners have images in one plane");
  for (size_t m = 0; m < 4; ++m) {
    const Big of_x = volume_with(corner, m, x);
    for (const DmsIndex& beta : dms_indices(n))
      require(beta[m] != 0 ||
                  (of_x - volume_with(corner, m, &b[3 * dms_place(beta, n)])).sign() == sign,
              "W13", "a coefficient is not beyond the image of the point, of face", m);
  }
}

}  // namespace

void check_dms_map(const DmsModel& model, const DmsFinding& f, Units* units) {
  units->id = f.kind == kNegativeJacobian ? "W5"
              : f.kind == kZeroJacobian   ? "W6"
              : f.kind == kImagesMeet     ? "W11"
                                          : "W13";
  const DmsRuleH rule(model, units);
  if (f.kind == kNegativeJacobian) return check_negative(f, rule);
  if (f.kind == kImagesMeet) return check_meeting(f, rule);
  if (f.kind == kImageCovers) return check_covering(model, f, rule, units);
  check_flat(model, dms_integers(DmsPart(model, f, rule, units).coefficients(units), nullptr));
}
