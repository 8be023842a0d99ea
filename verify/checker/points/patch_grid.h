// SPDX-License-Identifier: Apache-2.0 OR MIT
// patch_grid.h: patches as tensor patches, and points; docs/certificates/points.md, section 6.
#pragma once
#include "../patches/star.h"

// (n[0], n[1], n[2]) / d, d the least common denominator.
struct RationalPoint {
  Big n[3], d;
  int64_t bits;  // of the longest of the four

  RationalPoint(const Ratio* coordinates);
};

// n / 2^k, with the least k.
struct Mark {
  Big n;
  int64_t k;
  explicit Mark(const Big& numerator = Big(), int64_t exponent = 0);
  Big times(int64_t power) const { return shifted(n, power - k); }  // 2^power; REQUIRES power >= k
};
inline bool operator==(const Mark& a, const Mark& b) { return a.k == b.k && a.n == b.n; }
inline bool operator<(const Mark& a, const Mark& b) {
  const int64_t k = std::max(a.k, b.k);
  return a.times(k) < b.times(k);
}
inline Mark middle(const Mark& a, const Mark& b) {
  const int64_t k = std::max(a.k, b.k);
  return Mark(a.times(k) + b.times(k), k + 1);
}

// A tensor patch; sides 0 to 3 are v = 0, u = 1, v = 1, u = 0, counterclockwise.
struct Grid {
  Shape shape;           // no triangle
  bool is_triangle;      // the patch was one; its side 3 is its corner 0 here
  std::vector<Big> net;  // X, Y, Z, W of each control point, v fastest, without a common factor
  std::vector<Big> triangle;  // its own control points, if the patch was one
  int64_t bits;               // of the longest number of the net
  uint32_t pair[4];   // for each side, 4 * patch + side of the pair's first one; collapsed: kNoPair
  bool is_second[4];  // whether the side is the second one

  explicit Grid(const Patch& patch);
  bool is_collapsed(int side) const { return pair[side] == kNoPair; }
  int degree(int axis) const { return axis == 0 ? shape.p : shape.q; }
  uint64_t count() const { return uint64_t(shape.count()); }
  uint64_t degrees() const { return uint64_t(shape.p + shape.q); }
  // The coefficients R relative to the point: three numbers for each control point.
  std::vector<Big> around(const RationalPoint& point) const;
};

// The numbers at n / d, times d^(their number - 1).
Big value_at(std::vector<Big> c, const Big& n, const Big& d);
// The Bernstein coefficients on [lo, hi], times a positive number.
std::vector<Big> on_part(std::vector<Big> c, const Mark& lo, const Mark& hi);
