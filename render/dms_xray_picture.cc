// SPDX-License-Identifier: LGPL-3.0-or-later
#include "render/dms_xray_picture.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "render/grey_levels.h"
#include "solids/dms/dms_xray.h"

namespace veritope {

namespace {

// Bounds of cubic rays are often over the tolerance of DmsRayWeights, whose rays would be computed in rationals, some
// thousand times slower. This one is a fraction of a grey level.
constexpr double kTolerance = 0x1p-13;

}  // namespace

Result<DmsXrayPicture> draw_dms_xray(const DmsModel& model, std::size_t component,
                                     const PictureOptions& look, std::optional<double> absorption) {
  const Result<DmsRayGrid> rays = rays_of_picture(domain_box(model), look);
  if (!rays) return rays.error();
  DmsXrayPicture out;
  out.rays = *rays;
  const Point3d& d = rays->along;
  const double length = std::sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
  const std::vector<DmsRaySum> sums = ray_sums(DmsRayWeights(model, *rays, kTolerance),
                                               DmsCoefficients(model, component), look.jobs);
  for (const DmsRaySum& sum : sums) {
    out.greatest = std::max(out.greatest, sum.mean * length);
    out.error = std::max(out.error, sum.bound * length);
  }
  out.absorption = absorption.value_or(out.greatest > 0 ? 3 / out.greatest : 1);
  if (!std::isfinite(out.greatest) || !std::isfinite(out.error) || !std::isfinite(out.absorption))
    return Error{Code::kNotFinite, {}, "integrals of the attribute are beyond binary64"};
  const GreyLevels levels;
  out.image = Image(look.width, look.height, Colour{255, 255, 255});
  for (std::size_t i = 0; i < sums.size(); ++i) {
    const std::uint8_t level = levels.level(out.absorption * (sums[i].mean * length));
    out.image.pixels[i] = {level, level, level};
  }
  return out;
}

}  // namespace veritope
