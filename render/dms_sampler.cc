// SPDX-License-Identifier: LGPL-3.0-or-later
#include "render/dms_sampler_internal.h"

#include <cmath>
#include <limits>

#include "robust/base/check.h"

namespace veritope {

Status DmsField::check() const {
  for (std::size_t c = 0; c < spline->num_control(); ++c)
    if (!std::isfinite(nearest_double(spline->value(c)[component])))
      return Error{Code::kNotFinite, {}, "values of the attribute are beyond binary64"};
  return ok_status();
}

namespace internal {
namespace {

FastDmsOptions options_of(std::size_t sharers) {
  constexpr std::size_t kAll = std::size_t{1} << 28, kLeast = std::size_t{1} << 24;
  FastDmsOptions out;
  out.exact_first = 0;  // so that values do not depend on the points before
  out.max_bytes = std::max(kAll / std::max<std::size_t>(sharers, 1), kLeast);
  return out;
}

}  // namespace

DmsSampler::DmsSampler(const DmsField& field, std::size_t sharers) : field_(field) {
  VT_CHECK(field.component < field.spline->num_components(), "a component of the spline");
  if (field.solid == nullptr || !field.solid->has_component())
    fast_.emplace(*field.spline, options_of(sharers));
}

std::span<const double> DmsSampler::values(std::span<const Vec3d> points) {
  values_.assign(points.size(), std::numeric_limits<double>::quiet_NaN());
  if (field_.solid == nullptr)
    evaluate(points, {});
  else
    evaluate_in_solid(points);
  return values_;
}

// The value at point k becomes that of number to[k], or k if `to` is empty.
void DmsSampler::evaluate(std::span<const Vec3d> points, std::span<const std::size_t> to) {
  const std::size_t stride = field_.spline->num_components();
  all_.resize(points.size() * stride);
  FastDmsOutput out;
  out.value = all_.data();
  fast_->evaluate(points, out);
  for (std::size_t k = 0; k < points.size(); ++k)
    values_[to.empty() ? k : to[k]] = all_[k * stride + field_.component];
}

// Preimages on the boundary may be outside of the domain by rounding; they move toward the inside of their cell first.
void DmsSampler::evaluate_in_solid(std::span<const Vec3d> points) {
  constexpr double kInward = 0x1p-20;
  const DmsInverse& solid = *field_.solid;
  std::vector<Vec3d> preimages;
  std::vector<std::size_t> of;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto place = solid.find({points[i].x, points[i].y, points[i].z});
    if (!place) continue;
    if (solid.has_component()) {
      values_[i] = solid.value(*place);
      continue;
    }
    const Point3d u = solid.domain_point(*place, kInward);
    preimages.push_back({u[0], u[1], u[2]});
    of.push_back(i);
  }
  if (!of.empty()) evaluate(preimages, of);
}

Vec3d point_of(const DmsRayGrid& grid, double i, double j, double t) {
  Point3d p;
  for (std::size_t k = 0; k < 3; ++k)
    p[k] = grid.origin[k] + (i * grid.right[k] + (j * grid.down[k] + t * grid.along[k]));
  return {p[0], p[1], p[2]};
}

}  // namespace internal
}  // namespace veritope
