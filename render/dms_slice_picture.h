// SPDX-License-Identifier: LGPL-3.0-or-later
// render/dms_slice_picture.h: an attribute in a plane through a simplex-spline solid or its domain, by colours.
// Design: docs/design/0101-pictures-of-simplex-spline-solids.md.
#pragma once
#include <array>
#include <cstddef>
#include <optional>

#include "render/dms_field.h"

namespace veritope {

struct DmsSliceOptions {
  std::optional<std::array<double, 2>> range;  ///< the values of the first and the last colour
  std::size_t num_isolines = 0;  ///< dark lines at as many values, which part the range evenly
};

struct DmsSlicePicture {
  Image image;
  DmsRayGrid points;
  double low = 0,
         high =
             0;  ///< the range: the least and the greatest value of a pixel, if none was demanded
};

/// Pixel (i, j) has the colour of the value at point (i, j) of `points` (render/colour_map.h), or is white where
/// nothing has a value. A pixel is dark if an isoline parts it from the pixel on its right or below.
/// REQUIRES a model without defects (solids/dms/dms_defects.h), a vector of the cut other than 0, low < high in the
/// range.
/// @error  as points_of_picture and DmsField::check; kEmpty if no point of a pixel has a value; kNotFinite for values
/// beyond binary64
Result<DmsSlicePicture> draw_dms_slice(const DmsField& field, const DmsSlicePlane& cut,
                                       const PictureOptions& look, const DmsSliceOptions& options);

}  // namespace veritope
