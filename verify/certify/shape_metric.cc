// SPDX-License-Identifier: LGPL-3.0-or-later
#include "verify/certify/shape_metric.h"

#include <cmath>

#include "verify/certify/sheet_tangents_internal.h"

namespace veritope {
namespace {

using internal::Matrix3;

// A factor whose square is less than this part of the covariance's is taken for a rounding error.
constexpr double kLeastPart = 0x1p-44;

template <typename Use>
void for_each_point(const PieceForest& forest, Use use) {
  for (std::uint32_t p = 0; p < forest.num_patches(); ++p) {
    const PieceForest::Form& form = forest.form(p);
    const std::size_t n = form.shape.count();
    const auto& net = form.root_control;
    for (std::size_t i = 0; i < n; ++i) {
      const double w = form.is_rational ? net[3 * n + i] : 1;
      use(Point3d{form.origin[0] + net[i] / w, form.origin[1] + net[n + i] / w,
                  form.origin[2] + net[2 * n + i] / w});
    }
  }
}

// The covariance, up to a factor.
Matrix3 covariance(const PieceForest& forest) {
  Point3d middle{};
  double count = 0;
  for_each_point(forest, [&](const Point3d& x) {
    for (std::size_t k = 0; k < 3; ++k) middle[k] += x[k];
    ++count;
  });
  for (double& m : middle) m /= count;
  Matrix3 out{};
  for_each_point(forest, [&](const Point3d& x) {
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t k = 0; k < 3; ++k)
        out[i][k] += (x[i] - middle[i]) * (x[k] - middle[k]) / count;
  });
  return out;
}

// The lower triangular factor L of a = L L^T; false if a is singular, approximately.
bool factor(const Matrix3& a, Matrix3* l) {
  *l = {};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k <= i; ++k) {
      double sum = a[i][k];
      for (std::size_t j = 0; j < k; ++j) sum -= (*l)[i][j] * (*l)[k][j];
      if (i != k) {
        (*l)[i][k] = sum / (*l)[k][k];
      } else {
        if (!(sum > kLeastPart * a[i][i])) return false;
        (*l)[i][i] = std::sqrt(sum);
      }
    }
  return true;
}

}  // namespace

ShapeMetric::ShapeMetric(const PieceForest& forest) {
  Matrix3 l;
  if (!factor(covariance(forest), &l)) return;
  Matrix3 w{};
  for (std::size_t k = 0; k < 3; ++k)
    for (std::size_t i = k; i < 3; ++i) {
      double sum = i == k ? 1 : 0;
      for (std::size_t j = k; j < i; ++j) sum -= l[i][j] * w[j][k];
      w[i][k] = sum / l[i][i];
    }
  rows_ = w, inverse_ = l;
}

Point3d ShapeMetric::image(const Point3d& x) const {
  return {internal::dot(rows_[0], x), internal::dot(rows_[1], x), internal::dot(rows_[2], x)};
}

Point3d ShapeMetric::image_of_normal(const Point3d& n) const {
  Point3d out{};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < 3; ++k) out[k] += inverse_[i][k] * n[i];
  return out;
}

Point3d ShapeMetric::row_of_image(const Point3d& row) const {
  Point3d out{};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < 3; ++k) out[k] += rows_[i][k] * row[i];
  return out;
}

double ShapeMetric::length(const Point3d& x) const { return internal::length_of(image(x)); }

double ShapeMetric::distortion() const {
  double squares = 0, squares_of_inverse = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    squares += internal::dot(rows_[i], rows_[i]);
    squares_of_inverse += internal::dot(inverse_[i], inverse_[i]);
  }
  return std::sqrt(squares * squares_of_inverse) / 3;
}

}  // namespace veritope
