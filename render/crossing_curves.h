// SPDX-License-Identifier: LGPL-3.0-or-later
// render/crossing_curves.h: the curves in which tessellated surfaces cross, for pictures.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "render/scene.h"

namespace veritope {

struct CrossingCurves {
  std::vector<std::array<Point3d, 2>> segments;
  std::size_t num_pairs = 0;  ///< pairs of surfaces that cross, and surfaces that cross themselves
  bool is_cut = false;        ///< the work was more than allowed: curves may be missing
};

/// How many steps approx_crossings takes at most: triangles that are looked at, and pairs of them that overlap along
/// the first axis. 2^26 take approximately a second.
inline constexpr std::uint64_t kMostCrossingSteps = std::uint64_t{1} << 26;

/// The segments in which triangles of the surfaces cross, approximately: of every two surfaces, and of each with
/// itself. Two surfaces with a common point on their borders are neighbours, and a surface is its own: no segment comes
/// from two of their triangles that have a common corner or both lie on borders, for the tessellations of one common
/// side seem to cross.
/// @param first  the surfaces that are compared first, before the work is cut
/// @cost  O(n log n) for n triangles, and at most `most_steps` steps
CrossingCurves approx_crossings(
    std::span<const SceneSurface> surfaces,
    std::optional<std::pair<std::size_t, std::size_t>> first = std::nullopt,
    std::uint64_t most_steps = kMostCrossingSteps);

}  // namespace veritope
