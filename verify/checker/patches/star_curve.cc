// SPDX-License-Identifier: Apache-2.0 OR MIT
#include "star_curve.h"

namespace {

// Lowers the degree by one, if the curve permits it.
bool reduce(Curve* c) {
  const size_t n = c->size() / 4 - 1;
  if (n == 0) return false;
  Big binomial = 1, factorial = 1;
  Curve top(4);  // the n-th difference, up to sign
  for (size_t i = 0; i <= n; ++i) {
    for (size_t j = 0; j < 4; ++j) top[j] = top[j] + binomial * (*c)[4 * i + j];
    if (i < n && i > 0) factorial = factorial * Big(int64_t(i));
    binomial = -divide(binomial * Big(int64_t(n - i)), Big(int64_t(i + 1)), nullptr);
  }
  for (const Big& x : top)
    if (x.sign() != 0) return false;
  // c_i = (i r_(i-1) + (n - i) r_i) / n; (n - 1)! r_i are integers if the c_i are, as the
  // denominators n - i, n - i + 1, ... divide it.
  Curve r;
  for (size_t i = 0; i < n; ++i)
    for (size_t j = 0; j < 4; ++j) {
      Big x = Big(int64_t(n)) * (*c)[4 * i + j] * factorial;
      if (i > 0) x = x - Big(int64_t(i)) * r[4 * i - 4 + j];
      r.push_back(divide(x, Big(int64_t(n - i)), nullptr));
    }
  *c = r;
  return true;
}

}  // namespace

Curve side_curve(const Patch& p, int e, bool reversed) {
  const int n = p.shape.side_degree(e);
  Curve c;
  c.reserve(4 * size_t(n + 1));
  for (int k = 0; k <= n; ++k) {
    const int at = p.shape.on_side(e, reversed ? n - k : k);
    c.insert(c.end(), p.net.begin() + 4 * at, p.net.begin() + 4 * at + 4);
  }
  return c;
}
bool is_point(const Curve& c) {
  for (size_t i = 4; i < c.size(); ++i)
    if (!(c[i] * c[3] == c[i % 4] * c[i - i % 4 + 3])) return false;
  return true;
}

std::string text(const Curve& c, bool reversed) {
  std::string s;
  s.reserve(13 * c.size());
  for (size_t i = 0; i < c.size(); ++i) {
    const Big& x = c[reversed ? c.size() - 4 - (i - i % 4) + i % 4 : i];
    s += char(1 + x.sign());
    for (int k = 0; k < 4; ++k) s += char(uint8_t(x.m.size() >> 8 * k));
    for (uint64_t limb : x.m)
      for (int k = 0; k < 8; ++k) s += char(uint8_t(limb >> 8 * k));
  }
  return s;
}
Curve canonical(Curve c) {
  while (reduce(&c)) {
  }
  Big g;
  for (size_t i = c.size(); i-- > 0;) g = gcd(g, c[i]);
  for (Big& x : c) x = divide(x, g, nullptr);
  return c;
}
namespace {

// The part [0, to] of a row, to = b / 2^k, times 2^(k p).
void cut_behind(std::vector<Big>* d, size_t n, const Part& t) {
  const size_t p = d->size() / n - 1;
  const Big at = t.b, rest = (int64_t(1) << t.k) - t.b;
  for (size_t s = 1; s <= p; ++s)
    for (size_t i = p; i >= s; --i)
      for (size_t j = 0; j < n; ++j) {
        Big& x = (*d)[i * n + j];
        x = rest * (*d)[(i - 1) * n + j] + at * x;
      }
  for (size_t i = 0; i <= p; ++i)
    for (size_t j = 0; j < n; ++j) (*d)[i * n + j] = shifted((*d)[i * n + j], t.k * int64_t(p - i));
}
// Then keeps the part of the curve from a / b on, times b^p.
void cut_before(std::vector<Big>* d, size_t n, const Part& t) {
  const size_t p = d->size() / n - 1;
  const Big at = t.a, rest = t.b - t.a;
  for (size_t s = 1; s <= p; ++s)
    for (size_t i = 0; i <= p - s; ++i)
      for (size_t j = 0; j < n; ++j) {
        Big& x = (*d)[i * n + j];
        x = rest * x + at * (*d)[(i + 1) * n + j];
      }
  Big power = 1;
  for (size_t i = 0; i <= p; ++i, power = power * Big(t.b))
    for (size_t j = 0; j < n; ++j) (*d)[i * n + j] = (*d)[i * n + j] * power;
}

}  // namespace

std::vector<Big> restricted(std::vector<Big> row, size_t points, const Part& t) {
  if (t.a == 0 && t.b == int64_t(1) << t.k) return row;
  const size_t n = row.size() / points;
  cut_behind(&row, n, t);
  if (t.a < t.b) cut_before(&row, n, t);
  for (size_t i = n; i < row.size() && t.a == t.b; ++i)
    row[row.size() - 1 - i] = row[row.size() - 1 - i + n];
  return row;
}
void halve(const Curve& c, Curve* lower, Curve* upper) {
  const size_t n = c.size() / 4;
  Curve v = c;
  lower->resize(4 * n), upper->resize(4 * n);
  for (size_t s = 0; s < n; ++s)  // 2^(n - 1) times the points
    for (size_t j = 0; j < 4; ++j) {
      (*lower)[4 * s + j] = shifted(v[j], int64_t(n - 1 - s));
      (*upper)[4 * (n - 1 - s) + j] = shifted(v[4 * (n - 1 - s) + j], int64_t(n - 1 - s));
      for (size_t m = 0; m + 1 < n - s; ++m) v[4 * m + j] = v[4 * m + j] + v[4 * m + 4 + j];
    }
}
