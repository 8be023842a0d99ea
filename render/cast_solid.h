// SPDX-License-Identifier: LGPL-3.0-or-later
// render/cast_solid.h: pictures of solids by ray casting, in parallel projection.
#pragma once
#include "render/draw_scene.h"
#include "render/point_grid.h"
#include "render/solid_probe.h"
#include "robust/base/work_share.h"

namespace veritope {

/// The picture of the part of a solid that lies in a box, on white, as large as it fits. Each pixel has a ray, and on
/// it the first point of the solid, to 1/48 of a pixel, by exact answers of the solid alone. Nine samples a pixel
/// have rays of their own, except where the rays of nine pixels find nothing, or what looks smooth. Where the solid
/// goes on outside of the box, the sides of the box show in another tint. Parts that are thinner than a pixel may be
/// missing within some seven pixels in front of others; elsewhere only if the solid has not its own walls
/// (SolidProbe), and only if they are thinner than 1/96 of a pixel.
/// The pixels are the same with every compiler and for every number of threads.
/// @error kBadArgument: see check_picture_options; kEmpty: no ray hits the solid in the box; kOverLimit: the box has
///        coordinates beyond binary64, or a longest side that is not between 2^-900 and 2^900
/// REQUIRES lo < hi along each axis
/// @cost  some ten points for each pixel that shows the solid, a hundred at edges, and the boxes of two to four pixels
///        that its boundary meets
Result<Image> cast_solid(const SolidProbe& solid, const Box3d& bounds,
                         const PictureOptions& options, WorkShare* work = nullptr);

/// The marks of a grid as balls, as large as the grid's box fits. Those farther back are paler. Same pixels as above.
/// @error kBadArgument: see check_picture_options
Result<Image> draw_point_grid(const PointGrid& grid, const PictureOptions& options,
                              WorkShare* work = nullptr);

}  // namespace veritope
