// SPDX-License-Identifier: LGPL-3.0-or-later
// render/parallel_view_internal.h: parallel projection, from space to samples of a picture and back. Only +, -, *, /,
// square roots and powers of two are used, so that every compiler gets the same bits.
#pragma once
#include "render/sample_rows_internal.h"
#include "render/scene_camera_internal.h"

namespace veritope::internal {

/// Columns to the right, rows downward, and height toward the camera, in sides of samples: the centre of the sample at
/// (column, row) is at (column + 1/2, row + 1/2).
struct SamplePoint {
  double x = 0, y = 0, height = 0;
};

/// Boxes whose longest side is beyond 2^kLargest or below 2^-kLargest are refused, so that nothing overflows.
inline constexpr int kLargestViewExponent = 900;
bool is_viewable(const Box3d& box);

class ParallelView {
 public:
  /// The box as large as it fits into a room (in pixels, y downward). REQUIRES is_viewable(box); finite view, not 0;
  /// a room of positive width and height.
  ParallelView(const Box3d& box, const Point3d& view, const PictureBox& room);

  /// This view moved and scaled so that a part of its picture fills the room. The part is given in samples.
  ParallelView fitted(const PictureBox& part, const PictureBox& room) const;

  SamplePoint to_picture(const Point3d& p) const;
  Point3d to_space(const SamplePoint& p) const;
  /// The change of to_space for one unit of height.
  const Point3d& toward() const { return step_; }
  /// The side of a sample in space.
  double sample_side() const { return side_; }

 private:
  void set_side(double side, const PictureBox& room);

  ViewAxes axes_;
  Point3d centre_{}, step_{};
  double least_side_ = 0;
  double x_ = 0, y_ = 0;  ///< where centre_ is in the picture
  double side_ = 1;
};

}  // namespace veritope::internal
