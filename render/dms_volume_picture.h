// SPDX-License-Identifier: LGPL-3.0-or-later
// render/dms_volume_picture.h: volume rendering of an attribute of a simplex-spline solid: ray casting.
// Source: [HHQ04] section 6.1.  Design: docs/design/0101-pictures-of-simplex-spline-solids.md.
#pragma once
#include <cstddef>
#include <optional>

#include "render/dms_field.h"
#include "render/transfer_function.h"

namespace veritope {

struct DmsVolumePicture {
  Image image;
  DmsRayGrid rays;
  double step = 0;  ///< the distance of samples along rays, approximately
};

/// On each ray the attribute is sampled from the viewer on, at distances of about `step` (nothing: 1/200 of the
/// diagonal of the field's box); between samples it counts as linear. Where a sample is in the domain (the solid) and
/// the next one is not, 10 halvings look for its end; what is thinner than a step may be missed. A ray ends where it
/// has lost 999/1000 of its light; behind all is white.
/// REQUIRES a model without defects (solids/dms/dms_defects.h), 0 < step.
/// @error  as rays_of_picture and DmsField::check; kOverLimit for more than 2^16 steps
/// @cost   a value of FastDms, or a preimage, for each sample
Result<DmsVolumePicture> draw_dms_volume(const DmsField& field, const TransferFunction& transfer,
                                         const PictureOptions& look, std::optional<double> step);

/// From the least to the greatest coefficient of the component: the colours of render/colour_map.h, with an extinction
/// from 1 to 24 for the diagonal of the field's box, so that all of it shows, and high values through low ones.
TransferFunction default_transfer(const DmsField& field);

}  // namespace veritope
