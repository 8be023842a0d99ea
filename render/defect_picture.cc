// SPDX-License-Identifier: LGPL-3.0-or-later
#include "render/defect_picture.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

#include "solids/polyhedron/box_order.h"

namespace veritope {
namespace {

constexpr Colour kModel{190, 190, 190};
// Colours that colour-blind readers can distinguish, too (the palette of Okabe and Ito, and two
// greys).
constexpr std::array<Colour, kNumMeshRules> kColours = {{{0, 0, 0},
                                                         {0, 114, 178},
                                                         {230, 159, 0},
                                                         {86, 180, 233},
                                                         {0, 158, 115},
                                                         {204, 121, 167},
                                                         {213, 94, 0},
                                                         {240, 228, 66},
                                                         {90, 60, 20}}};
constexpr double kMarker = 1.0 / 160;  // relative to the longest side of the model's box

double marker_radius(const TriangleMesh& mesh) {
  const double side = extent(bounding_box_of_faces(mesh, 1));
  return std::isfinite(side) ? side * kMarker : 0;
}

// Adds eight triangles.
void add_octahedron(const Vec3d& centre, double radius, TriangleMesh& mesh) {
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  for (int axis = 0; axis < 3; ++axis)
    for (const double sign : {-1.0, 1.0}) {
      Vec3d p = centre;
      (axis == 0 ? p.x : axis == 1 ? p.y : p.z) += sign * radius;
      mesh.positions.push_back(p);
    }
  for (std::uint32_t corner = 0; corner < 8; ++corner) {
    const std::uint32_t a = first + (corner & 1), b = first + 2 + (corner >> 1 & 1),
                        c = first + 4 + (corner >> 2);
    const bool is_even = std::popcount(corner) % 2 == 0;
    mesh.faces.push_back(is_even ? std::array{a, c, b} : std::array{a, b, c});
  }
}

}  // namespace

Colour colour_of(MeshRule rule) { return kColours[rule_index(rule)]; }

std::string defect_picture(const TriangleMesh& mesh, std::span<const Finding> defects) {
  TriangleMesh picture = mesh;
  std::vector<Colour> colours(mesh.faces.size(), kModel);
  const double radius = marker_radius(mesh);
  for (std::size_t i = defects.size(); i-- > 0;)
    for (const std::uint32_t f : defects[i].place.faces)
      colours[f] = colour_of(rule_of(defects[i]));
  for (const Finding& defect : defects) {
    const auto& at = defect.witness.point->at;
    const Vec3d centre{nearest_double(at[0]), nearest_double(at[1]), nearest_double(at[2])};
    if (!(std::isfinite(centre.x + radius) && std::isfinite(centre.y + radius) &&
          std::isfinite(centre.z + radius)))
      continue;
    add_octahedron(centre, radius, picture);
    colours.resize(picture.faces.size(), colour_of(rule_of(defect)));
  }
  return coloured_ply(picture, colours);
}

}  // namespace veritope
