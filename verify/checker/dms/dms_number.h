// SPDX-License-Identifier: Apache-2.0 OR MIT
// dms_number.h: exact points, planes and rationals of simplex-spline solids. A sign is read off from floating-point
// values only where the bound of their error decides it; otherwise it is that of integers.
#pragma once
#include "../patches/big.h"

// The greatest common divisor, >= 0: binary where both are about as long, or else after a division.
Big dms_gcd(Big a, Big b);
Ratio dms_lowest(Ratio a);
inline Ratio dms_sum(const Ratio& a, const Ratio& b) {
  if (a.n.sign() == 0) return b;
  if (b.n.sign() == 0) return a;
  if (a.d == b.d) return dms_lowest(Ratio(a.n + b.n, a.d));
  return dms_lowest(Ratio(a.n * b.d + b.n * a.d, a.d * b.d));
}
inline Ratio dms_product(const Ratio& a, const Ratio& b) {
  return dms_lowest(Ratio(a.n * b.n, a.d * b.d));
}
// The numbers times the least common denominator, which goes to *factor unless that is null.
std::vector<Big> dms_integers(const std::vector<Ratio>& v, Big* factor);

// n / d with a relative error below 2^-50; an absolute one below 2^-990 if it is tiny; or infinite.
double dms_double(const Big& n, const Big& d);

struct DmsPoint {  // (X, Y, Z) / W, W > 0, no common factor
  Big x[4];
  double v[3];  // about its coordinates, by dms_double

  static DmsPoint of(const Big* homogeneous);
  static DmsPoint of(const Ratio* coordinates);
  double least(int k) const { return v[k] - (v[k] < 0 ? -v[k] : v[k]) * 2e-15 - 1e-290; }
  double most(int k) const { return v[k] + (v[k] < 0 ? -v[k] : v[k]) * 2e-15 + 1e-290; }
};
int dms_compare(const DmsPoint& a, const DmsPoint& b, int k);  // their coordinates k
bool dms_equal(const DmsPoint& a, const DmsPoint& b);

struct DmsPlane {  // a.x + a[3] = 0
  Big a[4];
  double f[4];  // about a, times a power of 2

  static DmsPlane of(const Big* a);
  static DmsPlane of(const Ratio* v_and_c);  // v.x = c
  // The normal is that of (b - a) x (c - a). The value at e is d(a, b, c, e) times the four denominators.
  static DmsPlane of(const DmsPoint& a, const DmsPoint& b, const DmsPoint& c);
  bool is_zero() const { return a[0].sign() == 0 && a[1].sign() == 0 && a[2].sign() == 0; }
  Big value(const DmsPoint& p) const {
    return a[0] * p.x[0] + a[1] * p.x[1] + (a[2] * p.x[2] + a[3] * p.x[3]);
  }
  int side(const DmsPoint& p) const;
};

inline Big dms_dot(const DmsPlane& a, const DmsPlane& b) {  // of their normals
  return a.a[0] * b.a[0] + a.a[1] * b.a[1] + a.a[2] * b.a[2];
}

// The linear part, times a positive number, row by row, of the affine map that takes four points to four images of
// three coordinates each. REQUIRES d of the points > 0.
std::vector<Big> dms_linear_part(const DmsPoint* const* points, const Ratio* const* images);
// Whether A B + (A B)^T is positive definite.
bool dms_is_positive(const std::vector<Big>& a, const std::vector<Big>& b);
Big dms_determinant(const std::vector<Big>& m);  // of three rows
