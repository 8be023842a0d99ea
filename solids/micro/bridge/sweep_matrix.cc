// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/micro/bridge/sweep_matrix.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "interval/box_geometry.h"
#include "interval/upward.h"
#include "solids/micro/bridge/matrix_search_internal.h"
#include "splines/bezier_calculus.h"
#include "splines/bezier_degree.h"
#include "splines/bezier_domain.h"
#include "splines/bezier_product.h"

namespace veritope {
namespace {

using internal::Matrix3;
using MatrixList = std::vector<Matrix3<Interval>>;

// The coordinates of a rational map as numerators, and its weight, as polynomial maps.
template <std::size_t N>
Bezier<Interval, N> numerators_of(const Bezier<Interval, N>& map) {
  const auto all = map.coefficients();
  const auto count = static_cast<std::ptrdiff_t>(3 * map.grid().count());
  return {map.degrees(), 3, false, std::vector<Interval>(all.begin(), all.begin() + count)};
}
BezierVolume<Interval> weight_of(const BezierVolume<Interval>& map) {
  const auto w = map.component(3);
  return {map.degrees(), 1, false, std::vector<Interval>(w.begin(), w.end())};
}

// The columns W (X, Y, Z)_i - W_i (X, Y, Z) by the parameters of the unit cube, and W^2, all in one degree: that of the
// map, or twice that of a rational one.
struct Derivative {
  std::array<BezierVolume<Interval>, 3> columns;
  BezierVolume<Interval> weight;
};
Derivative derivative_of(const BezierVolume<Interval>& map) {
  const BezierVolume<Interval> x = map.is_rational() ? numerators_of(map) : map;
  if (!map.is_rational()) {
    BezierVolume<Interval> one(map.degrees(), 1, false);
    for (Interval& c : one.component(0)) c = Interval(1.0);
    const auto column = [&](std::size_t axis) {
      return elevate_to(derivative(x, axis), map.degrees());
    };
    return {{column(0), column(1), column(2)}, one};
  }
  const BezierVolume<Interval> w = weight_of(map);
  const BezierVolume<Interval> weight = multiplied(w, w);
  const auto column = [&](std::size_t axis) {
    return elevate_to(
        difference(multiplied(w, derivative(x, axis)), multiplied(derivative(w, axis), x)),
        weight.degrees());
  };
  return {{column(0), column(1), column(2)}, weight};
}

// The matrices of Q2 in the parameters of the cell, brought to the unit cube: there K has its row i times the width
// along i in the place of row i, and the speed counts times the width along the wall's axis.
class SweepDerivatives {
 public:
  SweepDerivatives(const SweepStarts& starts, const MicroSweep& sweep, const Rational& depth)
      : across_(static_cast<std::size_t>(sweep.cap.wall / 2)),
        is_end_(sweep.cap.wall % 2 == 1),
        all_(derivative_of(starts.slab(sweep.cap, depth))),
        widths_(starts.widths(sweep.cap)) {
    for (std::size_t c = 0; c < 3; ++c) {
      directions_[0][c] = enclose(sweep.axis[0][c]);
      directions_[1][c] = enclose(sweep.axis[1][c] - sweep.axis[0][c]);
    }
    const Interval stretch = Interval(1.0) / enclose(depth);
    for (Interval& x : all_.columns[across_].coefficients()) x = stretch * x;
  }

  std::size_t across() const { return across_; }
  const std::array<Rational, 3>& widths() const { return widths_; }
  /// The coefficients of D on the slab.
  MatrixList slab() const {
    MatrixList out(all_.weight.grid().count());
    for (std::size_t i = 0; i < out.size(); ++i)
      for (std::size_t axis = 0; axis < 3; ++axis)
        for (std::size_t c = 0; c < 3; ++c)
          out[i][3 * c + axis] = all_.columns[axis].component(static_cast<int>(c))[i];
    return out;
  }
  /// Those on the wall, with both directions of the curve in the place of the derivative across the wall.
  MatrixList wall(const Interval& speed) const {
    const Grid<3> grid = all_.weight.grid();
    MatrixList out;
    for (std::size_t i = 0; i < grid.count(); ++i) {
      if (grid.index_of(i)[across_] != (is_end_ ? grid.size[across_] - 1 : 0)) continue;
      const Interval factor =
          (is_end_ ? Interval(1.0) : Interval(-1.0)) * speed * all_.weight.component(0)[i];
      for (const Box3& direction : directions_) {
        Matrix3<Interval>& m = out.emplace_back();
        for (std::size_t axis = 0; axis < 3; ++axis)
          for (std::size_t c = 0; c < 3; ++c)
            m[3 * c + axis] = axis == across_
                                  ? factor * direction[c]
                                  : all_.columns[axis].component(static_cast<int>(c))[i];
      }
    }
    return out;
  }

 private:
  std::size_t across_;
  bool is_end_;
  Derivative all_;
  std::array<Rational, 3> widths_;
  std::array<Box3, 2> directions_;
};

bool shows(const SweepDerivatives& derivatives, const MatrixList& slab, const BridgeMatrix& matrix,
           const Rational& speed) {
  Matrix3<Interval> k;
  for (std::size_t i = 0; i < 9; ++i) k[i] = enclose(matrix[i] * derivatives.widths()[i / 3]);
  const auto holds = [&](const Matrix3<Interval>& j) {
    return internal::is_definite_product(k, j);
  };
  const MatrixList wall =
      derivatives.wall(enclose(speed * derivatives.widths()[derivatives.across()]));
  return std::all_of(wall.begin(), wall.end(), holds) &&
         std::all_of(slab.begin(), slab.end(), holds);
}

Matrix3<double> middle_of(const Matrix3<Interval>& m) {
  Matrix3<double> out;
  for (std::size_t i = 0; i < 9; ++i) out[i] = internal::approx_middle(m[i]);
  return out;
}
double column_length(const Matrix3<double>& m, std::size_t axis) {
  return std::sqrt(m[axis] * m[axis] + m[3 + axis] * m[3 + axis] + m[6 + axis] * m[6 + axis]);
}

// The speed, in the parameters of the unit cube, with which the column across the wall has the same length in the mean
// on the wall and on the slab.
double equal_speed(const SweepDerivatives& derivatives, const MatrixList& slab) {
  double in_slab = 0, on_wall = 0;
  for (const auto& m : slab)
    in_slab += column_length(middle_of(m), derivatives.across()) / static_cast<double>(slab.size());
  const MatrixList wall = derivatives.wall(Interval(1.0));
  for (const auto& m : wall)
    on_wall += column_length(middle_of(m), derivatives.across()) / static_cast<double>(wall.size());
  return in_slab / on_wall;
}

double determinant_of_mean(const MatrixList& list, std::size_t first, std::size_t step) {
  Matrix3<double> mean{};
  for (std::size_t i = first; i < list.size(); i += step) {
    const Matrix3<double> m = middle_of(list[i]);
    for (std::size_t k = 0; k < 9; ++k) mean[k] += m[k];
  }
  return internal::determinant(mean);
}
// Where the curve leads into the cell, by the mean derivatives, no matrix can do.
bool leads_outward(const SweepDerivatives& derivatives, const MatrixList& slab) {
  const MatrixList wall = derivatives.wall(Interval(1.0));
  const double whole = determinant_of_mean(slab, 0, 1);
  return whole * determinant_of_mean(wall, 0, 2) > 0 && whole * determinant_of_mean(wall, 1, 2) > 0;
}

constexpr std::array<int, 3> kDepthBits = {0, 1, 3};
constexpr std::array<int, 5> kSpeedPowers = {0, -2, -4, 2, -6};
constexpr int kMostSweepTurns = 40;
constexpr int kMostExponent = 40;  // of numbers of the certificate, which have at most 63 bits

}  // namespace

bool shows_one_to_one(const SweepWitness& witness, const SweepStarts& starts,
                      const MicroSweep& sweep) {
  const ScopedUpward upward;
  const SweepDerivatives derivatives(starts, sweep, witness.depth);
  return shows(derivatives, derivatives.slab(), witness.matrix, witness.speed);
}

std::optional<SweepWitness> find_sweep_witness(const SweepStarts& starts, const MicroSweep& sweep) {
  const ScopedUpward upward;
  for (const int bits : kDepthBits) {
    SweepWitness out;
    out.depth = Rational::power_of_two(-bits);
    const SweepDerivatives derivatives(starts, sweep, out.depth);
    const MatrixList slab = derivatives.slab();
    if (!leads_outward(derivatives, slab)) return std::nullopt;
    const double equal = equal_speed(derivatives, slab);
    const Rational& width = derivatives.widths()[derivatives.across()];
    if (!std::isfinite(equal) || !(equal > 0)) return std::nullopt;
    for (const int power : kSpeedPowers) {
      const int exponent = std::ilogb(equal / nearest_double(width)) + power;
      if (std::abs(exponent) > kMostExponent) continue;
      out.speed = Rational::power_of_two(exponent);
      std::vector<Matrix3<double>> all;
      for (const auto& m : slab) all.push_back(middle_of(m));
      for (const auto& m : derivatives.wall(enclose(out.speed * width)))
        all.push_back(middle_of(m));
      // K in the parameters of the volume: column i of the derivative is shorter by the width along i there.
      for (Matrix3<double>& m : all)
        for (std::size_t i = 0; i < 9; ++i) m[i] /= nearest_double(derivatives.widths()[i % 3]);
      const auto found = internal::find_definite_matrix(
          std::move(all), derivatives.across(),
          power == 0 && bits == kDepthBits.back() ? kMostSweepTurns : 0,
          [&](const BridgeMatrix& k) { return shows(derivatives, slab, k, out.speed); });
      if (!found) continue;
      out.matrix = *found;
      return out;
    }
  }
  return std::nullopt;
}

}  // namespace veritope
