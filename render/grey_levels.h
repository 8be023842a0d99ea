// SPDX-License-Identifier: LGPL-3.0-or-later
// render/grey_levels.h: how bright light is that passes a body which absorbs it.
// Source: [HHQ04] eq. 12: the intensity exp(-x) of what absorbs x.
#pragma once
#include <array>
#include <cstdint>

namespace veritope {

/// From binary64 numbers to grey levels by comparisons alone, so that every compiler gets the same ones.
class GreyLevels {
 public:
  GreyLevels();
  /// 255 exp(-x), rounded to the nearest integer; within 1e-15 of a place where that jumps, perhaps the level on the
  /// other side of it. 255 for x <= 0. REQUIRES x that is no NaN.
  std::uint8_t level(double x) const;

 private:
  std::array<double, 255> bounds_;  // descending: the level is at most g from bounds_[g] on
};

}  // namespace veritope
