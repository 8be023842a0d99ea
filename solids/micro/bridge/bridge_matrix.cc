// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/micro/bridge/bridge_matrix.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "interval/interval.h"
#include "interval/ring_numbers.h"
#include "interval/upward.h"
#include "solids/micro/bridge/matrix_search_internal.h"
#include "splines/bezier.h"
#include "splines/bezier_degree.h"

namespace veritope {
namespace {

using internal::determinant;
using internal::is_definite_product;
using internal::is_positive;
template <typename R>
using Matrix = internal::Matrix3<R>;

// The coefficients of the derivative, columns along the three axes, all in the degrees (p, q, 2).
template <Ring R>
std::vector<Matrix<R>> jacobian_coefficients(const MicroBridge& bridge,
                                             const std::vector<std::array<R, 3>>& points) {
  const std::array<int, 3> degrees = {bridge.degrees[0], bridge.degrees[1], kBridgeAxisDegree};
  const Grid<3> grid = BezierVolume<R>(degrees, 1, false).grid();
  std::vector<Matrix<R>> out(grid.count());
  for (std::size_t axis = 0; axis < 3; ++axis) {
    std::array<int, 3> lower = degrees;
    --lower[axis];
    BezierVolume<R> partial(lower, 3, false);
    const Grid<3> from = partial.grid();
    const R degree = RingNumbers<R>::ratio(degrees[axis], 1);
    for (std::size_t i = 0; i < from.count(); ++i) {
      const std::size_t at = grid.at(from.index_of(i));
      for (std::size_t c = 0; c < 3; ++c)
        partial.component(static_cast<int>(c))[i] =
            degree * (points[at + grid.stride(axis)][c] - points[at][c]);
    }
    partial = elevate(partial, axis, 1);
    for (std::size_t i = 0; i < out.size(); ++i)
      for (std::size_t c = 0; c < 3; ++c)
        out[i][3 * c + axis] = partial.component(static_cast<int>(c))[i];
  }
  return out;
}

template <typename R>
bool shows_all(const Matrix<R>& k, const std::vector<Matrix<R>>& jacobians) {
  if (!is_positive(determinant(k))) return false;
  return std::all_of(jacobians.begin(), jacobians.end(),
                     [&](const Matrix<R>& j) { return is_definite_product(k, j); });
}

bool shows_by_intervals(const BridgeMatrix& matrix, const MicroBridge& bridge) {
  const ScopedUpward upward;
  std::vector<std::array<Interval, 3>> points;
  for (const TilePoint& p : bridge.points)
    points.push_back({enclose(p[0]), enclose(p[1]), enclose(p[2])});
  Matrix<Interval> k;
  for (std::size_t i = 0; i < 9; ++i) k[i] = enclose(matrix[i]);
  return shows_all(k, jacobian_coefficients<Interval>(bridge, points));
}

std::vector<Matrix<double>> approx_jacobians(const MicroBridge& bridge) {
  const std::array<std::size_t, 3> size = {static_cast<std::size_t>(bridge.degrees[0]) + 1,
                                           static_cast<std::size_t>(bridge.degrees[1]) + 1,
                                           kBridgeAxisDegree + 1};
  const Grid<3> grid{size};
  std::vector<std::array<double, 3>> points;
  for (const TilePoint& p : bridge.points)
    points.push_back({nearest_double(p[0]), nearest_double(p[1]), nearest_double(p[2])});
  std::vector<Matrix<double>> out(grid.count());
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (std::size_t i = 0; i < grid.count(); ++i) {
      // Degree elevation of the differences: coefficient k is k d_(k-1) + (n - k) d_k, n the degree.
      const std::size_t k = grid.index_of(i)[axis], n = size[axis] - 1, step = grid.stride(axis);
      for (std::size_t c = 0; c < 3; ++c) {
        double sum = 0;
        if (k > 0) sum += static_cast<double>(k) * (points[i][c] - points[i - step][c]);
        if (k < n) sum += static_cast<double>(n - k) * (points[i + step][c] - points[i][c]);
        out[i][3 * c + axis] = sum;
      }
    }
  return out;
}

constexpr std::size_t kBridgeAxis = 2;
constexpr int kMostTurns = 300;

}  // namespace

bool shows_one_to_one(const BridgeMatrix& matrix, const MicroBridge& bridge) {
  if (shows_by_intervals(matrix, bridge)) return true;
  return shows_all(matrix, jacobian_coefficients<Rational>(bridge, bridge.points));
}

std::optional<BridgeMatrix> find_bridge_matrix(const MicroBridge& bridge) {
  return internal::find_definite_matrix(
      approx_jacobians(bridge), kBridgeAxis, kMostTurns,
      [&](const BridgeMatrix& k) { return shows_one_to_one(k, bridge); });
}

bool has_positive_determinants(const MicroBridge& bridge) {
  constexpr int kSamples = 4;  // parts of each axis
  const std::vector<Matrix<double>> all = approx_jacobians(bridge);
  const std::array<int, 3> degrees = {bridge.degrees[0], bridge.degrees[1], kBridgeAxisDegree};
  const auto weight = [](int degree, int i, double t) {
    double out = 1;
    for (int k = 1; k <= i; ++k) out *= t * (degree - i + k) / k;
    return out * std::pow(1 - t, degree - i);
  };
  const Grid<3> samples{{kSamples + 1, kSamples + 1, kSamples + 1}};
  const Grid<3> grid = BezierVolume<double>(degrees, 1, false).grid();
  for (std::size_t n = 0; n < samples.count(); ++n) {
    const auto at = samples.index_of(n);
    Matrix<double> sum{};
    for (std::size_t i = 0; i < grid.count(); ++i) {
      const auto index = grid.index_of(i);
      double w = 1;
      for (std::size_t a = 0; a < 3; ++a)
        w *= weight(degrees[a], static_cast<int>(index[a]), static_cast<double>(at[a]) / kSamples);
      for (std::size_t k = 0; k < 9; ++k) sum[k] += w * all[i][k];
    }
    if (!(determinant(sum) > 0)) return false;
  }
  return true;
}

}  // namespace veritope
