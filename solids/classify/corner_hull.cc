// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/classify/corner_hull.h"

#include <algorithm>
#include <cmath>

#include "interval/box_geometry.h"

namespace veritope {

using namespace internal;

namespace {

Point3d approx_minus(const Point3d& a, const Point3d& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
double approx_product(const Point3d& a, const Point3d& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

}  // namespace

CornerHull::CornerHull(const std::array<Box3, 4>& corners, const Point3d& excess, const Box3d& box)
    : corners_(corners), excess_(excess), box_(box) {
  for (std::size_t i = 0; i < 4; ++i) approx_[i] = approx_middle(corners_[i]);
  const Point3d a = approx_minus(approx_[3], approx_[0]), b = approx_minus(approx_[2], approx_[1]);
  normal_ = {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

// Whether the greatest value of this hull along the direction is less than the other one's least: guessed, then proved.
bool CornerHull::is_below(const CornerHull& other, const Point3d& d) const {
  if (!std::isfinite(d[0] + d[1] + d[2])) return false;
  double reach = 0, most = -HUGE_VAL, least = HUGE_VAL;
  for (std::size_t c = 0; c < 3; ++c) reach += std::abs(d[c]) * (excess_[c] + other.excess_[c]);
  for (const Point3d& p : approx_) most = std::max(most, approx_product(d, p));
  for (const Point3d& p : other.approx_) least = std::min(least, approx_product(d, p));
  if (!(most + reach < least)) return false;
  const Box3 n{Interval(d[0]), Interval(d[1]), Interval(d[2])};
  Interval excess;
  for (std::size_t c = 0; c < 3; ++c)
    excess += Interval(mag(n[c])) * (Interval(excess_[c]) + Interval(other.excess_[c]));
  double hi = -HUGE_VAL, lo = HUGE_VAL;
  for (const Box3& p : corners_) hi = std::max(hi, dot(n, p).hi());
  for (const Box3& p : other.corners_) lo = std::min(lo, dot(n, p).lo());
  return (Interval(lo) - Interval(hi) - excess).sign() == Sign3::kPositive;
}

bool CornerHull::is_apart(const CornerHull& other) const {
  if (!meets(box_, other.box_)) return true;
  const auto holds = [&](const Point3d& d) {
    return is_below(other, d) || is_below(other, Point3d{-d[0], -d[1], -d[2]});
  };
  return holds(normal_) || holds(other.normal_) ||
         is_below(other, approx_minus(approx_centre(other.box_), approx_centre(box_)));
}

}  // namespace veritope
