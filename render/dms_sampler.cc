// SPDX-License-Identifier: LGPL-3.0-or-later
#include "render/dms_sampler_internal.h"

#include "robust/base/check.h"

namespace veritope::internal {
namespace {

FastDmsOptions options_of(std::size_t sharers) {
  constexpr std::size_t kAll = std::size_t{1} << 28, kLeast = std::size_t{1} << 24;
  FastDmsOptions out;
  out.exact_first = 0;  // so that values do not depend on the points before
  out.max_bytes = std::max(kAll / std::max<std::size_t>(sharers, 1), kLeast);
  return out;
}

}  // namespace

DmsSampler::DmsSampler(const DmsModel& model, std::size_t component, std::size_t sharers)
    : component_(component), stride_(model.num_components()), fast_(model, options_of(sharers)) {
  VT_CHECK(component < stride_, "a component of the model");
}

std::span<const double> DmsSampler::values(std::span<const Vec3d> points) {
  all_.resize(points.size() * stride_);
  FastDmsOutput out;
  out.value = all_.data();
  fast_.evaluate(points, out);
  values_.resize(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) values_[i] = all_[i * stride_ + component_];
  return values_;
}

Vec3d point_of(const DmsRayGrid& grid, double i, double j, double t) {
  Point3d p;
  for (std::size_t k = 0; k < 3; ++k)
    p[k] = grid.origin[k] + (i * grid.right[k] + (j * grid.down[k] + t * grid.along[k]));
  return {p[0], p[1], p[2]};
}

}  // namespace veritope::internal
