// SPDX-License-Identifier: LGPL-3.0-or-later
#include "verify/certify/piece_samples.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "splines/binomial.h"
#include "verify/certify/sheet_tangents_internal.h"

namespace veritope {
namespace {

// The point at (u, v); in a triangle at (1 - u - v, u, v).
class Sampler {
 public:
  Sampler(PieceForest& forest, PieceForest::Id id)
      : form_(forest.form(forest.node(id).patch)), net_(forest.control(id)) {}

  bool is_triangle() const { return form_.shape.is_triangle; }
  Point3d at(double u, double v) const {
    const FormShape& s = form_.shape;
    std::array<double, 4> sum{};
    double total = 0;
    const auto add = [&](std::size_t i, double factor) {
      total += factor;
      for (std::size_t c = 0; c < (form_.is_rational ? 4u : 3u); ++c)
        sum[c] += factor * net_[c * s.count() + i];
    };
    if (s.is_triangle) {
      for (int j = 0; j <= s.p; ++j)
        for (int k = 0; j + k <= s.p; ++k)
          add(triangle_index(j, k), internal::known_binomial<double>(s.p, j) *
                                        internal::known_binomial<double>(s.p - j, k) *
                                        std::pow(u, j) * std::pow(v, k) *
                                        std::pow(std::max(0.0, 1 - u - v), s.p - j - k));
    } else {
      internal::Basis b, c;
      internal::fill_basis(s.p, u, &b), internal::fill_basis(s.q, v, &c);
      const auto rows = static_cast<std::size_t>(s.p + 1),
                 columns = static_cast<std::size_t>(s.q + 1);
      for (std::size_t i = 0; i < rows; ++i)
        for (std::size_t j = 0; j < columns; ++j) add(i * columns + j, b.value[i] * c.value[j]);
    }
    const double w = form_.is_rational ? sum[3] : total;
    return {form_.origin[0] + sum[0] / w, form_.origin[1] + sum[1] / w,
            form_.origin[2] + sum[2] / w};
  }

 private:
  const PieceForest::Form& form_;
  const double* net_;
};

}  // namespace

void append_samples(PieceForest& forest, PieceForest::Id id, std::vector<Point3d>* out) {
  const Sampler sampler(forest, id);
  for (const double u : {0.0, 0.5, 1.0})
    for (const double v : {0.0, 0.5, 1.0})
      if (!sampler.is_triangle() || u + v <= 1) out->push_back(sampler.at(u, v));
}

double approx_bend(PieceForest& forest, PieceForest::Id id, const ShapeMetric& metric) {
  const Point3d n = forest.approx_normal(id);
  const double length = internal::length_of(metric.image_of_normal(n));
  if (!(length > 0)) return std::numeric_limits<double>::infinity();
  const PieceForest::Form& form = forest.form(forest.node(id).patch);
  const std::size_t count = form.shape.count();
  const double* const net = forest.control(id);
  double least = std::numeric_limits<double>::infinity(), most = -least;
  for (std::size_t i = 0; i < count; ++i) {
    double sum = 0;
    for (std::size_t c = 0; c < 3; ++c) sum += n[c] * net[c * count + i];
    const double v = form.is_rational ? sum / net[3 * count + i] : sum;
    least = std::min(least, v), most = std::max(most, v);
  }
  return (most - least) / length;
}

Point3d longest_chord(PieceForest& forest, PieceForest::Id id, const ShapeMetric& metric) {
  const Sampler sampler(forest, id);
  std::vector<Point3d> corners{sampler.at(0, 0), sampler.at(1, 0)};
  if (!sampler.is_triangle()) corners.push_back(sampler.at(1, 1));
  corners.push_back(sampler.at(0, 1));
  Point3d out{};
  double longest = -1;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Point3d &a = corners[i], &b = corners[(i + 1) % corners.size()];
    const Point3d d{b[0] - a[0], b[1] - a[1], b[2] - a[2]};
    const double length = metric.length(d);
    if (length > longest) longest = length, out = d;
  }
  return out;
}

}  // namespace veritope
