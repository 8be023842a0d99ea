// SPDX-License-Identifier: LGPL-3.0-or-later
// splines/bezier.h: maps in tensor-product Bernstein form: curves (N = 1), surfaces (2), volumes (3).
#pragma once
#include <array>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "robust/base/check.h"
#include "splines/grid.h"
#include "splines/ring.h"

namespace veritope {

/// A map from [0,1]^N with num_components() polynomials in Bernstein form of the same degrees. Rational maps
/// are homogeneous: the last component is the weight w, the others are w times the coordinates.
/// Coefficients lie component by component; within one as Grid says, the last variable fastest.
template <Ring R, std::size_t N>
class Bezier {
 public:
  /// REQUIRES count of coefficients = num_components * product of (degrees + 1).
  Bezier(std::array<int, N> degrees, int num_components, bool is_rational,
         std::vector<R> coefficients)
      : degrees_(degrees),
        num_components_(num_components),
        is_rational_(is_rational),
        coefficients_(std::move(coefficients)) {
    VT_CHECK(coefficients_.size() == grid().count() * static_cast<std::size_t>(num_components_),
             "a Bezier map needs a coefficient for every component and index");
  }
  /// All coefficients zero.
  Bezier(std::array<int, N> degrees, int num_components, bool is_rational)
      : degrees_(degrees), num_components_(num_components), is_rational_(is_rational) {
    coefficients_.resize(grid().count() * static_cast<std::size_t>(num_components_));
  }

  const std::array<int, N>& degrees() const { return degrees_; }
  int degree(std::size_t axis) const { return degrees_[axis]; }
  /// The weight included.
  int num_components() const { return num_components_; }
  bool is_rational() const { return is_rational_; }
  /// Of the points: without the weight.
  int dimension() const { return num_components_ - (is_rational_ ? 1 : 0); }
  Grid<N> grid() const {
    Grid<N> g;
    for (std::size_t i = 0; i < N; ++i) g.size[i] = static_cast<std::size_t>(degrees_[i]) + 1;
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

  friend bool operator==(const Bezier&, const Bezier&) = default;

 private:
  std::array<int, N> degrees_;
  int num_components_;
  bool is_rational_;
  std::vector<R> coefficients_;
};

template <Ring R>
using BezierCurve = Bezier<R, 1>;
template <Ring R>
using BezierSurface = Bezier<R, 2>;
template <Ring R>
using BezierVolume = Bezier<R, 3>;

}  // namespace veritope
