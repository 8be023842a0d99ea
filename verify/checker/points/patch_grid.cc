// SPDX-License-Identifier: Apache-2.0 OR MIT
#include "patch_grid.h"

namespace {

// Row r of a triangle of degree n, of degree r in v, in degree n, times n!.
void add_elevated(const Patch& p, int r, std::vector<Big>* to) {
  const int n = p.shape.p;
  std::vector<Big> row(p.net.begin() + 4 * p.shape.at3(r, 0),
                       p.net.begin() + 4 * (p.shape.at3(r, 0) + r + 1));
  Big factor = 1;  // r!
  for (int i = 2; i <= r; ++i) factor = factor * Big(i);
  for (Big& x : row) x = x * factor;
  for (int m = r; m < n; ++m) {  // from degree m to m + 1, times m + 1
    std::vector<Big> next(row.size() + 4);
    for (int i = 0; i <= m + 1; ++i)
      for (int k = 0; k < 4; ++k) {
        Big& x = next[size_t(4 * i + k)];
        if (i > 0) x = Big(i) * row[size_t(4 * (i - 1) + k)];
        if (i <= m) x = x + Big(m + 1 - i) * row[size_t(4 * i + k)];
      }
    row.swap(next);
  }
  to->insert(to->end(), row.begin(), row.end());
}

}  // namespace

RationalPoint::RationalPoint(const Ratio* c) : d(1) {
  for (int k = 0; k < 3; ++k) d = d * divide(c[k].d, gcd(d, c[k].d), nullptr);
  bits = d.bits();
  for (int k = 0; k < 3; ++k) {
    n[k] = c[k].n * divide(d, c[k].d, nullptr);
    bits = std::max(bits, n[k].bits());
  }
}

Mark::Mark(const Big& numerator, int64_t exponent) : n(numerator), k(exponent) {
  const int64_t common = std::min(k, n.zeros());
  if (common > 0) n = shifted(n, -common), k -= common;
}

Grid::Grid(const Patch& p) : shape{false, p.shape.p, p.shape.q}, is_triangle(p.shape.is_triangle) {
  if (is_triangle) {
    triangle = p.net;
    for (int r = 0; r <= p.shape.p; ++r) add_elevated(p, r, &net);
  } else {
    net = p.net;
  }
  Big common;
  for (size_t i = net.size(); i-- > 0 && !(common == Big(1));) common = gcd(common, net[i]);
  bits = 0;
  for (Big& x : net) {
    if (!(common == Big(1))) x = divide(x, common, nullptr);
    bits = std::max(bits, x.bits());
  }
  for (int side = 0; side < 4; ++side) {
    const bool is_corner = is_triangle && side == 3;
    const int e = is_triangle ? (side + 2) % 3 : side;
    pair[side] = is_corner ? kNoPair : p.pair[e];
    is_second[side] = !is_corner && p.is_second[e];
  }
}

std::vector<Big> Grid::around(const RationalPoint& q) const {
  std::vector<Big> r;
  r.reserve(net.size() / 4 * 3);
  for (size_t i = 0; i < net.size(); i += 4)
    for (size_t k = 0; k < 3; ++k) r.push_back(q.d * net[i + k] - net[i + 3] * q.n[k]);
  return r;
}

Big value_at(std::vector<Big> c, const Big& n, const Big& d) {
  const Big rest = d - n;
  for (size_t left = c.size(); left > 1; --left)
    for (size_t i = 0; i + 1 < left; ++i) c[i] = rest * c[i] + n * c[i + 1];
  return c[0];
}

std::vector<Big> on_part(std::vector<Big> c, const Mark& lo, const Mark& hi) {
  const int64_t k = std::max(lo.k, hi.k);
  const Big a = lo.times(k), b = hi.times(k), one = shifted(Big(1), k);
  const size_t p = c.size() - 1;
  if (!(b == one)) {  // what follows b is cut off
    const Big rest = one - b;
    for (size_t s = 1; s <= p; ++s)
      for (size_t i = p; i >= s; --i) c[i] = rest * c[i - 1] + b * c[i];
    for (size_t i = 0; i <= p; ++i) c[i] = shifted(c[i], k * int64_t(p - i));
  }
  if (a.sign() != 0) {  // what precedes a / b
    const Big rest = b - a;
    for (size_t s = 1; s <= p; ++s)
      for (size_t i = 0; i + s <= p; ++i) c[i] = rest * c[i] + a * c[i + 1];
    Big power = 1;
    for (size_t i = 0; i <= p; ++i, power = power * b) c[i] = c[i] * power;
  }
  return c;
}
