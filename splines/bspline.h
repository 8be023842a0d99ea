// SPDX-License-Identifier: LGPL-3.0-or-later
// splines/bspline.h: tensor-product B-splines and NURBS: curves, surfaces, volumes with any number of
// components, in exact or rounded numbers.
#pragma once
#include <array>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "robust/base/check.h"
#include "splines/grid.h"
#include "splines/knot_axis.h"
#include "splines/ring.h"

namespace veritope {

/// A piecewise polynomial (rational) map from the product of the axes' domains. Rational maps are homogeneous: the last
/// component is the weight, the others are the weight times the coordinates. Coefficients lie component by component; within
/// one as Grid says, the last axis fastest.
template <Ring R, std::size_t N>
class BSpline {
 public:
  using Knot = typename RingNumbers<R>::Knot;
  using Axis = KnotAxis<Knot>;

  /// REQUIRES what KnotAxis says and the right number of coefficients; read data go through make_bspline.
  BSpline(std::array<Axis, N> axes, int num_components, bool is_rational,
          std::vector<R> coefficients)
      : axes_(std::move(axes)),
        num_components_(num_components),
        is_rational_(is_rational),
        coefficients_(std::move(coefficients)) {
    VT_CHECK(coefficients_.size() == grid().count() * static_cast<std::size_t>(num_components_),
             "a B-spline needs a coefficient for every component and index");
  }

  const std::array<Axis, N>& axes() const { return axes_; }
  const Axis& axis(std::size_t i) const { return axes_[i]; }
  int num_components() const { return num_components_; }
  bool is_rational() const { return is_rational_; }
  int dimension() const { return num_components_ - (is_rational_ ? 1 : 0); }
  Grid<N> grid() const {
    Grid<N> g;
    for (std::size_t i = 0; i < N; ++i) g.size[i] = axes_[i].num_control();
    return g;
  }
  std::span<const R> coefficients() const { return coefficients_; }
  std::span<R> coefficients() { return coefficients_; }
  std::span<const R> component(int c) const {
    return coefficients().subspan(static_cast<std::size_t>(c) * grid().count(), grid().count());
  }
  std::span<R> component(int c) {
    return coefficients().subspan(static_cast<std::size_t>(c) * grid().count(), grid().count());
  }
  friend bool operator==(const BSpline&, const BSpline&) = default;

 private:
  std::array<Axis, N> axes_;
  int num_components_;
  bool is_rational_;
  std::vector<R> coefficients_;
};

template <Ring R>
using BSplineCurve = BSpline<R, 1>;
template <Ring R>
using BSplineSurface = BSpline<R, 2>;
template <Ring R>
using BSplineVolume = BSpline<R, 3>;

}  // namespace veritope
