// SPDX-License-Identifier: LGPL-3.0-or-later
// splines/bspline.h: tensor-product B-splines and NURBS: curves, surfaces, volumes with any number of
// components, in exact or rounded numbers.
#pragma once
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

#include "splines/control_net.h"
#include "splines/grid.h"
#include "splines/knot_axis.h"
#include "splines/ring.h"

namespace veritope {

/// A piecewise polynomial (rational) map from the product of the axes' domains. Rational maps are homogeneous: the last
/// component is the weight, the others are the weight times the coordinates. Coefficients are stored component by
/// component, and within a component as Grid says, the last axis fastest.
template <Ring R, std::size_t N>
class BSpline : public ControlNet<R> {
 public:
  using Knot = typename RingNumbers<R>::Knot;
  using Axis = KnotAxis<Knot>;

  /// REQUIRES what KnotAxis says and the right number of coefficients; data that were read go through make_bspline.
  BSpline(std::array<Axis, N> axes, int num_components, bool is_rational,
          std::vector<R> coefficients)
      : ControlNet<R>(grid_of(axes).count(), num_components, is_rational, std::move(coefficients)),
        axes_(std::move(axes)) {}

  const std::array<Axis, N>& axes() const { return axes_; }
  const Axis& axis(std::size_t i) const { return axes_[i]; }
  Grid<N> grid() const { return grid_of(axes_); }

  friend bool operator==(const BSpline&, const BSpline&) = default;

 private:
  static Grid<N> grid_of(const std::array<Axis, N>& axes) {
    Grid<N> g;
    for (std::size_t i = 0; i < N; ++i) g.size[i] = axes[i].num_control();
    return g;
  }
  std::array<Axis, N> axes_;
};

template <Ring R>
using BSplineCurve = BSpline<R, 1>;
template <Ring R>
using BSplineSurface = BSpline<R, 2>;
template <Ring R>
using BSplineVolume = BSpline<R, 3>;

}  // namespace veritope
