// SPDX-License-Identifier: LGPL-3.0-or-later
// render/micro_view.h: microstructures for pictures and viewers, in the colours of the paper: tiles, tiles with
// bridges, bridges, the cage as lines, the model around them. These are pictures: everything is rounded to binary64,
// and nothing is decided. Source: figures 3 to 7 of [HPE22].
#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "render/view_parts.h"
#include "robust/base/result.h"
#include "solids/micro/microstructure.h"
#include "solids/polyhedron/triangle_mesh.h"

namespace veritope {

inline constexpr Colour kTileColour{86, 160, 84}, kBridgeColour{58, 108, 190},
    kAroundColour{150, 155, 165};
inline constexpr std::uint8_t kAroundOpacity = 60;

struct MicroViewOptions {
  /// Patches of degree 1 in both parameters have half as many parts along each side as others, which have from 2 to
  /// this, as many as max_triangles allows.
  std::size_t parts = 8;
  std::size_t max_triangles = std::size_t{1} << 22;
  bool has_cage = false;
  const TriangleMesh* model = nullptr;  ///< drawn transparent
};

/// The parts "tiles", "bridged_tiles", "bridges" and "model", as far as they have triangles, and "cage", which has
/// lines only: the edges of the volumes. Patches between two tiles of one grid, and under bridges, are left out.
/// @error kOverLimit, if even two parts a side need more than max_triangles; as FastSpline::prepare
/// REQUIRES validate(micro).
/// @cost 30 ns for each point of a tricubic cage
Result<std::vector<ViewPart>> micro_parts(const Microstructure& micro,
                                          const MicroViewOptions& options);

/// The part "model": a mesh to be drawn transparent.
ViewPart part_around(const TriangleMesh& mesh);

/// The parts as a scene: the model transparent, the cage's lines in front of all.
Scene micro_scene(std::vector<ViewPart> parts);

}  // namespace veritope
