// SPDX-License-Identifier: LGPL-3.0-or-later
#include "render/scene.h"

#include <cmath>

#include "robust/base/check.h"

namespace veritope {

Box3d box_of(const Scene& scene) {
  Box3d box = empty_box();
  const auto grow = [&box](const Point3d& p) {
    for (const double x : p) VT_CHECK(std::isfinite(x), "a scene has finite coordinates");
    add(p, &box);
  };
  for (const SceneSurface& surface : scene.surfaces)
    for (const auto& triangle : surface.triangles)
      for (const std::uint32_t i : triangle) {
        VT_CHECK(i < surface.points.size(), "a triangle's corners are points of its surface");
        grow(surface.points[i]);
      }
  for (const SceneLine& line : scene.lines)
    for (const Point3d& p : line.points) grow(p);
  for (const SceneMarker& marker : scene.markers) grow(marker.at);
  return box;
}

}  // namespace veritope
