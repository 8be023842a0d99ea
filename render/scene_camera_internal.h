// SPDX-License-Identifier: LGPL-3.0-or-later
// render/scene_camera_internal.h: from points of space to points of a picture. Only +, -, *, /, square roots and powers
// of two are used, so that every compiler gets the same bits.
#pragma once
#include <cstdint>

#include "robust/base/box3d.h"

namespace veritope::internal {

/// The largest depth. Depths are rounded to integers before they are compared: what coincides up to the rounding errors
/// of binary64 gets equal ones, and the order in the scene decides.
inline constexpr double kDeepest = 1 << 30;

/// Depth is 0 where the sphere around the scene is nearest to the camera, kDeepest where it is farthest, and linear
/// along straight lines of the picture.
struct PicturePoint {
  double x = 0, y = 0, depth = 0;
};

/// A rectangle of a picture; y goes downward.
struct PictureBox {
  double left = 0, top = 0, right = 0, bottom = 0;
  double width() const { return right - left; }
  double height() const { return bottom - top; }
};

/// Unit vectors of a picture: to the right, upward, and toward the camera. The third axis points upward, or the second
/// one in views along the third.
struct ViewAxes {
  Point3d right, up, toward;
};
/// REQUIRES finite view, not 0; of any length.
ViewAxes view_axes(const Point3d& view);

/// A camera on the line through the centre of a box, at four times the radius R of the sphere around the box. Points
/// of the box lie at least 3 R (up to rounding) in front of it, so nothing is ever clipped.
class SceneCamera {
 public:
  /// REQUIRES finite, not empty box; finite view, not 0.
  SceneCamera(const Box3d& box, const Point3d& view);

  /// In units of the box's longest side up to a power of two, with the origin in its centre: to the right, upward, and
  /// toward the camera. Nothing overflows. REQUIRES p in the box.
  Point3d in_frame(const Point3d& p) const;
  /// The components of a direction along the axes of the picture, in proportion. REQUIRES a finite direction.
  Point3d turned(const Point3d& direction) const;
  /// On a plane at distance 1 from the camera. REQUIRES p = in_frame(of a point in the box).
  PicturePoint projected(const Point3d& p) const;
  double distance() const { return 4 * radius_; }

 private:
  double from_low_side(const Point3d& p, std::size_t axis) const;

  Point3d lo_, half_size_{};
  ViewAxes axes_;
  double factor_ = 1;  // 1/2 if the box's longest side is beyond binary64
  int exponent_ = 0;
  double radius_ = 1;
};

/// Moves and scales a picture.
struct PictureFit {
  double scale = 1, x = 0, y = 0;
  PicturePoint operator()(const PicturePoint& p) const {
    return {x + scale * p.x, y - scale * p.y, p.depth};
  }
};
/// Brings what a SceneCamera projects to `bounds` (y upward: top is less than bottom) as large as possible into the
/// middle of `room`, but not over 16 times the size of the sphere around the scene: a line that is seen from its end
/// stays a point.
PictureFit fit_into(const PictureBox& room, const PictureBox& bounds);

}  // namespace veritope::internal
