// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/classify/segment_count_internal.h: how the winding number changes along a segment. Internal to
// solids/classify.
#pragma once
#include "solids/classify/facet_tests_internal.h"
#include "solids/classify/shell_chain_internal.h"

namespace veritope::internal {

/// The change along a segment that crosses facets. A crossing from front to back adds 1, as the back of a facet is the
/// inner side.
struct WindingChange {
  std::int32_t winding = 0;
  ShellPassages shells;

  /// @param from_side  the side on which the segment starts
  void cross(std::uint32_t facet, Sign from_side, const MeshShells* mesh_shells) {
    winding += to_int(from_side);
    if (mesh_shells == nullptr) return;
    // The normals of a shell at odd depth point to its inner side.
    const std::uint32_t shell = mesh_shells->shell_of_face[facet];
    shells.enter(shell,
                 mesh_shells->depth[shell] % 2 == 0 ? to_int(from_side) : -to_int(from_side));
  }
};

}  // namespace veritope::internal
