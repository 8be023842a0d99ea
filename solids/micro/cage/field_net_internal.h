// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/micro/cage/field_net_internal.h: the net of a cage that is fitted, in doubles. Nothing here decides anything.
#pragma once
#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "robust/base/box3d.h"
#include "solids/micro/cage/box_cage.h"
#include "splines/grid.h"

namespace veritope::internal {

using Parameters3 = std::array<double, 3>;

inline double dot(const Point3d& a, const Point3d& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
inline Point3d cross(const Point3d& a, const Point3d& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
inline void add_times(Point3d& to, double factor, const Point3d& x) {
  for (std::size_t k = 0; k < 3; ++k) to[k] += factor * x[k];
}

/// The B-splines of one axis that do not vanish in a span, and their derivatives.
struct AxisWeights {
  std::size_t first = 0, count = 0;  ///< control points
  std::array<std::array<double, kMaxFitDegree + 1>, 3>
      of{};  ///< values, first and second derivatives
};

/// The knots of cage_axis: 0, 1, ..., spans. Outside of the domain the polynomials of the first and last spans go on.
class FieldAxis {
 public:
  FieldAxis(int degree, std::size_t spans) : degree_(degree), spans_(spans) {}
  std::size_t num_control() const { return spans_ + static_cast<std::size_t>(degree_); }
  std::size_t spans() const { return spans_; }
  int degree() const { return degree_; }
  double knot(std::size_t i) const;
  std::vector<double> greville() const;
  AxisWeights weights(double at) const;

 private:
  int degree_;
  std::size_t spans_;
};

/// A map at a point: derivatives along u, v, w, and their derivatives along w.
struct FieldJet {
  Point3d point{};
  std::array<Point3d, 3> along{}, along_w{};
  double det() const { return dot(along[0], cross(along[1], along[2])); }
};

struct FieldNet {
  explicit FieldNet(const CageGrid& grid);

  std::array<FieldAxis, 3> axes;
  Grid<3> grid;
  std::vector<Point3d> points;

  std::array<AxisWeights, 3> weights(const Parameters3& at) const;
  FieldJet jet(const std::array<AxisWeights, 3>& weights) const;
  /// Newton's iteration for the parameters of p, at most `beyond` spans outside of the domain.
  std::optional<Parameters3> locate(const Point3d& p, const Parameters3& start,
                                    double beyond) const;
  /// Maps the net's points to those of the map on the box low to high of its domain, over the whole domain: the spline
  /// with the same values at the Greville abscissae.
  FieldNet on_box(const Parameters3& low, const Parameters3& high) const;
  /// A cell of these control points times `scale` plus `shift`, exactly.
  CellVolume cell(const CageGrid& grid, const Rational& scale, const CellPoint& shift) const;
};

}  // namespace veritope::internal
