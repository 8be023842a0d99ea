// SPDX-License-Identifier: LGPL-3.0-or-later
// render/solid_marks.h: scenes for viewers, which know triangles only: lines become tubes, and points octahedra.
#pragma once
#include <string>
#include <vector>

#include "render/scene.h"

namespace veritope {

/// The radii of tubes and octahedra, relative to the longest side of the scene's box: on a screen on which that side
/// has 1,000 pixels they are 5 and 12 pixels wide.
inline constexpr double kTubeRadius = 1.0 / 400, kOctahedronRadius = 1.0 / 160;

/// A line that is shorter, relative to the same side, is a point.
inline constexpr double kShortLine = 0x1p-20;

/// The longest side of the box of a scene; 1 if that is a point, and at most the greatest binary64.
double approx_scene_size(const Scene& scene);

/// The scene's surfaces as they are, and after them a surface for each colour of its marks, opaque, by the legend; the
/// name is the legend's text, or "marks". Each piece of a line is a closed tube with six sides and pointed ends, or an
/// octahedron of its radius if it is a point, see kShortLine. Coordinates beyond binary64 are moved to its end.
/// @param tube_radius  relative to the longest side of the scene's box
std::vector<SceneSurface> with_solid_marks(Scene scene, double tube_radius = kTubeRadius);

/// The surface without points that no triangle uses, which would spoil boxes.
SceneSurface without_unused_points(SceneSurface surface);

/// The triangles of a surface that have one paint.
struct ScenePart {
  std::string name;  ///< the surface's, and that of the legend's entry with these faces
  Paint paint;
  std::vector<std::array<std::uint32_t, 3>> triangles;
};
/// In the order in which their first triangles are listed. REQUIRES paints as draw_scene does.
std::vector<ScenePart> parts_of(const SceneSurface& surface,
                                const std::vector<LegendEntry>& legend);

}  // namespace veritope
