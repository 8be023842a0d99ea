// SPDX-License-Identifier: LGPL-3.0-or-later
// render/draw_scene.h: pictures of scenes, in perspective.
#pragma once
#include <cstddef>

#include "render/image.h"
#include "render/scene.h"
#include "robust/base/box3d.h"
#include "robust/base/result.h"

namespace veritope {

struct PictureOptions {
  std::size_t width = 1200, height = 900;  ///< in pixels, from 64 to 8192
  /// Along which the scene is seen; of any length but 0. The third axis points upward, or the second one in views along
  /// the third.
  Point3d view = {-5, 8, -5};
  /// Thin dark lines along the sharp edges of surfaces and where one surface ends in front of another.
  bool has_outlines = true;
  unsigned jobs = 1;  ///< threads; 0: as many as the machine runs at once
};

/// @error kBadArgument: a side, or the view, is outside its range
Status check_picture_options(const PictureOptions& options);

/// The picture of a scene on white, as large as it fits between its title and its legend. Its pixels are the same with
/// every compiler and for every number of threads. Sheets that are farther apart than 10^-8 of the scene's size are
/// drawn in their order.
/// @error kEmpty if there is no triangle, no line and no marker; kBadArgument for options outside their ranges;
///        kOverLimit for 2^32 triangles, points of surfaces or marks, and where triangles and marks cover more than
///        approximately 2^37 samples (nine a pixel), which would take minutes: tens of thousands of triangles that each
///        fill the picture
/// REQUIRES finite coordinates, ids in range, one paint for each triangle or one for all, lines from 1 to 128 pixels
/// wide, markers with radii from 1/2 to 64.
/// @cost O(points + samples) time; memory O(points), and for each thread 8 kB a column of pixels
Result<Image> draw_scene(const Scene& scene, const PictureOptions& options);

}  // namespace veritope
