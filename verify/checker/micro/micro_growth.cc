// SPDX-License-Identifier: Apache-2.0 OR MIT
#include "micro_growth.h"

namespace {

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
// a relative error of less than 2^-47, and the sum of m of them one of m 2^-51 of the sizes' product.
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

}  // namespace

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
