// SPDX-License-Identifier: LGPL-3.0-or-later
// render/view_parts.h: parts of a model for viewers, each in one colour: triangles, and thin lines beside them.
#pragma once
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "render/scene.h"
#include "robust/base/result.h"

namespace veritope {

struct ViewPart {
  std::string name;
  Colour colour;
  std::vector<Point3d> points;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<Point3d> net_points;
  std::vector<std::array<std::uint32_t, 2>> net_lines;  ///< of net_points
};

/// The colour of the lines of a part: darker than its triangles.
Colour net_colour(Colour colour);

/// The parts as surfaces of a scene in their order, and after them their lines as tubes. Parts with lines are
/// transparent, so that lines within them show. @error kOverLimit for more than 1,000,000 lines
Result<Scene> parts_scene(std::vector<ViewPart> parts);

/// Wavefront OBJ with one group a part. Vertices have their colours as three more numbers, from 0 to 1, because a
/// second file with materials could not be replaced in one step with the first. A part's lines come after its
/// triangles. Coordinates are the shortest decimals that read back as the same binary64.
std::string parts_obj(const std::vector<ViewPart>& parts);

/// glTF 2.0 with one node, one mesh and one material for each part with triangles or lines; all lines have one more
/// material. Coordinates are binary32, relative to the middle of the parts' box, to which their common node moves them.
/// @error kEmpty if there is nothing to show; kNotFinite for parts that are larger than binary32 or too small for it
Result<std::string> parts_gltf(const std::vector<ViewPart>& parts);

}  // namespace veritope
