// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/micro/bridge/matrix_search_internal.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace veritope::internal {
namespace {

Matrix3<double> approx_inverse(const Matrix3<double>& m) {
  const double d = 1 / determinant(m);
  Matrix3<double> out;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) {
      const std::size_t a = (j + 1) % 3, b = (j + 2) % 3, c = (i + 1) % 3, e = (i + 2) % 3;
      out[3 * i + j] = d * (m[3 * a + c] * m[3 * b + e] - m[3 * a + e] * m[3 * b + c]);
    }
  return out;
}

constexpr double kEnoughMargin = 1e-4;

struct Eigenpair {
  double value = 0;
  std::array<double, 3> vector{};
};
// The least eigenvalue of a symmetric matrix, by Jacobi's rotations.
Eigenpair approx_least_eigenpair(Matrix3<double> s) {
  Matrix3<double> v = {1, 0, 0, 0, 1, 0, 0, 0, 1};
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
  MatrixSearch(std::vector<Matrix3<double>> jacobians, std::size_t scaled_row)
      : jacobians_(std::move(jacobians)), scaled_row_(scaled_row) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      double sum = 0;
      for (const Matrix3<double>& j : jacobians_)
        sum += std::sqrt(j[axis] * j[axis] + j[3 + axis] * j[3 + axis] + j[6 + axis] * j[6 + axis]);
      scale_[axis] = static_cast<double>(jacobians_.size()) / sum;
      for (Matrix3<double>& j : jacobians_)
        for (std::size_t c = 0; c < 3; ++c) j[3 * c + axis] *= scale_[axis];
    }
  }

  // Integers, for the derivatives as they were. REQUIRES one that is finite and not 0.
  Matrix3<Rational> rounded(const Matrix3<double>& k) const {
    // J' = J D: y . K' J' y = z . (K' scaled by the inverse of D) J z for z = D y.
    Matrix3<double> scaled = k;
    double most = 0;
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j) {
        scaled[3 * i + j] /= scale_[i];
        most = std::max(most, std::abs(scaled[3 * i + j]));
      }
    Matrix3<Rational> out;
    const double factor = std::exp2(24 - std::ceil(std::log2(most)));
    for (std::size_t i = 0; i < 9; ++i)
      out[i] = Rational::from_double(std::nearbyint(scaled[i] * factor));
    return out;
  }

  std::optional<Matrix3<double>> start(int power) const {
    Matrix3<double> mean{};
    for (const Matrix3<double>& j : jacobians_)
      for (std::size_t i = 0; i < 9; ++i) mean[i] += j[i] / static_cast<double>(jacobians_.size());
    Matrix3<double> k = approx_inverse(mean);
    for (std::size_t c = 0; c < 3; ++c) k[3 * scaled_row_ + c] *= std::exp2(2 * power);
    for (const double x : k)
      if (!std::isfinite(x)) return std::nullopt;
    return k;
  }
  // Whether all K J + (K J)^T exceed the margin; approximate.
  bool has_margin(const Matrix3<double>& k) const {
    double size = 0;
    for (const double x : k) size += x * x;
    const double least = kEnoughMargin * std::sqrt(size);
    return std::all_of(jacobians_.begin(), jacobians_.end(), [&](const Matrix3<double>& j) {
      Matrix3<double> s = symmetric_part(product(k, j));
      for (std::size_t i = 0; i < 3; ++i) s[4 * i] -= least;
      return s[0] > 0 && s[0] * s[4] - s[1] * s[3] > 0 && determinant(s) > 0;
    });
  }
  // The worst coefficient, and the direction against which K turns it.
  double margin(const Matrix3<double>& k, std::size_t* worst, Eigenpair* pair) const {
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
  void turn(std::size_t worst, const Eigenpair& pair, Matrix3<double>* k) const {
    double size = 0;
    for (const double x : *k) size += x * x;
    const Matrix3<double>& j = jacobians_[worst];
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
  std::vector<Matrix3<double>> jacobians_;
  std::size_t scaled_row_;
  std::array<double, 3> scale_{};
};

}  // namespace

std::optional<Matrix3<Rational>> find_definite_matrix(
    std::vector<Matrix3<double>> jacobians, std::size_t axis, int most_turns,
    const std::function<bool(const Matrix3<Rational>&)>& accepts) {
  const MatrixSearch search(std::move(jacobians), axis);
  std::size_t worst = 0;
  Eigenpair pair;
  for (const int power : {0, 1, -1, 2, -2}) {
    const auto k = search.start(power);
    if (!k) break;
    if (!search.has_margin(*k)) continue;
    const Matrix3<Rational> out = search.rounded(*k);
    if (accepts(out)) return out;
  }
  auto k = search.start(0);
  for (int turn = 0; k && turn < most_turns; ++turn) {
    const double margin = search.margin(*k, &worst, &pair);
    if (!std::isfinite(margin)) break;
    if (margin > kEnoughMargin) {
      const Matrix3<Rational> out = search.rounded(*k);
      if (accepts(out)) return out;
    }
    search.turn(worst, pair, &*k);
  }
  return std::nullopt;
}

}  // namespace veritope::internal
