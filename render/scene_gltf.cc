// SPDX-License-Identifier: LGPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include "render/gltf_buffer_internal.h"
#include "render/scene_files.h"
#include "render/scene_files_internal.h"
#include "render/solid_marks.h"
#include "render/spline_view_internal.h"

namespace veritope {
namespace {

// The linear intensity of a channel of sRGB [IEC 61966-2-1], which glTF wants. Only +, -, * and / are used, so that
// every compiler gets the same bits: x^2.4 is x^2 times the fifth root of x^2, by Newton's iteration from above.
double linear(std::uint8_t channel) {
  const double c = channel / 255.0;
  if (c <= 0.04045) return c / 12.92;
  const double x = (c + 0.055) / 1.055, square = x * x;
  double root = 1;
  for (int i = 0; i < 60; ++i) root = (4 * root + square / (root * root * root * root)) / 5;
  return square * root;
}

// Four digits are enough for 256 intensities.
void append_share(std::string& out, double share) {
  const std::string digits = std::to_string(static_cast<int>(share * 10000 + 0.5));
  out += digits == "10000" ? "1" : "0." + std::string(4 - digits.size(), '0') + digits;
}

// A JSON string; what would need escapes becomes "_".
std::string quoted(const std::string& name) {
  std::string out = "\"";
  for (const char c : name) out += c < ' ' || c > '~' || c == '"' || c == '\\' ? '_' : c;
  return out + '"';
}

std::string material_of(const ScenePart& part) {
  std::string out = "{\"name\":" + quoted(part.name) + ",\"doubleSided\":true,";
  if (part.paint.opacity != 255) out += "\"alphaMode\":\"BLEND\",";
  out +=
      "\"pbrMetallicRoughness\":{\"metallicFactor\":0,\"roughnessFactor\":1,\"baseColorFactor\":[";
  const auto& [red, green, blue] = part.paint.colour;
  for (const std::uint8_t channel : {red, green, blue})
    append_share(out, linear(channel)), out += ',';
  append_share(out, part.paint.opacity / 255.0);
  return out + "]}}";
}

// Whether all sizes and distances of the scene can be binary32, with the relative accuracy of normal numbers.
Status check_size(const Box3d& box) {
  constexpr double kLeast = 0x1p-100, kMost = 0x1p120;
  const double size = extent(box);
  if (size > kMost)
    return Error{Code::kNotFinite, {}, "the model is too large for binary32, which glTF has"};
  if (size > 0 && size < kLeast)
    return Error{Code::kNotFinite, {}, "the model is too small for binary32, which glTF has"};
  return ok_status();
}

}  // namespace

Result<std::string> scene_gltf(Scene scene) {
  const Box3d box = box_of(scene);
  const std::vector<LegendEntry> legend = scene.legend;
  const auto surfaces = internal::solid_surfaces(std::move(scene));
  if (!surfaces) return surfaces.error();
  if (const Status status = check_size(box); !status) return status.error();
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
      materials += comma + material_of(part);
      nodes += ",\n{\"name\":" + quoted(part.name) + ",\"mesh\":" + number + "}";
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
