// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/classify/axis_ray.h: rays along coordinate axes, and what they find.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace veritope {

/// A ray from a point along a coordinate axis.
struct AxisRay {
  std::size_t axis = 0;
  bool is_upward = true;
};

/// A piece that no half-line is known to miss: the point may lie on it.
struct OpenPiece {
  std::uint32_t patch = 0;
  std::array<double, 2> middle{};  ///< parameters
};

/// The winding number of each shell that the ray meets.
using ShellWindings = std::vector<std::pair<std::uint32_t, int>>;

}  // namespace veritope
