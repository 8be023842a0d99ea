// SPDX-License-Identifier: LGPL-3.0-or-later
#include "render/scene_files.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "render/cell_grid.h"
#include "render/coloured_ply.h"
#include "render/scene_files_internal.h"
#include "render/solid_marks.h"

namespace veritope {
namespace internal {

Result<std::vector<SceneSurface>> solid_surfaces(Scene scene) {
  std::vector<SceneSurface> out = with_solid_marks(std::move(scene));
  std::size_t points = 0, triangles = 0;
  for (const SceneSurface& s : out) points += s.points.size(), triangles += s.triangles.size();
  if (triangles == 0) return Error{Code::kEmpty, {}, "there is nothing to draw"};
  if (std::max(points, triangles) >= std::numeric_limits<std::uint32_t>::max())
    return Error{Code::kOverLimit, {}, "a picture has fewer than 2^32 points and triangles"};
  return out;
}

}  // namespace internal

namespace {

std::string text_of(Colour c) {
  return std::to_string(c.red) + " " + std::to_string(c.green) + " " + std::to_string(c.blue);
}

}  // namespace

Result<std::string> scene_ply(Scene scene) {
  std::vector<std::string> comments;
  for (const LegendEntry& entry : scene.legend)
    comments.push_back("colour " + text_of(entry.colour) + ": " + entry.text);
  const auto surfaces = internal::solid_surfaces(std::move(scene));
  if (!surfaces) return surfaces.error();
  TriangleMesh mesh;
  std::vector<Colour> colours;
  for (const SceneSurface& surface : *surfaces) {
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    for (const Point3d& p : surface.points) mesh.positions.push_back({p[0], p[1], p[2]});
    for (const auto& [a, b, c] : surface.triangles)
      mesh.faces.push_back({first + a, first + b, first + c});
    const bool is_plain = surface.paints.size() == 1;
    for (std::size_t t = 0; t < surface.triangles.size(); ++t)
      colours.push_back(surface.paints[is_plain ? 0 : t].colour);
  }
  return coloured_ply(mesh, colours, comments);
}

Result<std::string> scene_vtu(Scene scene) {
  const std::vector<LegendEntry> legend = scene.legend;
  const auto surfaces = internal::solid_surfaces(std::move(scene));
  if (!surfaces) return surfaces.error();
  CellGrid grid;
  grid.kind = CellGrid::Kind::kTriangles;
  grid.texts.first = "parts";
  std::vector<std::int64_t> numbers;
  for (const SceneSurface& whole : *surfaces) {
    const SceneSurface surface = without_unused_points(whole);
    const auto first = static_cast<std::uint32_t>(grid.points.size());
    grid.points.insert(grid.points.end(), surface.points.begin(), surface.points.end());
    for (const ScenePart& part : parts_of(surface, legend)) {
      const auto& [red, green, blue] = part.paint.colour;
      for (const auto& triangle : part.triangles) {
        for (const std::uint32_t i : triangle) grid.corners.push_back(first + i);
        grid.colours.push_back({red, green, blue, part.paint.opacity});
        numbers.push_back(static_cast<std::int64_t>(grid.texts.second.size()));
      }
      grid.texts.second.push_back(part.name);
    }
  }
  grid.values.emplace_back("part", std::move(numbers));
  return vtu_bytes(grid);
}

}  // namespace veritope
