// SPDX-License-Identifier: Apache-2.0 OR MIT
#include "dms_polynomial.h"

// The terms on one simplex.
struct DmsSum {
  // A homogeneous polynomial in barycentric coordinates, each over the denominator W of its corner: the factors of the
  // monomials over one denominator. Without factors it is 0.
  struct Form {
    std::vector<Big> n;
    Big d = 1;
  };
  typedef std::vector<Big> Linear;

  DmsSum(const DmsPolynomials& p, const DmsModel& m, const std::vector<const DmsPoint*>& of,
         const DmsPoint& middle, const DmsPoint* inside)
      : all(p), model(m), corners(of), place(m, middle, inside) {}

  // Adds the numbers over another one.
  static void add(const std::vector<Big>& n, const Big& d, Form* sum) {
    if (sum->n.empty()) {
      sum->n = n;
      sum->d = d;
      return;
    }
    Big here = 1;
    if (!(sum->d == d)) {
      const Big g = dms_gcd(sum->d, d), up = divide(d, g, nullptr);
      here = divide(sum->d, g, nullptr);
      for (Big& x : sum->n) x = x * up;
      sum->d = sum->d * up;
    }
    for (size_t i = 0; i < n.size(); ++i) sum->n[i] = sum->n[i] + n[i] * here;
  }
  // The values at the corners, times their W and the denominators of the other points of w, of d of the points w with u
  // in the place of the m-th.
  Linear replaced(const uint32_t* w, size_t m) {
    bool is_odd = false;
    const DmsPlane& plane = place.opposite(w, m, &is_odd).plane;
    Linear r;
    for (const DmsPoint* p : corners) {
      Big v = plane.value(*p);
      if (is_odd) v.neg = !v.neg && v.sign() != 0;
      r.push_back(v);
    }
    return r;
  }
  std::vector<Big> product(const std::vector<Big>& f, size_t degree, const Linear& by) const {
    std::vector<Big> r(all.indices[degree + 1].size());
    for (size_t i = 0; i < f.size(); ++i) {
      if (f[i].sign() == 0) continue;
      for (size_t c = 0; c < by.size(); ++c) {
        Big& sum = r[all.products[degree][i * by.size() + c]];
        sum = sum + f[i] * by[c];
      }
    }
    return r;
  }
  const Form& spline(const std::vector<uint32_t>& v) {
    const auto found = splines.find(v);
    if (found != splines.end()) return found->second;
    Form r = computed(v);
    return splines[v] = std::move(r);
  }
  Form computed(const std::vector<uint32_t>& v) {
    Form sum;
    if (v.size() == 4) {
      const Ratio r = place.constant(v.data());
      if (r.n.sign() != 0) add({r.n}, r.d, &sum);
      return sum;
    }
    uint32_t w[4];
    if (!place.find_simplex(v, w)) return sum;
    for (size_t m = 0; m < 4; ++m) {
      std::vector<uint32_t> rest = v;
      rest.erase(std::find(rest.begin(), rest.end(), w[m]));
      const Form& below = spline(rest);
      if (below.n.empty()) continue;
      Linear by = replaced(w, m);
      for (Big& x : by) x = x * model.points[w[m]].x[3];
      add(product(below.n, v.size() - 5, by), below.d, &sum);
    }
    const Big d = place.determinant(w);
    if (sum.n.empty()) return sum;
    if (d.neg)
      for (Big& x : sum.n) x = -x;
    sum.d = sum.d * (d.neg ? -d : d);
    return sum;
  }
  void add_term(const DmsTerm& term, Form* sums) {
    std::vector<uint32_t> v;
    uint32_t w[4];
    for (size_t c = 0; c < 4; ++c) {
      for (int i = 0; i <= term.gamma[c]; ++i) v.push_back(model.knot(term.tetrahedron, c, i));
      w[c] = v.back();
    }
    std::sort(v.begin(), v.end());
    const Form& m = spline(v);
    if (m.n.empty()) return;
    Big weights = 1;  // the denominators
    for (uint32_t k : w) weights = weights * model.points[k].x[3];
    Linear at[4];
    std::vector<Ratio> values[3];
    for (size_t c = 0; c < 4; ++c) {
      at[c] = replaced(w, c);
      for (Big& x : at[c]) x = x * model.points[w[c]].x[3];
      const Ratio* const value = model.file.value(term.tetrahedron, dms_raised(term.gamma, c));
      for (size_t k = 0; k < 3; ++k) values[k].push_back(value[k]);
    }
    for (size_t k = 0; k < 3; ++k) {
      Big common;
      const std::vector<Big> value = dms_integers(values[k], &common);
      Linear by(corners.size());
      for (size_t c = 0; c < 4; ++c)
        for (size_t i = 0; i < by.size(); ++i) by[i] = by[i] + at[c][i] * value[c];
      add(product(m.n, v.size() - 4, by), m.d * weights * common, &sums[k]);
    }
  }

  const DmsPolynomials& all;
  const DmsModel& model;
  const std::vector<const DmsPoint*>& corners;
  DmsPlace place;
  std::map<std::vector<uint32_t>, Form> splines;
};

DmsPolynomials::DmsPolynomials(int degree, size_t of) : n(degree), corners(of) {
  for (int d = 0; d <= n; ++d) {
    indices.emplace_back();
    for (const DmsIndex& i : dms_indices(d))
      if (corners == 4 || i[3] == 0) indices.back().push_back(i);
  }
  for (size_t d = 0; d < size_t(n); ++d) {
    products.emplace_back();
    const std::vector<DmsIndex>& next = indices[d + 1];
    for (const DmsIndex& i : indices[d])
      for (size_t c = 0; c < corners; ++c)
        products.back().push_back(
            size_t(std::find(next.begin(), next.end(), dms_raised(i, c)) - next.begin()));
  }
}
std::vector<Ratio> DmsPolynomials::coefficients(const DmsModel& model,
                                                const std::vector<const DmsPoint*>& corner,
                                                const DmsPoint* inside,
                                                const std::vector<DmsTerm>& terms,
                                                Units* units) const {
  const DmsPoint middle = DmsInterpolation(0, corners).point(DmsIndex{{0, 0, 0, 0}}, corner.data());
  DmsSum sum(*this, model, corner, middle, inside);
  DmsSum::Form sums[3];
  for (const DmsTerm& term : terms) {
    units->add(indices.back().size());
    sum.add_term(term, sums);
  }
  std::vector<Ratio> r(3 * indices.back().size());
  for (size_t i = 0; i < indices.back().size(); ++i) {
    // How often the monomial occurs in a power of the sum of the coordinates, and the corners' W.
    Big factor = 1;
    int left = 0;
    for (size_t c = 0; c < corners; ++c)
      for (int e = 1; e <= indices.back()[i][c]; ++e)
        factor = divide(factor * Big(++left), Big(e), nullptr);
    for (size_t c = 0; c < corners; ++c)
      for (int e = 0; e < indices.back()[i][c]; ++e) factor = factor * corner[c]->x[3];
    for (size_t k = 0; k < 3; ++k)
      if (!sums[k].n.empty()) r[3 * i + k] = dms_lowest(Ratio(sums[k].n[i], sums[k].d * factor));
  }
  return r;
}
