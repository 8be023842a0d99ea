// SPDX-License-Identifier: LGPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "render/parallel_view_internal.h"
#include "robust/base/check.h"

namespace veritope::internal {
namespace {

double along(const Point3d& axis, const Point3d& p) {
  return axis[0] * p[0] + axis[1] * p[1] + axis[2] * p[2];
}

// Half the width of a box's picture along a unit vector.
double half_width(const Point3d& axis, const Point3d& half_sides) {
  double sum = 0;
  for (std::size_t k = 0; k < 3; ++k) sum += std::abs(axis[k]) * half_sides[k];
  return sum;
}

}  // namespace

bool is_viewable(const Box3d& box) {
  if (!is_finite(box)) return false;
  const double longest = extent(box);
  return std::ldexp(1.0, -kLargestViewExponent) <= longest &&
         longest <= std::ldexp(1.0, kLargestViewExponent);
}

ParallelView::ParallelView(const Box3d& box, const Point3d& view, const PictureBox& room)
    : axes_(view_axes(view)), centre_(approx_centre(box)) {
  VT_CHECK(is_viewable(box), "the box of a picture is neither tiny nor huge");
  Point3d half_sides;
  for (std::size_t k = 0; k < 3; ++k) half_sides[k] = 0.5 * (box.hi[k] - box.lo[k]);
  constexpr double kLeastSide = 0x1p-17;  // needles are seen from their ends, too
  least_side_ = kLeastSide * extent(box);
  const double samples = static_cast<double>(kSamples),
               width = 2 * half_width(axes_.right, half_sides),
               height = 2 * half_width(axes_.up, half_sides);
  set_side(std::max(width / (room.width() * samples), height / (room.height() * samples)), room);
}

void ParallelView::set_side(double side, const PictureBox& room) {
  const double samples = static_cast<double>(kSamples);
  side_ = std::max(side, least_side_);
  x_ = 0.5 * (room.left + room.right) * samples;
  y_ = 0.5 * (room.top + room.bottom) * samples;
  for (std::size_t k = 0; k < 3; ++k) step_[k] = axes_.toward[k] * side_;
}

ParallelView ParallelView::fitted(const PictureBox& part, const PictureBox& room) const {
  ParallelView out = *this;
  out.centre_ = to_space({0.5 * (part.left + part.right), 0.5 * (part.top + part.bottom), 0});
  const double samples = static_cast<double>(kSamples);
  out.set_side(side_ * std::max(part.width() / (room.width() * samples),
                                part.height() / (room.height() * samples)),
               room);
  return out;
}

SamplePoint ParallelView::to_picture(const Point3d& p) const {
  Point3d d;
  for (std::size_t k = 0; k < 3; ++k) d[k] = (p[k] - centre_[k]) / side_;
  return {x_ + along(axes_.right, d), y_ - along(axes_.up, d), along(axes_.toward, d)};
}

Point3d ParallelView::to_space(const SamplePoint& p) const {
  Point3d out;
  const double right = (p.x - x_) * side_, up = (y_ - p.y) * side_;
  for (std::size_t k = 0; k < 3; ++k)
    out[k] = centre_[k] + (axes_.right[k] * right + axes_.up[k] * up + step_[k] * p.height);
  return out;
}

}  // namespace veritope::internal
