// SPDX-License-Identifier: LGPL-3.0-or-later
// render/dms_xray_picture.h: X-ray pictures of an attribute: each pixel is the share of light that passes the domain
// along a ray, from integrals with proved bounds.
// Source: [HHQ04] eq. 12.  Design: docs/design/0101-pictures-of-simplex-spline-solids.md.
#pragma once
#include <cstddef>
#include <optional>

#include "render/dms_rays.h"

namespace veritope {

struct DmsXrayPicture {
  Image image;
  DmsRayGrid rays;
  double absorption = 1;  ///< what an integral is multiplied with
  double greatest = 0;    ///< of the integrals by length
  double error = 0;       ///< no integral differs from the exact one by more, but for 4 roundings
};

/// Pixel (i, j) has the grey level 255 exp(-K I), rounded, where I is the integral of the component by length along the
/// part of ray (i, j) in the domain. Absorption K: nothing stands for 3 over the greatest integral, so that the darkest
/// pixel shows 5 % of the light, or 1 if no integral is positive.
/// REQUIRES a model without defects (solids/dms/dms_defects.h), component < model.num_components(), 0 < absorption.
/// @error  as rays_of_picture; kNotFinite for coefficients or integrals beyond binary64
/// @cost   as DmsRayWeights::row for each row of pixels
Result<DmsXrayPicture> draw_dms_xray(const DmsModel& model, std::size_t component,
                                     const PictureOptions& look, std::optional<double> absorption);

}  // namespace veritope
