// SPDX-License-Identifier: LGPL-3.0-or-later
// verify/certify/shape_metric.h: lengths in coordinates in which the model is as long as wide, so that choices by
// length do not change with an affine map of the model. Approximate, for searches only.
#pragma once
#include <array>

#include "solids/pieces/piece_forest.h"

namespace veritope {

/// The linear map W under which the control points of all patches have the covariance 1: affine images of a model have
/// images under their maps that differ by rotations only.
class ShapeMetric {
 public:
  /// The identity.
  ShapeMetric() = default;
  /// The identity where the control points lie in one plane, up to rounding.
  /// @cost linear in the number of control points
  explicit ShapeMetric(const PieceForest& forest);

  /// W x.
  Point3d image(const Point3d& x) const;
  /// The normal of the image of a surface with this normal, times a positive number.
  Point3d image_of_normal(const Point3d& n) const;
  /// The row a for which a . x = row . W x.
  Point3d row_of_image(const Point3d& row) const;
  /// |W x|.
  double length(const Point3d& x) const;
  /// 1 for a multiple of a rotation, and more for other maps: at least r / 3 if images of unit vectors have lengths
  /// that differ by a factor r.
  double distortion() const;

 private:
  // W and its inverse, both lower triangular.
  std::array<Point3d, 3> rows_{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}, inverse_ = rows_;
};

}  // namespace veritope
