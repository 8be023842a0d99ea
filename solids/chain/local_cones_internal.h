// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/chain/local_cones_internal.h: the associated regular function of seed 001 [GRF03], definition 6, at a point
// where all cells are cones with flat sides.  Internal to solids/chain.
#pragma once
#include <optional>
#include <vector>

#include "solids/classify/point_answer.h"

namespace veritope::internal {

/// What a closed cell is near a point of it: all directions d with n . d >= 0 for these normals. Without normals the
/// point is in the interior.
struct LocalCone {
  int coefficient = 0;
  std::vector<ExactPoint> inner;
};

/// f*: 0 unless the point is in the closure of the interior of { f != 0 }; else the greatest value of f near the point
/// if that is positive, else the least one. The values of f near the point are those on all faces, of any dimension, of
/// the arrangement of the planes through it. Nothing if there are more than kMostPlanes planes.
/// @cost O(p^2 (p + normals)) for p planes
std::optional<int> regular_value(const std::vector<LocalCone>& cones);
inline constexpr std::size_t kMostPlanes = 48;

}  // namespace veritope::internal
