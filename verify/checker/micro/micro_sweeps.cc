// SPDX-License-Identifier: Apache-2.0 OR MIT
// micro_sweeps.cc: Q1 and Q2 of docs/certificates/microstructure.md.
#include "micro_sweeps.h"

namespace {

// Limits of this checker, of the work of Q2.
const uint64_t kFreeWork = uint64_t(1) << 34, kWorkOfSweep = 1 << 18;

// A number that differs from v by at most e. Any rounding of what is computed here is far less than 2^-48 of a result's
// size.
struct Near {
  double v, e;
};
Near near_of(const Span& s) { return Near{s.lo + (s.hi - s.lo) / 2, s.hi - s.lo}; }
Near near_of(double v, double e) {
  return Near{v, e + std::ldexp(e, -40) + std::ldexp(std::abs(v), -48) + kTiny};
}
Near operator*(const Near& a, const Near& b) {
  return near_of(a.v * b.v, std::abs(a.v) * b.e + std::abs(b.v) * a.e + a.e * b.e);
}
// A sum's numbers may be greater than it.
Near operator+(const Near& a, const Near& b) {
  return near_of(a.v + b.v, a.e + b.e + std::ldexp(std::abs(a.v) + std::abs(b.v), -48));
}
Near operator-(const Near& a, const Near& b) { return a + Near{-b.v, b.e}; }
bool is_positive(const Near& a) { return a.v > a.e; }
Near quotient(const Near& a, const Near& b) {  // REQUIRES is_positive(b)
  const double least = b.v - b.e, q = a.v / b.v;
  return near_of(q, (a.e + std::abs(q) * b.e) / least * (1 + std::ldexp(1.0, -40)));
}

// Whether the symmetric matrix is positive definite: each pivot is > 0, as the leading minors are then.
bool is_definite(Near (*m)[3]) {
  for (size_t p = 0; p < 3; ++p) {
    if (!is_positive(m[p][p])) return false;
    for (size_t r = p + 1; r < 3; ++r)
      for (size_t c = r; c < 3; ++c) m[r][c] = m[r][c] - quotient(m[p][r] * m[p][c], m[p][p]);
  }
  return true;
}
// Whether K C + (K C)^T is.
bool is_definite(const Near (*k)[3], const Near (*c)[3]) {
  Near product[3][3], sum[3][3];
  for (size_t r = 0; r < 3; ++r)
    for (size_t s = 0; s < 3; ++s)
      product[r][s] = k[r][0] * c[0][s] + k[r][1] * c[1][s] + k[r][2] * c[2][s];
  for (size_t r = 0; r < 3; ++r)
    for (size_t s = 0; s < 3; ++s) sum[r][s] = product[r][s] + product[s][r];
  return is_definite(sum);
}

// Nets of one number a coefficient.
DoubleNet number_of(const DoubleNet& net, size_t k) {
  DoubleNet r;
  r.stride = 1, r.error = net.error;
  std::copy(net.n, net.n + 3, r.n);
  for (size_t i = k; i < net.v.size(); i += net.stride) r.v.push_back(net.v[i]);
  return r;
}
std::vector<double> binomials(size_t count) {  // exact: below 2^53
  std::vector<double> r(1, 1);
  for (size_t k = 1; k < count; ++k) r.push_back(r.back() * double(count - k) / double(k));
  return r;
}
void scale(const size_t* n, bool is_up, std::vector<double>* v) {
  const std::vector<double> a = binomials(n[0]), b = binomials(n[1]), c = binomials(n[2]);
  double* x = v->data();
  for (double p : a)
    for (double q : b)
      for (double r : c) {
        *x = is_up ? *x * (p * q * r) : *x / (p * q * r);
        ++x;
      }
}
// A coefficient of a product is a sum of products of coefficients with weights whose sum is 1. Each of the products has
// a relative error of less than 2^-48, and the sum of m of them one of m 2^-51 of the sizes' product.
DoubleNet product_of(const DoubleNet& a, const DoubleNet& b) {
  DoubleNet r;
  r.stride = 1;
  for (size_t k = 0; k < 3; ++k) r.n[k] = a.n[k] + b.n[k] - 1;
  const double x = a.size(), y = b.size();
  r.error = 2 * (a.error * y + b.error * x + a.error * b.error) +
            std::ldexp(x * y, -46) * (1 + double(b.v.size()) / 16) + kTiny;
  std::vector<double> u = a.v, v = b.v;
  scale(a.n, true, &u), scale(b.n, true, &v);
  r.v.assign(r.n[0] * r.n[1] * r.n[2], 0);
  const double* from = u.data();
  for (size_t i = 0; i < a.n[0]; ++i)
    for (size_t j = 0; j < a.n[1]; ++j)
      for (size_t k = 0; k < a.n[2]; ++k, ++from) {
        const double* other = v.data();
        for (size_t l = 0; l < b.n[0]; ++l)
          for (size_t m = 0; m < b.n[1]; ++m) {
            double* const to = &r.v[((i + l) * r.n[1] + j + m) * r.n[2] + k];
            for (size_t o = 0; o < b.n[2]; ++o) to[o] += *from * *other++;
          }
      }
  scale(r.n, false, &r.v);
  return r;
}
DoubleNet difference(DoubleNet a, const DoubleNet& b) {
  a.error += b.error + std::ldexp(a.size() + b.size(), -49) + kTiny;
  for (size_t i = 0; i < a.v.size(); ++i) a.v[i] -= b.v[i];
  return a;
}
// In a degree that is higher by one along the axis: k/n of a coefficient and 1 - k/n of the next one.
DoubleNet raised(const DoubleNet& a, size_t axis) {
  DoubleNet r = a;
  const size_t n = a.n[axis];
  r.n[axis] = n + 1;
  r.error += std::ldexp(a.size(), -48) + kTiny;
  size_t inner = 1;
  for (size_t k = axis + 1; k < 3; ++k) inner *= a.n[k];
  r.v.clear();
  for (size_t row = 0; row < a.v.size(); row += n * inner)
    for (size_t k = 0; k <= n; ++k)
      for (size_t i = 0; i < inner; ++i) {
        const double t = double(k) / double(n);
        const double before = k > 0 ? a.v[row + (k - 1) * inner + i] : 0;
        r.v.push_back(t * before + (k < n ? (1 - t) * a.v[row + k * inner + i] : 0));
      }
  return r;
}
// By a parameter of which the net's interval has the length 1 / inverse.
DoubleNet derivative_of(const DoubleNet& a, size_t axis, const Near& inverse) {
  DoubleNet r = a;
  const size_t n = a.n[axis] - 1;
  size_t inner = a.stride;
  for (size_t k = axis + 1; k < 3; ++k) inner *= a.n[k];
  r.v.clear();
  r.n[axis] = std::max<size_t>(n, 1);
  if (n == 0) {
    r.v.assign(a.v.size(), 0), r.error = 0;
    return r;
  }
  for (size_t row = 0; row < a.v.size(); row += (n + 1) * inner)
    for (size_t i = row; i < row + n * inner; ++i)
      r.v.push_back(double(n) * inverse.v * (a.v[i + inner] - a.v[i]));
  const double size = a.size(), f = std::abs(inverse.v) + inverse.e;
  r.error =
      double(n) * (3 * f * a.error + inverse.e * 3 * size + std::ldexp(f * size, -45)) + kTiny;
  return r;
}
// The net where the axis has a value: one coefficient along it. REQUIRES a net on an interval that holds the value.
void flatten(DoubleNet* net, size_t axis) {
  size_t inner = net->stride;
  for (size_t k = axis + 1; k < 3; ++k) inner *= net->n[k];
  const size_t n = net->n[axis];
  double most = 0;  // what a coefficient differs from the first one
  std::vector<double> v;
  for (size_t row = 0; row < net->v.size(); row += n * inner)
    for (size_t i = row; i < row + n * inner; ++i) {
      if (i < row + inner) v.push_back(net->v[i]);
      most = std::max(most, std::abs(net->v[i] - net->v[row + (i - row) % inner]));
    }
  net->v.swap(v);
  net->n[axis] = 1;
  net->error += most * (1 + std::ldexp(1.0, -40)) + kTiny;
}

// D on a box of the cell's parameters, and W^2: one net for each row and column.
struct Growth {
  DoubleNet d[3][3], square;
  bool is_rational;
};
// The map's homogeneous coordinates and their derivatives by the three parameters, on one box.
struct Jet {
  DoubleNet map, by[3];
};
Growth growth_of(const Jet& jet) {
  Growth r;
  r.is_rational = jet.map.stride == 4;
  for (size_t axis = 0; axis < 3; ++axis)
    for (size_t k = 0; k < 3; ++k) {
      DoubleNet& d = r.d[k][axis];
      d = number_of(jet.by[axis], k);
      if (r.is_rational)
        d = difference(product_of(number_of(jet.map, 3), d),
                       product_of(number_of(jet.by[axis], 3), number_of(jet.map, k)));
      const size_t most = r.is_rational ? 2 * jet.map.n[axis] - 1 : jet.map.n[axis];
      if (d.n[axis] < most) d = raised(d, axis);
    }
  if (r.is_rational) {
    const DoubleNet w = number_of(jet.map, 3);
    r.square = product_of(w, w);
  }
  return r;
}

class GrowthCheck {
 public:
  GrowthCheck(TileParts* parts, const MicroSweep& sweep, uint64_t number)
      : sweep_(sweep), number_(number), axis_(sweep.wall / 2) {
    for (size_t i = 0; i < 9; ++i) k_[i / 3][i % 3] = near_of(sweep.matrix[i]);
    const MicroGrid& g = parts->file().grids[sweep.grid];
    size_t i[3], box[3];
    g.place_of(sweep.cell, i);
    parts->box_of_cell(g, i, box);
    jet_.map = parts->maps().net(g.volume, box);
    for (size_t a = 0; a < 3; ++a) {
      const std::vector<Ratio>& t = parts->maps().knots(g.volume, a);
      const Ratio length = t[box[a] + 1] - t[box[a]];
      jet_.by[a] = derivative_of(jet_.map, a, near_of(span_of(length.d, length.n)));
      cell_[a][0] = parts->break_in(g, box, a, i[a]);
      cell_[a][1] = parts->break_in(g, box, a, i[a] + 1);
    }
  }
  // Products of coefficients on the slab: those on the wall are fewer.
  uint64_t work() const {
    const uint64_t count = jet_.map.v.size() / jet_.map.stride;
    return jet_.map.stride == 4 ? 18 * count * count : 27 * count;
  }
  void check_slab() const {
    const Span &begin = cell_[axis_][0], &end = cell_[axis_][1];
    const double more = std::ldexp(1.0, -46);  // the ends are at most 1
    const double depth = sweep_.depth.hi * (end.hi - begin.lo) + more;
    Span slab = {begin.lo - more, end.hi + more};
    if (sweep_.depth.hi < 1 && sweep_.wall % 2 == 0) slab.hi = begin.hi + depth;
    if (sweep_.depth.hi < 1 && sweep_.wall % 2 == 1) slab.lo = end.lo - depth;
    const Growth growth = growth_of(restricted(slab, false));
    const size_t count = growth.d[0][0].v.size();
    for (size_t at = 0; at < count; ++at) {
      Near c[3][3];
      set_matrix(growth, at, c);
      require(is_definite(k_, c), "Q2", "K C is not positive on the slab, of sweep", number_);
    }
  }
  void check_axis() const {
    const Growth growth = growth_of(restricted(cell_[axis_][sweep_.wall % 2], true));
    Near at_begin[3], at_end[3];  // l s g
    const Near speed = near_of(sweep_.speed);
    for (size_t k = 0; k < 3; ++k) {
      at_begin[k] = near_of(sweep_.axis[0][k]) * speed;
      at_end[k] = (near_of(sweep_.axis[1][k]) - near_of(sweep_.axis[0][k])) * speed;
      if (sweep_.wall % 2 == 0) at_begin[k].v = -at_begin[k].v, at_end[k].v = -at_end[k].v;
    }
    const size_t count = growth.d[0][(axis_ + 1) % 3].v.size();
    for (size_t at = 0; at < count; ++at)
      for (const Near* g : {at_begin, at_end}) {
        Near c[3][3];
        set_matrix(growth, at, c);
        const Near weight =
            growth.is_rational ? Near{growth.square.v[at], growth.square.error} : Near{1, 0};
        for (size_t k = 0; k < 3; ++k) c[k][axis_] = weight * g[k];
        require(is_definite(k_, c), "Q2", "K C is not positive beyond the wall, of sweep", number_);
      }
  }

 private:
  // On the cell, but along the axis; if is_flat, at a value there.
  Jet restricted(const Span& along, bool is_flat) const {
    Jet r = jet_;
    for (DoubleNet* net : {&r.map, &r.by[0], &r.by[1], &r.by[2]})
      for (size_t a = 0; a < 3; ++a) {
        const double lo = a == axis_ ? along.lo : cell_[a][0].lo,
                     hi = a == axis_ ? along.hi : cell_[a][1].hi;
        restrict_net(net, a, std::min(1.0, std::max(0.0, lo)), std::max(0.0, std::min(1.0, hi)));
        if (is_flat && a == axis_) flatten(net, a);
      }
    return r;
  }
  static void set_matrix(const Growth& growth, size_t at, Near (*c)[3]) {
    for (size_t r = 0; r < 3; ++r)
      for (size_t s = 0; s < 3; ++s) {
        const DoubleNet& d = growth.d[r][s];
        c[r][s] = Near{d.v[at], d.error};
      }
  }

  const MicroSweep& sweep_;
  const uint64_t number_;
  const size_t axis_;
  Near k_[3][3];
  Jet jet_;
  Span cell_[3][2];  // where the box of knots is [0, 1]
};

}  // namespace

void check_growth(TileParts* parts, const MicroSweep& sweep, uint64_t number, uint64_t* work) {
  const GrowthCheck check(parts, sweep, number);
  *work += check.work();
  require(*work <= kFreeWork + kWorkOfSweep * parts->file().sweeps.size(), "Q2",
          "this checker has a limit of products of coefficients:", *work);
  check.check_slab();
  check.check_axis();
}

void check_sweeps(const MicroFile& file, const std::vector<bool>& is_meeting) {
  if (file.sweeps.empty()) return;
  VolumeMaps maps(file.cage);
  TileParts parts(file, &maps);
  SweepPairs pairs(&parts);
  uint64_t work = 0;
  for (size_t i = 0; i < file.sweeps.size(); ++i) {
    const MicroSweep& b = file.sweeps[i];
    patch_of_cap(file, b.grid, b.cell, b.wall, "Q1", i);
    require(!is_meeting[i], "Q1", "the cap is equal to another one, of sweep", i);
    check_growth(&parts, b, i, &work);
    pairs.check_tiles(b, i);
  }
  pairs.check_sweeps();
}
