// SPDX-License-Identifier: LGPL-3.0-or-later
// render/triangle_samples_internal.h: the samples that a triangle covers, and its depth there.
#pragma once
#include <algorithm>
#include <array>
#include <cstdint>

#include "render/sample_rows_internal.h"
#include "render/scene_camera_internal.h"

namespace veritope::internal {

/// Rows, or columns of a row: [first, last).
struct SampleRange {
  std::int64_t first = 0, last = 0;
};

/// The samples whose centres lie in a triangle. Corners are rounded to 1/256 of a sample's side first; all else is
/// exact. A sample on a common edge of two triangles that lie on both sides of it belongs to exactly one of them.
class TriangleSamples {
 public:
  /// REQUIRES 0 <= x, y < 2^14.
  TriangleSamples(const PicturePoint& a, const PicturePoint& b, const PicturePoint& c);

  bool is_flat() const { return twice_area_ == 0; }
  /// All rows that have samples of the triangle, and perhaps others.
  SampleRange rows() const;
  SampleRange columns(std::int64_t row) const;
  /// The approximate number of samples.
  std::int64_t area() const;

 private:
  struct Corner {
    std::int64_t x, y;
  };
  static Corner rounded(const PicturePoint& p);

  std::array<Corner, 3> corners_;
  std::int64_t twice_area_;  // not negative
};

/// The depth of a triangle at the samples, from the corners before they are rounded: in coplanar triangles it differs
/// by rounding errors of binary64 only. Outside of the triangle it stays between the depths of the corners.
class TriangleDepth {
 public:
  TriangleDepth(const PicturePoint& a, const PicturePoint& b, const PicturePoint& c);

  /// For at() in this row.
  double in_row(std::int64_t row) const { return a_.depth + dy_ * (centre(row) - a_.y); }
  double at(double in_row, std::int64_t column) const {
    return std::min(std::max(in_row + dx_ * (centre(column) - a_.x), least_), most_);
  }

 private:
  // In pixels.
  static double centre(std::int64_t sample) {
    return (static_cast<double>(sample) + 0.5) * (1 / static_cast<double>(kSamples));
  }
  PicturePoint a_;
  double least_, most_, dx_ = 0, dy_ = 0;
};

}  // namespace veritope::internal
