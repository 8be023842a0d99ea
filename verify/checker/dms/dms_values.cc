// SPDX-License-Identifier: Apache-2.0 OR MIT
#include "dms_values.h"

DmsPlace::DmsPlace(const DmsModel& m, const DmsPoint& at, const DmsPoint* g)
    : model(m), u(at), inside(g) {}

const DmsPlace::Beside& DmsPlace::beside(const Triple& t) {
  const auto found = planes.find(t);
  if (found != planes.end()) return found->second;
  Beside& r = planes[t];
  r.plane = DmsPlane::of(model.points[t[0]], model.points[t[1]], model.points[t[2]]);
  r.at_u = r.plane.value(u);
  r.side = r.at_u.sign();
  if (r.side == 0 && inside != nullptr) r.side = r.plane.side(*inside);
  for (int k = 0; k < 3 && r.side == 0; ++k) r.side = r.plane.a[k].sign();
  return r;
}
const DmsPlace::Beside& DmsPlace::opposite(const uint32_t* w, size_t m, bool* is_odd) {
  // The three others in their order are followed by u: 3 - m exchanges, and those that sort the three.
  Triple t;
  for (size_t i = 0, k = 0; i < 4; ++i)
    if (i != m) t[k++] = w[i];
  *is_odd = m % 2 == 0;
  for (size_t i = 0; i < 3; ++i)
    for (size_t j = 0; j + 1 < 3; ++j)
      if (t[j] > t[j + 1]) {
        std::swap(t[j], t[j + 1]);
        *is_odd = !*is_odd;
      }
  return beside(t);
}
Big DmsPlace::replaced(const uint32_t* w, size_t m, int* side) {
  bool is_odd = false;
  const Beside& b = opposite(w, m, &is_odd);
  if (side != nullptr) *side = is_odd ? -b.side : b.side;
  return is_odd ? -b.at_u : b.at_u;
}
Big DmsPlace::determinant(const uint32_t* w) {  // REQUIRES that w ascends
  return beside(Triple{{w[0], w[1], w[2]}}).plane.value(model.points[w[3]]);
}

Ratio DmsPlace::constant(const uint32_t* v) {
  Big d = determinant(v);
  if (d.sign() == 0) return Ratio();
  for (size_t m = 0; m < 4; ++m) {
    int side = 0;
    replaced(v, m, &side);
    if (side != d.sign()) return Ratio();
  }
  d.neg = false;
  Big n = 1;
  for (size_t m = 0; m < 4; ++m) n = n * model.points[v[m]].x[3];
  return dms_lowest(Ratio(n, d));
}
bool DmsPlace::find_simplex(const std::vector<uint32_t>& v, uint32_t* w) {
  std::vector<uint32_t> different = v;
  different.erase(std::unique(different.begin(), different.end()), different.end());
  const size_t n = different.size();
  for (size_t a = 0; a < n; ++a)
    for (size_t b = a + 1; b < n; ++b)
      for (size_t c = b + 1; c < n; ++c)
        for (size_t e = c + 1; e < n; ++e) {
          const uint32_t four[4] = {different[a], different[b], different[c], different[e]};
          std::copy(four, four + 4, w);
          if (determinant(w).sign() != 0) return true;
        }
  return false;
}
Ratio DmsPlace::computed(const std::vector<uint32_t>& v) {
  if (v.size() == 4) return constant(v.data());
  uint32_t w[4];
  if (!find_simplex(v, w)) return Ratio();
  const Big d = determinant(w);
  Ratio sum;
  for (size_t m = 0; m < 4; ++m) {
    Big n = replaced(w, m, nullptr);
    if (n.sign() == 0) continue;
    std::vector<uint32_t> rest = v;
    rest.erase(std::find(rest.begin(), rest.end(), w[m]));
    const Ratio& below = spline(rest);
    if (below.n.sign() == 0) continue;
    n = n * model.points[w[m]].x[3];
    sum = dms_sum(sum, Ratio(n * below.n, below.d));
  }
  if (sum.n.sign() == 0) return sum;
  Ratio r(sum.n, sum.d * d * u.x[3]);
  if (r.d.neg) r = Ratio(-r.n, -r.d);
  return dms_lowest(r);
}
const Ratio& DmsPlace::spline(const std::vector<uint32_t>& v) {
  const auto found = splines.find(v);
  if (found != splines.end()) return found->second;
  Ratio r = computed(v);
  return splines[v] = std::move(r);
}

const Ratio& DmsPlace::spline(const DmsTerm& term, uint32_t* w, Units* units) {
  std::vector<uint32_t> v;
  for (size_t c = 0; c < 4; ++c) {
    for (int i = 0; i <= term.gamma[c]; ++i) v.push_back(model.knot(term.tetrahedron, c, i));
    w[c] = v.back();
  }
  std::sort(v.begin(), v.end());
  units->add(1);
  return spline(v);
}
std::vector<Ratio> DmsPlace::derivative(const std::vector<DmsTerm>& terms, Units* units) {
  std::vector<Ratio> sum(9);
  for (const DmsTerm& term : terms) {
    uint32_t w[4];
    const Ratio& m = spline(term, w, units);
    if (m.n.sign() == 0) continue;
    Big all = 1;  // the denominators
    for (uint32_t k : w) all = all * model.points[k].x[3];
    Ratio part[9];
    for (size_t c = 0; c < 4; ++c) {
      bool is_odd = false;
      const DmsPlane& plane = opposite(w, c, &is_odd).plane;
      const Ratio* const value = model.file.value(term.tetrahedron, dms_raised(term.gamma, c));
      for (size_t k = 0; k < 3; ++k) {
        const Big n = plane.a[k] * model.points[w[c]].x[3];
        for (size_t row = 0; row < 3; ++row)
          part[3 * row + k] =
              dms_sum(part[3 * row + k], Ratio((is_odd ? -n : n) * value[row].n, value[row].d));
      }
    }
    for (size_t i = 0; i < 9; ++i)
      sum[i] = dms_sum(sum[i], dms_lowest(Ratio(part[i].n * m.n, part[i].d * m.d * all)));
  }
  return sum;
}
std::vector<Ratio> DmsPlace::value(const std::vector<DmsTerm>& terms, Units* units) {
  std::vector<Ratio> sum(3);
  for (const DmsTerm& term : terms) {
    uint32_t w[4];
    const Ratio& m = spline(term, w, units);
    if (m.n.sign() == 0) continue;
    Big all = u.x[3];  // the denominators
    for (uint32_t k : w) all = all * model.points[k].x[3];
    Ratio part[3];
    for (size_t c = 0; c < 4; ++c) {
      const Big n = replaced(w, c, nullptr) * model.points[w[c]].x[3];
      if (n.sign() == 0) continue;
      const Ratio* const value = model.file.value(term.tetrahedron, dms_raised(term.gamma, c));
      for (size_t k = 0; k < 3; ++k) part[k] = dms_sum(part[k], Ratio(n * value[k].n, value[k].d));
    }
    for (size_t k = 0; k < 3; ++k)
      sum[k] = dms_sum(sum[k], dms_lowest(Ratio(part[k].n * m.n, part[k].d * m.d * all)));
  }
  return sum;
}

DmsPoint dms_middle(const DmsModel& model, size_t tetrahedron) {
  const DmsPoint* corner[4];
  for (size_t c = 0; c < 4; ++c) corner[c] = &model.corner(tetrahedron, c);
  return DmsInterpolation(0, 4).point(DmsIndex{{0, 0, 0, 0}}, corner);
}

DmsInterpolation::DmsInterpolation(int degree, size_t of) : n(degree), corners(of) {
  for (const DmsIndex& i : dms_indices(n))
    if (corners == 4 || i[3] == 0) indices.push_back(i);
  // Bernstein polynomials at the points, times (n + corners)^n; then Gauss and Jordan, with the unit matrix beside it.
  const size_t size = indices.size(), row = 2 * size;
  std::vector<Ratio> a(size * row);
  for (size_t r = 0; r < size; ++r) {
    for (size_t c = 0; c < size; ++c) {
      Big v = 1;
      int left = n;
      for (size_t k = 0; k < 4; ++k)
        for (int i = 1; i <= indices[c][k]; ++i, --left) {
          v = v * Big(indices[r][k] + 1) *
              Big(left);  // the multinomial coefficient is exact at the end
          v = divide(v, Big(1), nullptr);
        }
      for (size_t k = 0; k < 4; ++k)
        for (int i = 2; i <= indices[c][k]; ++i) v = divide(v, Big(i), nullptr);
      a[r * row + c] = Ratio(v);
    }
    Big scale = 1;
    for (int i = 0; i < n; ++i) scale = scale * Big(n + int(corners));
    a[r * row + size + r] = Ratio(scale);
  }
  for (size_t c = 0; c < size; ++c) {
    size_t pivot = c;
    while (a[pivot * row + c].n.sign() == 0) ++pivot;  // the points are unisolvent: there is one
    for (size_t k = 0; k < row && pivot != c; ++k) std::swap(a[c * row + k], a[pivot * row + k]);
    Ratio by(a[c * row + c].d, a[c * row + c].n);
    if (by.d.neg) by = Ratio(-by.n, -by.d);
    for (size_t k = c; k < row; ++k) a[c * row + k] = dms_product(a[c * row + k], by);
    for (size_t r = 0; r < size; ++r) {
      const Ratio f(-a[r * row + c].n, a[r * row + c].d);
      if (r == c || f.n.sign() == 0) continue;
      for (size_t k = c; k < row; ++k)
        if (a[c * row + k].n.sign() != 0)
          a[r * row + k] = dms_sum(a[r * row + k], dms_product(f, a[c * row + k]));
    }
  }
  for (size_t r = 0; r < size; ++r)
    inverse.insert(inverse.end(), a.begin() + int64_t(r * row + size),
                   a.begin() + int64_t((r + 1) * row));
}
DmsPoint DmsInterpolation::point(const DmsIndex& index, const DmsPoint* const* corner) const {
  Big all = 1, x[4];
  for (size_t c = 0; c < corners; ++c) all = all * corner[c]->x[3];
  for (size_t c = 0; c < corners; ++c) {
    const Big f = divide(all, corner[c]->x[3], nullptr) * Big(index[c] + 1);
    for (int k = 0; k < 3; ++k) x[k] = x[k] + f * corner[c]->x[k];
  }
  x[3] = all * Big(n + int(corners));
  return DmsPoint::of(x);
}
std::vector<Ratio> DmsInterpolation::coefficients(
    const DmsPoint* const* corner,
    const std::function<std::vector<Ratio>(const DmsPoint&)>& value) const {
  const size_t size = indices.size();
  std::vector<Ratio> values;
  for (const DmsIndex& i : indices) {
    const std::vector<Ratio> v = value(point(i, corner));
    values.insert(values.end(), v.begin(), v.end());
  }
  std::vector<Ratio> r(3 * size);
  for (size_t k = 0; k < 3; ++k) {
    std::vector<Ratio> column;
    for (size_t i = 0; i < size; ++i) column.push_back(values[3 * i + k]);
    Big factor;
    const std::vector<Big> v = dms_integers(column, &factor);
    for (size_t i = 0; i < size; ++i) {
      const std::vector<Ratio> line(inverse.begin() + int64_t(i * size),
                                    inverse.begin() + int64_t((i + 1) * size));
      Big common, sum;
      const std::vector<Big> f = dms_integers(line, &common);
      for (size_t j = 0; j < size; ++j) sum = sum + f[j] * v[j];
      r[3 * i + k] = dms_lowest(Ratio(sum, factor * common));
    }
  }
  return r;
}
