// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/micro/bridge/bridge_matrix.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "interval/interval.h"
#include "interval/ring_numbers.h"
#include "interval/upward.h"
#include "splines/bezier.h"
#include "splines/bezier_degree.h"

namespace veritope {
namespace {

template <typename R>
using Matrix = std::array<R, 9>;  // row by row

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
R determinant(const Matrix<R>& m) {
  return m[0] * (m[4] * m[8] - m[5] * m[7]) - m[1] * (m[3] * m[8] - m[5] * m[6]) +
         m[2] * (m[3] * m[7] - m[4] * m[6]);
}
template <typename R>
Matrix<R> product(const Matrix<R>& a, const Matrix<R>& b) {
  Matrix<R> out;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      out[3 * i + j] = a[3 * i] * b[j] + a[3 * i + 1] * b[3 + j] + a[3 * i + 2] * b[6 + j];
  return out;
}
template <typename R>
Matrix<R> symmetric_part(const Matrix<R>& m) {
  Matrix<R> out;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) out[3 * i + j] = m[3 * i + j] + m[3 * j + i];
  return out;
}
// Positive only if all three leading minors are; zero or uncertain never counts as positive.
template <typename R>
bool is_positive(const R& x) {
  if constexpr (std::is_same_v<R, Interval>)
    return x.sign() == Sign3::kPositive;
  else
    return x.sign() == Sign::kPositive;
}
template <typename R>
bool is_positive_definite(const Matrix<R>& s) {
  return is_positive(s[0]) && is_positive(R(s[0] * s[4] - s[1] * s[3])) &&
         is_positive(determinant(s));
}
template <typename R>
bool shows_all(const Matrix<R>& k, const std::vector<Matrix<R>>& jacobians) {
  if (!is_positive(determinant(k))) return false;
  return std::all_of(jacobians.begin(), jacobians.end(), [&](const Matrix<R>& j) {
    return is_positive_definite(symmetric_part(product(k, j)));
  });
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

Matrix<double> approx_inverse(const Matrix<double>& m) {
  const double d = 1 / determinant(m);
  Matrix<double> out;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) {
      const std::size_t a = (j + 1) % 3, b = (j + 2) % 3, c = (i + 1) % 3, e = (i + 2) % 3;
      out[3 * i + j] = d * (m[3 * a + c] * m[3 * b + e] - m[3 * a + e] * m[3 * b + c]);
    }
  return out;
}

struct Eigenpair {
  double value = 0;
  std::array<double, 3> vector{};
};
// The least eigenvalue of a symmetric matrix, by Jacobi's rotations.
Eigenpair approx_least_eigenpair(Matrix<double> s) {
  Matrix<double> v = {1, 0, 0, 0, 1, 0, 0, 0, 1};
  for (int sweep = 0; sweep < 8; ++sweep)
    for (const auto& [p, q] : {std::pair{0, 1}, std::pair{0, 2}, std::pair{1, 2}}) {
      const auto a = static_cast<std::size_t>(p), b = static_cast<std::size_t>(q);
      const double off = s[3 * a + b];
      if (off == 0) continue;
      const double theta = (s[3 * b + b] - s[3 * a + a]) / (2 * off);
      const double t = (theta < 0 ? -1 : 1) / (std::abs(theta) + std::sqrt(theta * theta + 1));
      const double c = 1 / std::sqrt(t * t + 1), d = t * c;
      for (std::size_t i = 0; i < 3; ++i) {
        const double x = s[3 * i + a], y = s[3 * i + b];
        s[3 * i + a] = c * x - d * y;
        s[3 * i + b] = d * x + c * y;
      }
      for (std::size_t i = 0; i < 3; ++i) {
        const double x = s[3 * a + i], y = s[3 * b + i];
        s[3 * a + i] = c * x - d * y;
        s[3 * b + i] = d * x + c * y;
        const double f = v[3 * i + a], g = v[3 * i + b];
        v[3 * i + a] = c * f - d * g;
        v[3 * i + b] = d * f + c * g;
      }
    }
  std::size_t least = 0;
  for (std::size_t i = 1; i < 3; ++i)
    if (s[4 * i] < s[4 * least]) least = i;
  return {s[4 * least], {v[least], v[3 + least], v[6 + least]}};
}

// Looks for K with all K J + (K J)^T positive definite, for J whose columns have length 1 on average.
class MatrixSearch {
 public:
  explicit MatrixSearch(std::vector<Matrix<double>> jacobians) : jacobians_(std::move(jacobians)) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      double sum = 0;
      for (const Matrix<double>& j : jacobians_)
        sum += std::sqrt(j[axis] * j[axis] + j[3 + axis] * j[3 + axis] + j[6 + axis] * j[6 + axis]);
      scale_[axis] = static_cast<double>(jacobians_.size()) / sum;
      for (Matrix<double>& j : jacobians_)
        for (std::size_t c = 0; c < 3; ++c) j[3 * c + axis] *= scale_[axis];
    }
  }

  // Integers, for the derivatives as they were. REQUIRES one that is finite and not 0.
  BridgeMatrix rounded(const Matrix<double>& k) const {
    // J' = J D: y . K' J' y = z . (K' scaled by the inverse of D) J z for z = D y.
    Matrix<double> scaled = k;
    double most = 0;
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j) {
        scaled[3 * i + j] /= scale_[i];
        most = std::max(most, std::abs(scaled[3 * i + j]));
      }
    BridgeMatrix out;
    const double factor = std::exp2(24 - std::ceil(std::log2(most)));
    for (std::size_t i = 0; i < 9; ++i)
      out[i] = Rational::from_double(std::nearbyint(scaled[i] * factor));
    return out;
  }

  std::optional<Matrix<double>> start(int power) const {
    Matrix<double> mean{};
    for (const Matrix<double>& j : jacobians_)
      for (std::size_t i = 0; i < 9; ++i) mean[i] += j[i] / static_cast<double>(jacobians_.size());
    Matrix<double> k = approx_inverse(mean);
    for (std::size_t c = 0; c < 3; ++c) k[6 + c] *= std::exp2(2 * power);
    for (const double x : k)
      if (!std::isfinite(x)) return std::nullopt;
    return k;
  }
  // The worst coefficient, and the direction against which K turns it.
  double margin(const Matrix<double>& k, std::size_t* worst, Eigenpair* pair) const {
    double size = 0;
    for (const double x : k) size += x * x;
    double least = HUGE_VAL;
    for (std::size_t i = 0; i < jacobians_.size(); ++i) {
      const Eigenpair found = approx_least_eigenpair(symmetric_part(product(k, jacobians_[i])));
      if (found.value < least) {
        least = found.value;
        *worst = i;
        *pair = found;
      }
    }
    return least / std::sqrt(size);
  }
  // Steps along v (J v)^T, by which v . K J v grows.
  void turn(std::size_t worst, const Eigenpair& pair, Matrix<double>* k) const {
    double size = 0;
    for (const double x : *k) size += x * x;
    const Matrix<double>& j = jacobians_[worst];
    std::array<double, 3> w{};
    double length = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t c = 0; c < 3; ++c) w[i] += j[3 * i + c] * pair.vector[c];
      length += w[i] * w[i];
    }
    if (!(length > 0)) return;
    // To twice the step that makes v . K J v 0, and a bit more.
    const double step = (std::max(0.0, -pair.value) + 0.02 * std::sqrt(size * length)) / length;
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t c = 0; c < 3; ++c) (*k)[3 * i + c] += step * pair.vector[i] * w[c];
  }

 private:
  std::vector<Matrix<double>> jacobians_;
  std::array<double, 3> scale_{};
};

constexpr double kEnoughMargin = 1e-4;
constexpr int kMostTurns = 300;

}  // namespace

bool shows_one_to_one(const BridgeMatrix& matrix, const MicroBridge& bridge) {
  if (shows_by_intervals(matrix, bridge)) return true;
  return shows_all(matrix, jacobian_coefficients<Rational>(bridge, bridge.points));
}

std::optional<BridgeMatrix> find_bridge_matrix(const MicroBridge& bridge) {
  const MatrixSearch search(approx_jacobians(bridge));
  std::size_t worst = 0;
  Eigenpair pair;
  for (const int power : {0, 1, -1, 2, -2}) {
    const auto k = search.start(power);
    if (!k) break;
    if (!(search.margin(*k, &worst, &pair) > kEnoughMargin)) continue;
    const BridgeMatrix out = search.rounded(*k);
    if (shows_one_to_one(out, bridge)) return out;
  }
  auto k = search.start(0);
  for (int turn = 0; k && turn < kMostTurns; ++turn) {
    const double margin = search.margin(*k, &worst, &pair);
    if (!std::isfinite(margin)) break;
    if (margin > kEnoughMargin) {
      const BridgeMatrix out = search.rounded(*k);
      if (shows_one_to_one(out, bridge)) return out;
    }
    search.turn(worst, pair, &*k);
  }
  return std::nullopt;
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
