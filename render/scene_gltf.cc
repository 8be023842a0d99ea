// SPDX-License-Identifier: LGPL-3.0-or-later
#include <utility>

#include "render/gltf_buffer_internal.h"
#include "render/gltf_material_internal.h"
#include "render/scene_files.h"
#include "render/scene_files_internal.h"
#include "render/solid_marks.h"
#include "render/spline_view_internal.h"

namespace veritope {

Result<std::string> scene_gltf(Scene scene) {
  const Box3d box = box_of(scene);
  const std::vector<LegendEntry> legend = scene.legend;
  const auto surfaces = internal::solid_surfaces(std::move(scene));
  if (!surfaces) return surfaces.error();
  if (const Status status = internal::check_gltf_size(box); !status) return status.error();
  const Point3d centre = approx_centre(box);
  internal::GltfBuffer buffer;
  std::string nodes, meshes, materials, children;
  std::size_t count = 0;
  for (const SceneSurface& whole : *surfaces) {
    if (whole.triangles.empty()) continue;
    const SceneSurface surface = without_unused_points(whole);
    const std::size_t points = buffer.add_points(surface.points, centre);
    for (const ScenePart& part : parts_of(surface, legend)) {
      const std::string number = std::to_string(count++), comma = count == 1 ? "" : ",\n";
      meshes += comma + "{\"primitives\":[" +
                buffer.open_primitive({part.triangles[0].data(), 3 * part.triangles.size()}, points,
                                      internal::GltfBuffer::kTriangles) +
                ",\"material\":" + number + "}]}";
      materials += comma + internal::gltf_material(part.name, part.paint);
      nodes += ",\n{\"name\":" + internal::gltf_text(part.name) + ",\"mesh\":" + number + "}";
      children += (count == 1 ? "" : ",") + std::to_string(count);
    }
  }
  std::string translation;
  for (const double x : centre)
    translation += translation.empty() ? "" : ",", internal::append_number(translation, x);
  return "{\"asset\":{\"version\":\"2.0\",\"generator\":\"veritope\"},\n\"scene\":0,\"scenes\":[{"
         "\"nodes\":[0]}],\n\"nodes\":[{\"name\":\"picture\",\"translation\":[" +
         translation + "],\"children\":[" + children + "]}" + nodes + "],\n\"materials\":[" +
         materials + "],\n\"meshes\":[" + meshes + "],\n" + buffer.json() + "}\n";
}

}  // namespace veritope
