// SPDX-License-Identifier: LGPL-3.0-or-later
// splines/fast_spline.h: a B-spline or NURBS prepared for many evaluations in binary64, on request with a
// proved bound of every error.  Bound: docs/bounds/fast_spline.md.
#pragma once
#include <array>
#include <cstddef>
#include <memory>
#include <utility>

#include "robust/base/result.h"
#include "splines/bspline.h"

namespace veritope {

/// The instruction sets of FastSpline; every one computes the same bits.
enum class FastBackEnd { kBaseline, kAvx2 };
bool is_available(FastBackEnd back_end);
FastBackEnd widest_fast_back_end();

/// Where results go: point after point, and within a point
///   value, value_bound       dimension() numbers
///   partial, partial_bound   the derivative by the first parameter, dimension() numbers, then by the second, ...
/// A pointer is null if its result is not wanted; value is always wanted, and each bound only with what it bounds.
struct FastSplineOutput {
  double* value = nullptr;
  double* value_bound = nullptr;
  double* partial = nullptr;
  double* partial_bound = nullptr;
};

/// A map cut into Bezier pieces whose control points are rounded once. A copy shares its tables.
/// Claim    |computed - exact| <= bound, coordinate by coordinate. exact is the value of the spline with exact knots
///          and control points, of its cell's polynomial, at the exact value of the binary64 parameter. The bound
///          includes the errors of conversion.
/// Not      the least bound: polynomial maps have one number for each piece and coordinate.
/// Outside  of the domain, and for NaN, values are NaN and bounds infinite. At a break the right-hand cell counts.
/// Computes to nearest with gradual underflow whatever the caller's control word is; the same bits on every processor.
/// Memory: 32 bytes for a coefficient of every piece, for four components.
template <std::size_t N>
class FastSpline {
 public:
  /// @error kOverLimit for a coefficient or a derivative's scale beyond 2^200, weights whose ratio exceeds 2^40
  ///        or that change in a span between neighbouring doubles, more than 2^26 coefficients; kBadArgument for
  ///        weights that are not positive; kNotFinite for doubles that are not.
  /// @cost  knot insertion in rationals: milliseconds for 1,000 control points.
  static Result<FastSpline> prepare(const BSpline<Rational, N>& map);
  static Result<FastSpline> prepare(const BSpline<double, N>& map);

  std::size_t dimension() const;
  /// The least and the greatest binary64 numbers in the domain of an axis.
  std::array<double, 2> domain(std::size_t axis) const;

  /// at[a][i]: parameter a of point i, i < n.  @cost bicubic 25, tricubic 42 ns per point (docs/benchmarks.md)
  void evaluate(const std::array<const double*, N>& at, std::size_t n,
                const FastSplineOutput& out) const;
  /// REQUIRES is_available(back_end).
  void evaluate_on(FastBackEnd back_end, const std::array<const double*, N>& at, std::size_t n,
                   const FastSplineOutput& out) const;

 private:
  struct Data;
  explicit FastSpline(std::shared_ptr<const Data> data) : data_(std::move(data)) {}
  std::shared_ptr<const Data> data_;
};

namespace internal {
/// Roundings of a weight of degree n, and of the sums that are made with them (docs/bounds/fast_spline.md, 2).
constexpr int fast_weight_roundings(int n) { return n <= 1 ? n : 3 * (n - 1); }
template <std::size_t N>
constexpr int fast_value_roundings(const std::array<int, N>& degrees) {
  int count = 0;
  for (const int n : degrees) count += fast_weight_roundings(n) + 1 + n;
  return count;
}
/// The bound with one axis differentiated: a difference of weights, the degree lower by one, with the same number of
/// roundings.
template <std::size_t N>
constexpr int fast_partial_roundings(const std::array<int, N>& degrees, std::size_t axis) {
  return fast_value_roundings(degrees) - fast_weight_roundings(degrees[axis]) +
         fast_weight_roundings(degrees[axis] - 1) + (degrees[axis] > 1 ? 1 : 0);
}
}  // namespace internal

extern template class FastSpline<1>;
extern template class FastSpline<2>;
extern template class FastSpline<3>;

}  // namespace veritope
