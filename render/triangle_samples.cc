// SPDX-License-Identifier: LGPL-3.0-or-later
#include "render/triangle_samples_internal.h"

#include <cmath>
#include <utility>

namespace veritope::internal {
namespace {

// A sample's side, in the units of rounded corners. Coordinates are less than 2^24 units, products less than 2^50.
constexpr std::int64_t kUnit = 256;

// The first sample whose centre is at x or after it. REQUIRES x >= 0.
std::int64_t first_sample_from(std::int64_t x) { return (x + kUnit / 2 - 1) / kUnit; }

std::int64_t floor_quotient(std::int64_t a, std::int64_t b) { return a / b - (a % b < 0 ? 1 : 0); }

// Keeps the i with step * i + value >= 0.
void keep_not_negative(std::int64_t step, std::int64_t value, SampleRange* range) {
  if (step > 0) {
    range->first = std::max(range->first, -floor_quotient(value, step));
  } else if (step < 0) {
    range->last = std::min(range->last, floor_quotient(value, -step) + 1);
  } else if (value < 0) {
    range->last = range->first;
  }
}

}  // namespace

TriangleSamples::Corner TriangleSamples::rounded(const PicturePoint& p) {
  constexpr auto kScale = static_cast<double>(kUnit * static_cast<std::int64_t>(kSamples));
  return {static_cast<std::int64_t>(p.x * kScale + 0.5),
          static_cast<std::int64_t>(p.y * kScale + 0.5)};
}

TriangleSamples::TriangleSamples(const PicturePoint& a, const PicturePoint& b,
                                 const PicturePoint& c)
    : corners_{rounded(a), rounded(b), rounded(c)} {
  const auto& [p, q, r] = corners_;
  twice_area_ = (q.x - p.x) * (r.y - p.y) - (r.x - p.x) * (q.y - p.y);
  if (twice_area_ >= 0) return;
  twice_area_ = -twice_area_;
  std::swap(corners_[1], corners_[2]);
}

std::int64_t TriangleSamples::area() const { return twice_area_ / (2 * kUnit * kUnit); }

SampleRange TriangleSamples::rows() const {
  const auto [least, most] = std::minmax({corners_[0].y, corners_[1].y, corners_[2].y});
  return {first_sample_from(least), first_sample_from(most + 1)};
}

// A point is on the inner side of the edge from a to b if (b.x - a.x) (y - a.y) - (b.y - a.y) (x - a.x) > 0; y goes
// downward. It belongs to the triangle also if that is 0 and the edge is on the left or horizontal at the top.
SampleRange TriangleSamples::columns(std::int64_t row) const {
  const auto [least, most] = std::minmax({corners_[0].x, corners_[1].x, corners_[2].x});
  SampleRange range{first_sample_from(least), first_sample_from(most + 1)};
  const std::int64_t y = row * kUnit + kUnit / 2;
  for (std::size_t i = 0; i < 3; ++i) {
    const Corner &a = corners_[i], &b = corners_[(i + 1) % 3];
    const std::int64_t dx = b.x - a.x, dy = b.y - a.y;
    const bool has_edge = dy < 0 || (dy == 0 && dx > 0);
    const std::int64_t at_column_0 = dx * (y - a.y) - dy * (kUnit / 2 - a.x);
    keep_not_negative(-dy * kUnit, at_column_0 - (has_edge ? 0 : 1), &range);
  }
  return range;
}

TriangleDepth::TriangleDepth(const PicturePoint& a, const PicturePoint& b, const PicturePoint& c)
    : a_(a),
      least_(std::min({a.depth, b.depth, c.depth})),
      most_(std::max({a.depth, b.depth, c.depth})) {
  // In pixels squared. A thinner triangle has one depth, so that no slope overflows.
  constexpr double kThin = 0x1p-20;
  const double bx = b.x - a.x, by = b.y - a.y, cx = c.x - a.x, cy = c.y - a.y;
  const double area = bx * cy - cx * by, bz = b.depth - a.depth, cz = c.depth - a.depth;
  if (std::abs(area) > kThin) dx_ = (bz * cy - cz * by) / area, dy_ = (cz * bx - bz * cx) / area;
}

}  // namespace veritope::internal
