// SPDX-License-Identifier: Apache-2.0 OR MIT
#include "dms_number.h"

#include <cmath>

namespace {

void subtract_from(LimbList* a, const LimbList& b) {  // REQUIRES a >= b
  uint64_t borrow = 0;
  for (size_t i = 0; i < a->size() && (i < b.size() || borrow != 0); ++i) {
    const u128 t = u128((*a)[i]) - (i < b.size() ? b[i] : 0) - borrow;
    (*a)[i] = uint64_t(t);
    borrow = uint64_t(t >> 64) & 1;
  }
}
void drop_twos(Big* a) {  // REQUIRES a != 0
  size_t limbs = 0;
  while (a->m[limbs] == 0) ++limbs;
  const int low = __builtin_ctzll(a->m[limbs]);
  const size_t n = a->m.size() - limbs;
  for (size_t i = 0; i < n; ++i) {
    const uint64_t above = i + 1 < n ? a->m[i + limbs + 1] : 0;
    a->m[i] = low == 0 ? a->m[i + limbs] : a->m[i + limbs] >> low | above << (64 - low);
  }
  a->m.resize(n, 0);
  a->trim();
}
uint64_t gcd_of_limbs(uint64_t a, uint64_t b) {  // odd ones
  while (a != b) {
    if (a < b) std::swap(a, b);
    a -= b;
    a >>= __builtin_ctzll(a);
  }
  return a;
}

// The first 64 bits as a number in [1, 2), and its exponent.
double leading(const Big& a, int64_t* exponent) {
  const int64_t bits = a.bits();
  *exponent = bits - 1;
  const uint64_t top = bits > 64 ? shifted(a, 64 - bits).m[0] : a.m[0] << (64 - bits);
  return std::ldexp(double(top), -63);
}
double scaled_double(const Big& a, int64_t minus) {  // about a / 2^minus
  if (a.sign() == 0) return 0;
  int64_t e = 0;
  const double v = leading(a, &e);
  e = std::max<int64_t>(e - minus, -1100);
  return std::ldexp(a.neg ? -v : v, int(e));
}
Big minor(const DmsPoint& a, const DmsPoint& b, const DmsPoint& c, int i, int j, int k) {
  return a.x[i] * (b.x[j] * c.x[k] - b.x[k] * c.x[j]) -
         a.x[j] * (b.x[i] * c.x[k] - b.x[k] * c.x[i]) +
         a.x[k] * (b.x[i] * c.x[j] - b.x[j] * c.x[i]);
}

}  // namespace

Big dms_gcd(Big a, Big b) {
  a.neg = b.neg = false;
  if (a.sign() == 0) return b;
  if (b.sign() == 0) return a;
  const int64_t twos = std::min(a.zeros(), b.zeros());
  drop_twos(&a);
  drop_twos(&b);
  while (!(a.is_one() || b.is_one())) {
    if (a.m.size() == 1 && b.m.size() == 1) {
      a.m[0] = gcd_of_limbs(a.m[0], b.m[0]);
      return shifted(a, twos);
    }
    const int order = compare_magnitudes(a, b);
    if (order == 0) return shifted(a, twos);
    if (order < 0) std::swap(a, b);
    if (a.m.size() > b.m.size() + 1) {
      Big rest;
      divide(a, b, &rest);
      a = rest;
    } else {
      subtract_from(&a.m, b.m);
      a.trim();
    }
    if (a.sign() == 0) return shifted(b, twos);
    drop_twos(&a);
  }
  return shifted(Big(1), twos);
}
Ratio dms_lowest(Ratio a) {
  if (a.n.sign() == 0) return Ratio();
  if (a.d.is_one()) return a;
  const Big g = dms_gcd(a.n, a.d);
  if (g.is_one()) return a;
  return Ratio(divide(a.n, g, nullptr), divide(a.d, g, nullptr));
}
std::vector<Big> dms_integers(const std::vector<Ratio>& v, Big* factor) {
  Big all = 1;
  for (const Ratio& x : v)
    if (!(x.d == all) && !x.d.is_one()) all = all * divide(x.d, dms_gcd(all, x.d), nullptr);
  std::vector<Big> r;
  for (const Ratio& x : v)
    r.push_back(x.d == all ? x.n : x.n * (x.d.is_one() ? all : divide(all, x.d, nullptr)));
  if (factor != nullptr) *factor = all;
  return r;
}

double dms_double(const Big& n, const Big& d) {
  if (n.sign() == 0) return 0;
  int64_t up = 0, down = 0;
  const double v = leading(n, &up) / leading(d, &down);
  return std::ldexp(n.neg ? -v : v, int(std::max<int64_t>(up - down, -1100)));
}
DmsPoint DmsPoint::of(const Big* homogeneous) {
  DmsPoint r;
  Big g = homogeneous[3];
  for (int k = 0; k < 3 && !g.is_one(); ++k) g = dms_gcd(g, homogeneous[k]);
  for (int k = 0; k < 4; ++k)
    r.x[k] = g.is_one() ? homogeneous[k] : divide(homogeneous[k], g, nullptr);
  for (int k = 0; k < 3; ++k) r.v[k] = dms_double(r.x[k], r.x[3]);
  return r;
}
DmsPoint DmsPoint::of(const Ratio* coordinates) {
  Big w;
  std::vector<Big> x = dms_integers(std::vector<Ratio>(coordinates, coordinates + 3), &w);
  x.push_back(w);
  return of(x.data());
}
int dms_compare(const DmsPoint& a, const DmsPoint& b, int k) {
  if (a.most(k) < b.least(k)) return -1;
  if (b.most(k) < a.least(k)) return 1;
  return compare(a.x[k] * b.x[3], b.x[k] * a.x[3]);
}
bool dms_equal(const DmsPoint& a, const DmsPoint& b) {
  return a.x[0] == b.x[0] && a.x[1] == b.x[1] && a.x[2] == b.x[2] && a.x[3] == b.x[3];
}

DmsPlane DmsPlane::of(const Big* a) {
  DmsPlane r;
  int64_t most = 0;
  for (int k = 0; k < 4; ++k) {
    r.a[k] = a[k];
    most = std::max(most, a[k].bits());
  }
  for (int k = 0; k < 4; ++k) r.f[k] = scaled_double(a[k], most);
  return r;
}
DmsPlane DmsPlane::of(const Ratio* v_and_c) {
  std::vector<Big> a = dms_integers(std::vector<Ratio>(v_and_c, v_and_c + 4), nullptr);
  a[3] = -a[3];
  return of(a.data());
}
DmsPlane DmsPlane::of(const DmsPoint& a, const DmsPoint& b, const DmsPoint& c) {
  const Big n[4] = {minor(a, b, c, 1, 2, 3), minor(a, b, c, 2, 0, 3), minor(a, b, c, 0, 1, 3),
                    -minor(a, b, c, 0, 1, 2)};
  return of(n);
}
int DmsPlane::side(const DmsPoint& p) const {
  const double x = f[0] * p.v[0], y = f[1] * p.v[1], z = f[2] * p.v[2], w = f[3];
  const double sum = x + y + z + w;
  // Factors have relative errors below 2^-50, sums have three roundings. What is infinite decides nothing.
  const double error =
      (std::fabs(x) + std::fabs(y) + std::fabs(z) + std::fabs(w)) * 1.5e-14 + 1e-150;
  if (sum > error) return 1;
  if (sum < -error) return -1;
  return value(p).sign();
}

std::vector<Big> dms_linear_part(const DmsPoint* const* points, const Ratio* const* images) {
  std::vector<Ratio> domain, range;
  for (int m = 0; m < 4; ++m)
    for (int k = 0; k < 3; ++k) {
      domain.push_back(Ratio(points[m]->x[k], points[m]->x[3]));
      range.push_back(images[m][k]);
    }
  const std::vector<Big> p = dms_integers(domain, nullptr), c = dms_integers(range, nullptr);
  Big e[3][3], to[3][3];  // of point 1, 2, 3: minus point 0
  for (size_t m = 0; m < 3; ++m)
    for (size_t k = 0; k < 3; ++k) {
      e[m][k] = p[3 * m + 3 + k] - p[k];
      to[m][k] = c[3 * m + 3 + k] - c[k];
    }
  std::vector<Big> r(9);
  for (int m = 0; m < 3; ++m) {  // the functional that is 1 on e[m] and 0 on the others, times d
    const Big *const u = e[(m + 1) % 3], *const v = e[(m + 2) % 3];
    for (int k = 0; k < 3; ++k) {
      const int i = (k + 1) % 3, j = (k + 2) % 3;
      const Big normal = u[i] * v[j] - u[j] * v[i];
      for (int row = 0; row < 3; ++row)
        r[size_t(3 * row + k)] = r[size_t(3 * row + k)] + to[m][row] * normal;
    }
  }
  Big g;
  for (size_t i = 0; i < 9 && !g.is_one(); ++i) g = dms_gcd(g, r[i]);
  for (Big& x : r)
    if (g.sign() != 0 && !g.is_one()) x = divide(x, g, nullptr);
  return r;
}
bool dms_is_positive(const std::vector<Big>& a, const std::vector<Big>& b) {
  Big s[3][3];
  for (size_t i = 0; i < 3; ++i)
    for (size_t j = 0; j < 3; ++j)
      s[i][j] = a[3 * i] * b[j] + a[3 * i + 1] * b[3 + j] + a[3 * i + 2] * b[6 + j];
  const Big xx = s[0][0] + s[0][0], yy = s[1][1] + s[1][1], zz = s[2][2] + s[2][2];
  if (xx.sign() <= 0 || yy.sign() <= 0 || zz.sign() <= 0) return false;
  const Big xy = s[0][1] + s[1][0], xz = s[0][2] + s[2][0], yz = s[1][2] + s[2][1];
  if ((xx * yy - xy * xy).sign() <= 0) return false;
  return dms_determinant({xx, xy, xz, xy, yy, yz, xz, yz, zz}).sign() > 0;
}
Big dms_determinant(const std::vector<Big>& m) {
  return m[0] * (m[4] * m[8] - m[5] * m[7]) - m[1] * (m[3] * m[8] - m[5] * m[6]) +
         m[2] * (m[3] * m[7] - m[4] * m[6]);
}
