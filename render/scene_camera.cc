// SPDX-License-Identifier: LGPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "render/scene_camera_internal.h"
#include "robust/base/check.h"

namespace veritope::internal {
namespace {

double dot_of(const Point3d& a, const Point3d& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

Point3d cross_of(const Point3d& a, const Point3d& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

// REQUIRES a vector whose longest coordinate is neither tiny nor huge.
Point3d unit_vector(const Point3d& a) {
  const double length = std::sqrt(dot_of(a, a));
  return {a[0] / length, a[1] / length, a[2] / length};
}

// Points against the view, for a view of any length.
Point3d against(const Point3d& view) {
  int exponent = 0;
  std::frexp(std::max({std::abs(view[0]), std::abs(view[1]), std::abs(view[2])}), &exponent);
  return unit_vector({-std::ldexp(view[0], -exponent), -std::ldexp(view[1], -exponent),
                      -std::ldexp(view[2], -exponent)});
}

// The axis that points upward in the picture.
Point3d upward_axis(const Point3d& toward) {
  constexpr double kSteep = 0x1p-40;
  const bool is_vertical = toward[0] * toward[0] + toward[1] * toward[1] < kSteep;
  return is_vertical ? Point3d{0, 1, 0} : Point3d{0, 0, 1};
}

}  // namespace

ViewAxes view_axes(const Point3d& view) {
  const Point3d toward = against(view), right = unit_vector(cross_of(upward_axis(toward), toward));
  return {right, cross_of(toward, right), toward};
}

SceneCamera::SceneCamera(const Box3d& box, const Point3d& view)
    : lo_(box.lo), axes_(view_axes(view)) {
  VT_CHECK(is_finite(box), "a scene has finite coordinates");
  if (!std::isfinite(extent(box))) factor_ = 0.5;
  double longest = 0;
  for (std::size_t k = 0; k < 3; ++k)
    longest = std::max(longest, box.hi[k] * factor_ - box.lo[k] * factor_);
  std::frexp(longest, &exponent_);
  for (std::size_t k = 0; k < 3; ++k) half_size_[k] = 0.5 * from_low_side(box.hi, k);
  if (longest > 0) radius_ = std::sqrt(dot_of(half_size_, half_size_));
}

// The difference is at most the longest side, which factor_ makes finite, and less than 1 after scaling.
double SceneCamera::from_low_side(const Point3d& p, std::size_t axis) const {
  return std::ldexp(p[axis] * factor_ - lo_[axis] * factor_, -exponent_);
}

Point3d SceneCamera::in_frame(const Point3d& p) const {
  Point3d unit;
  for (std::size_t k = 0; k < 3; ++k) unit[k] = from_low_side(p, k) - half_size_[k];
  return {dot_of(unit, axes_.right), dot_of(unit, axes_.up), dot_of(unit, axes_.toward)};
}

Point3d SceneCamera::turned(const Point3d& direction) const {
  return {dot_of(direction, axes_.right), dot_of(direction, axes_.up),
          dot_of(direction, axes_.toward)};
}

// Along a straight line of the picture the inverse of the distance is linear, the distance is not.
PicturePoint SceneCamera::projected(const Point3d& p) const {
  const double inverse = 1 / (distance() - p[2]);
  const double nearest = 1 / (3 * radius_), farthest = 1 / (5 * radius_);
  const double depth = (nearest - inverse) / (nearest - farthest) * kDeepest;
  return {p[0] * inverse, p[1] * inverse, std::clamp(depth, 0.0, kDeepest)};
}

PictureFit fit_into(const PictureBox& room, const PictureBox& bounds) {
  // The sphere of radius R at distance 4 R fills a cone of tangent 1 / sqrt(15).
  const double of_sphere = std::min(room.width(), room.height()) * std::sqrt(15.0) / 2;
  double scale = 16 * of_sphere;
  if (bounds.width() * scale > room.width()) scale = room.width() / bounds.width();
  if (bounds.height() * scale > room.height()) scale = room.height() / bounds.height();
  const double x = 0.5 * (room.left + room.right), y = 0.5 * (room.top + room.bottom);
  return {scale, x - scale * 0.5 * (bounds.left + bounds.right),
          y + scale * 0.5 * (bounds.top + bounds.bottom)};
}

}  // namespace veritope::internal
