// SPDX-License-Identifier: LGPL-3.0-or-later
// io/splines/spline_builder.h: from a file's numbers to a valid spline, or to the sentence that says why they do not
// make one.
#pragma once
#include <array>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "io/splines/number_budget.h"
#include "robust/base/result.h"
#include "splines/bspline.h"

namespace veritope {

/// A spline as files list it: point by point, the first axis fastest (ours has the last one fastest), each point's
/// components together, the weight last and multiplied into the others.
template <std::size_t N>
struct RawSpline {
  std::array<std::uint64_t, N> num_control{};
  std::array<int, N> degrees{};
  std::array<std::vector<Rational>, N> knots;
  std::array<bool, N>
      is_periodic{};  ///< KVP of IRIT: the knots are all there, the repeated points are not
  int num_components = 0;
  bool is_rational = false;
  std::vector<Rational> points;
};

/// REQUIRES points.size() = num_components * product of num_control. The knots may be anything.
/// @error kBadSpline with the axis and the offending value; kOverLimit for a degree
template <std::size_t N>
Result<BSpline<Rational, N>> build_spline(RawSpline<N> raw);

/// The knots of one Bezier piece over [0, 1].
std::vector<Rational> bezier_knots(int degree);

/// Converts coefficients of t^i s^j ... over [0, 1] to Bernstein coefficients, in place. Returns false and changes
/// nothing if the result might exceed the budget: each may become as long as a common denominator and the largest
/// together.
/// @cost  one common denominator for each component; then additions, count * (sum of degrees) / 2 of them
template <std::size_t N>
bool power_to_bernstein(RawSpline<N>& raw, NumberBudget& budget);

extern template Result<BSpline<Rational, 1>> build_spline(RawSpline<1>);
extern template Result<BSpline<Rational, 2>> build_spline(RawSpline<2>);
extern template Result<BSpline<Rational, 3>> build_spline(RawSpline<3>);
extern template bool power_to_bernstein(RawSpline<1>&, NumberBudget&);
extern template bool power_to_bernstein(RawSpline<2>&, NumberBudget&);
extern template bool power_to_bernstein(RawSpline<3>&, NumberBudget&);

}  // namespace veritope
