// SPDX-License-Identifier: LGPL-3.0-or-later
// splines/bezier.h: maps in tensor-product Bernstein form: curves (N = 1), surfaces (2), volumes (3).
#pragma once
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

#include "splines/control_net.h"
#include "splines/grid.h"
#include "splines/ring.h"

namespace veritope {

/// A map from [0,1]^N with num_components() polynomials in Bernstein form of the same degrees. Rational maps
/// are homogeneous: the last component is the weight w, the others are w times the coordinates.
/// Coefficients are stored component by component, and within a component as Grid says, the last variable fastest.
template <Ring R, std::size_t N>
class Bezier : public ControlNet<R> {
 public:
  /// REQUIRES num_components * product of (degrees + 1) coefficients.
  Bezier(std::array<int, N> degrees, int num_components, bool is_rational,
         std::vector<R> coefficients)
      : ControlNet<R>(grid_of(degrees).count(), num_components, is_rational,
                      std::move(coefficients)),
        degrees_(degrees) {}
  /// All coefficients zero.
  Bezier(std::array<int, N> degrees, int num_components, bool is_rational)
      : Bezier(
            degrees, num_components, is_rational,
            std::vector<R>(grid_of(degrees).count() * static_cast<std::size_t>(num_components))) {}

  const std::array<int, N>& degrees() const { return degrees_; }
  int degree(std::size_t axis) const { return degrees_[axis]; }
  Grid<N> grid() const { return grid_of(degrees_); }

  friend bool operator==(const Bezier&, const Bezier&) = default;

 private:
  static Grid<N> grid_of(const std::array<int, N>& degrees) {
    Grid<N> g;
    for (std::size_t i = 0; i < N; ++i) g.size[i] = static_cast<std::size_t>(degrees[i]) + 1;
    return g;
  }
  std::array<int, N> degrees_;
};

template <Ring R>
using BezierCurve = Bezier<R, 1>;
template <Ring R>
using BezierSurface = Bezier<R, 2>;
template <Ring R>
using BezierVolume = Bezier<R, 3>;

}  // namespace veritope
