// SPDX-License-Identifier: LGPL-3.0-or-later
// topology/face_orientation.h: which faces of closed surfaces must be reversed so that all agree with their neighbours.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "topology/incidence.h"

namespace veritope {

struct FaceOrientation {
  std::vector<bool> is_reversed;             ///< for each face
  std::vector<std::uint32_t> shell_of_face;  ///< numbered as in SurfaceTopology
  std::size_t num_shells = 0;
};

/// An orientation in which the two faces at each edge run along it in opposite directions; the least face of each shell
/// keeps its own. REQUIRES incidence built from the same faces, none with a repeated id, two faces at every edge.
/// @return nothing if a shell is one-sided: it has no such orientation
/// @cost   for each edge the lesser number of faces at its two vertices
std::optional<FaceOrientation> agreeing_orientation(
    std::span<const std::array<std::uint32_t, 3>> faces, const Incidence& incidence);

}  // namespace veritope
