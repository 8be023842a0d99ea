// SPDX-License-Identifier: LGPL-3.0-or-later
// render/dms_rays.h: the rays and the points of a picture of the domain of a simplex-spline solid, in parallel
// projection. Straight rays are straight in the domain only.
// Design: docs/design/0101-pictures-of-simplex-spline-solids.md.
#pragma once
#include <cstddef>
#include <optional>

#include "render/draw_scene.h"
#include "solids/dms/dms_model.h"
#include "solids/dms/dms_ray_grid.h"

namespace veritope {

/// More pixels are refused in pictures that ask for a value at each of them.
inline constexpr std::size_t kMostDmsPixels = std::size_t{1} << 24;

/// The least box around the tetrahedra of the domain, rounded outward.
Box3d domain_box(const DmsModel& model);

/// vector . x = number
struct DmsSlicePlane {
  DmsPoint vector;
  Rational number;
};

/// Ray (i, j) goes through the centre of pixel (i, j), from before the box to beyond it, along the direction of view;
/// the box fills the picture up to a margin of 1/32.
/// @error kBadArgument as check_picture_options, and for more than kMostDmsPixels; kOverLimit for a box that is not
///        finite, or whose longest side is not between 2^-900 and 2^900
Result<DmsRayGrid> rays_of_picture(const Box3d& box, const PictureOptions& look);

/// The grid whose points origin + i right + j down are those of a plane at the centres of pixels, seen against the
/// plane's vector; `along` is that direction. In a plane across an axis the points lie exactly.
/// @error as rays_of_picture
Result<DmsRayGrid> points_of_picture(const Box3d& box, const DmsSlicePlane& cut,
                                     const PictureOptions& look);

/// The plane through the middle of a box across the direction of view, toward the viewer.
/// @error kOverLimit for a box that is not finite
Result<DmsSlicePlane> middle_cut(const Box3d& box, const Point3d& view);

}  // namespace veritope
