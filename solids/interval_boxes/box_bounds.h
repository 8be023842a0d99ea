// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/interval_boxes/box_bounds.h: the only place of this folder where floating-point operations that round decide.
// Bounds: docs/bounds/box_bounds.md, recomputed in exact rationals by tests/solids/box_bounds_test.cc.
//
// Formulas are templates, because the bound test runs the same lines on numbers that count roundings.
// Needs: any rounding mode, gradual underflow, no contraction.
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "robust/base/box3d.h"

namespace veritope::internal {

// u = 2^-52: every rounded operation errs by at most this times its exact result, in every rounding mode.

// ---- 1. distances of boxes

/// How far [a_lo, a_hi] and [b_lo, b_hi] are apart, and how far apart two of their points can be.
template <typename Number>
Number gap(const Number& a_lo, const Number& a_hi, const Number& b_lo, const Number& b_hi) {
  return std::max({Number{}, a_lo - b_hi, b_lo - a_hi});
}
template <typename Number>
Number reach(const Number& a_lo, const Number& a_hi, const Number& b_lo, const Number& b_hi) {
  return std::max(a_hi - b_lo, b_hi - a_lo);
}
template <typename Number>
Number sum_of_squares(const std::array<Number, 3>& d) {
  return d[0] * d[0] + d[1] * d[1] + d[2] * d[2];
}
inline constexpr double kDistanceRel = 0x1.2p-50 * (1 + 0x1p-40);  // 4.5 u
/// More than the root of all underflows of one sum.
inline constexpr double kDistanceTiny = 0x1p-500;
/// Claim: if `distance` is the computed root of the sum of squares of three gaps, or reaches, then the exact root is at
/// least `distance` minus this, as computed, and at most `distance` plus this, as computed.
inline double distance_bound(double distance) { return kDistanceRel * distance + kDistanceTiny; }

/// At most the distance of the boxes; not negative.
inline double least_distance(const Box3d& a, const Box3d& b) {
  std::array<double, 3> d;
  for (std::size_t k = 0; k < 3; ++k) d[k] = gap(a.lo[k], a.hi[k], b.lo[k], b.hi[k]);
  const double distance = std::sqrt(sum_of_squares(d));
  return std::max(0.0, distance - distance_bound(distance));  // 0 also if squares overflow
}
/// At least the distance of any point of a from any point of b.
inline double greatest_distance(const Box3d& a, const Box3d& b) {
  std::array<double, 3> d;
  for (std::size_t k = 0; k < 3; ++k) d[k] = reach(a.lo[k], a.hi[k], b.lo[k], b.hi[k]);
  const double distance = std::sqrt(sum_of_squares(d));
  return distance + distance_bound(distance);
}
/// Claim: true only if hi <= (1 + 2^-6) lo. The difference is exact where that holds. REQUIRES 0 <= lo <= hi, and that
/// lo is 0 or at least 2^-1000.
inline bool is_close_above(double lo, double hi) { return hi - lo <= 0x1p-6 * lo; }

/// Claim: a product with it is, as computed, at most the exact quotient by sqrt(3).
inline constexpr double kPerRootOfThree = 0x1.279a74590331bp-1;

// ---- 2. cells of an octree

/// Where x lies in cells from the octree's lower end.
template <typename Number>
Number in_cells(const Number& x, const Number& low, const Number& size) {
  return (x - low) / size;
}
/// 2 u 2^20. Places below 2^20 are multiples of a unit that divides it, so taking it away from a place rounds nothing.
inline constexpr double kCellMargin = 0x1p-31;
/// Claim: all points from x to y lie in the interior of the union of the cells from first_cell of x to last_cell of y.
/// REQUIRES the exact places of x and y to be at least 1 and at most 2^20 - 1/2.
inline std::uint32_t first_cell(double x, double low, double size) {
  return static_cast<std::uint32_t>(std::floor(in_cells(x, low, size) - kCellMargin));
}
inline std::uint32_t last_cell(double x, double low, double size) {
  return static_cast<std::uint32_t>(std::floor(in_cells(x, low, size) + kCellMargin));
}

}  // namespace veritope::internal
