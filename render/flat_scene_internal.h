// SPDX-License-Identifier: LGPL-3.0-or-later
// render/flat_scene_internal.h: a scene as it lies in the picture: shaded triangles, and marks.
#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "render/scene.h"
#include "render/scene_camera_internal.h"

namespace veritope::internal {

/// The share of its colour that a surface with this unit normal shows: to the right, upward, toward the camera.
double light_of(const Point3d& normal);

/// How a triangle faces the camera.
struct FacetView {
  double light = 1;  ///< the share of its colour that is seen
  /// The unit normal toward the camera, in units of 1/127: to the right, upward, toward the camera.
  std::array<std::int8_t, 3> normal = {0, 0, 127};
};
/// REQUIRES corners in the frame of a camera at this distance from the origin.
FacetView facet_view(const std::array<Point3d, 3>& corners, double distance);

struct FlatTriangle {
  std::array<std::uint32_t, 3> corners;  ///< of FlatScene::corners
  Paint paint;                           ///< shaded
  std::array<std::int8_t, 3> normal;     ///< as in FacetView
  std::uint32_t smooth = kNoSmooth;  ///< the shaded colours of its corners, in FlatScene::smooth
  static constexpr std::uint32_t kNoSmooth = 0xffffffff;
};

/// All points within a radius of the segment from a to b, which may be a point.
struct FlatMark {
  PicturePoint a, b;
  double radius = 0;
  Colour colour;
  unsigned layer = 0;
};

/// The width of the rim around a mark, in pixels.
inline constexpr double kRim = 2;

/// Coordinates are in pixels.
struct FlatScene {
  std::vector<PicturePoint> corners;
  std::vector<FlatTriangle> triangles;
  std::vector<FlatMark> marks;  ///< by layer; lines before markers in each
  std::vector<std::array<Colour, 3>> smooth = {};  ///< of the triangles that have them
};

/// The scene as large as it fits into the room, marks with their rims included; in a room that is less than ten times
/// as large as a mark, marks may reach beyond it. REQUIRES something to draw, finite coordinates, ids in range, fewer
/// than 2^32 points, triangles and marks.
FlatScene flatten(const Scene& scene, const Point3d& view, const PictureBox& room);

}  // namespace veritope::internal
