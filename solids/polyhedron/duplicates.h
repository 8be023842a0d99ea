// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/polyhedron/duplicates.h: faces with the same three vertices (rule M2).
#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "topology/surface.h"

namespace veritope {

struct DuplicateFaces {
  std::uint64_t count = 0;                                      ///< faces with the same vertices as an earlier one
  /// (first such face, later one), by the later; at most max_listed
  std::vector<std::pair<std::uint32_t, std::uint32_t>> first;
  /// All faces with the same vertices, ascending: two or more in each group.
  std::vector<std::vector<std::uint32_t>> groups;
};

/// Collapsed faces are left out. @cost O(shells) if no edge has more than two faces, else a sort of the faces.
DuplicateFaces find_duplicate_faces(std::span<const std::array<std::uint32_t, 3>> faces,
                                    const SurfaceTopology& topology, std::size_t max_listed);

}  // namespace veritope
