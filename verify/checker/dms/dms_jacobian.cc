// SPDX-License-Identifier: Apache-2.0 OR MIT
// dms_jacobian.cc: J1 to J3 of docs/certificates/dms-solid.md.
#include "dms_pieces.h"
#include "dms_polynomial.h"

namespace {

const int kDmsEdge[6][2] = {{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}};

typedef std::array<DmsPoint, 4> Corners;
std::vector<const DmsPoint*> pointers(const Corners& c) { return {&c[0], &c[1], &c[2], &c[3]}; }

DmsPoint point_between(const DmsPoint& a, const DmsPoint& b, const Ratio& t) {
  const Big f = (t.d - t.n) * b.x[3], g = t.n * a.x[3];
  Big x[4];
  for (int k = 0; k < 3; ++k) x[k] = f * a.x[k] + g * b.x[k];
  x[3] = t.d * a.x[3] * b.x[3];
  return DmsPoint::of(x);
}

struct DmsJacobian {
  DmsJacobian(const DmsModel& m, const DmsNear& n, Units* u)
      : model(m), near(n), units(u), matrices(m) {}

  const DmsModel& model;
  const DmsNear& near;
  Units* units;
  DmsMatrices matrices;
  std::unique_ptr<DmsPolynomials> polynomials;
  uint64_t leaf_number = 0;

  void check_tree(size_t t, const DmsTree& tree) {
    Corners root;
    for (size_t c = 0; c < 4; ++c) root[c] = model.corner(t, c);
    std::vector<DmsPlane> planes;  // of the faces of the root
    add_dms_faces(pointers(root).data(), &planes);
    std::vector<Corners> open = {root};
    size_t cut = 0, leaf = 0;
    for (uint8_t symbol : tree.symbols) {
      const Corners tau = open.back();
      open.pop_back();
      if (symbol >= 12) {
        check_leaf(tau, planes, tree.leaves[leaf++]);
        continue;
      }
      const Ratio at = symbol < 6 ? Ratio(Big(1), Big(2)) : tree.cuts[cut++];
      const size_t i = size_t(kDmsEdge[symbol % 6][0]), j = size_t(kDmsEdge[symbol % 6][1]);
      const DmsPoint middle = point_between(tau[i], tau[j], at);
      Corners first = tau, second = tau;
      first[j] = middle;
      second[i] = middle;
      open.push_back(second);
      open.push_back(first);
    }
  }
  void check_leaf(const Corners& tau, const std::vector<DmsPlane>& planes, const DmsLeaf& leaf) {
    const std::vector<Big> r = dms_integers(leaf.r, nullptr);
    require(dms_determinant(r).sign() > 0, "J3", "det R is not positive, in leaf", leaf_number);
    const std::vector<const DmsPoint*> corners = pointers(tau);
    DmsSides sides = dms_sides_of_leaf(corners, planes, leaf.planes);
    units->id = leaf.is_polynomial ? "J2" : "J1";
    const std::vector<DmsTerm> terms = near.not_excluded(DmsBox(corners), &sides, units);
    if (leaf.is_polynomial) {
      near.check_cuts(terms, &sides, units, "a cut is in the way, in leaf", leaf_number);
      check_polynomial(corners, r, terms);
    } else {
      for (const DmsTerm& term : terms)
        require(dms_is_positive(r, matrices.of(term)), "J1", "R G is not positive, in leaf",
                leaf_number);
    }
    ++leaf_number;
  }
  void check_polynomial(const std::vector<const DmsPoint*>& corners, const std::vector<Big>& r,
                        const std::vector<DmsTerm>& terms) {
    const int n = model.file.n;
    if (!polynomials) polynomials.reset(new DmsPolynomials(n, 4));
    const std::vector<Ratio> b = polynomials->coefficients(model, corners, nullptr, terms, units);
    for (const DmsIndex& g : model.gammas) {
      const Ratio* image[4];
      for (size_t m = 0; m < 4; ++m) image[m] = &b[3 * dms_place(dms_raised(g, m), n)];
      require(dms_is_positive(r, dms_linear_part(corners.data(), image)), "J2",
              "R J is not positive, in leaf", leaf_number);
    }
  }
};

}  // namespace

void check_dms_jacobian(const DmsModel& model, const DmsBody& body, Units* units) {
  const DmsNear near(model);
  DmsJacobian check(model, near, units);
  for (size_t t = 0; t < body.trees.size(); ++t) check.check_tree(t, body.trees[t]);
}
