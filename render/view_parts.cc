// SPDX-License-Identifier: LGPL-3.0-or-later
#include "render/view_parts.h"

#include <algorithm>
#include <utility>

#include "render/gltf_buffer_internal.h"
#include "render/gltf_material_internal.h"
#include "render/solid_marks.h"
#include "render/spline_view_internal.h"

namespace veritope {
namespace {

constexpr Colour kNetsOfGltf{40, 40, 40};
constexpr double kNetTubeRadius = 1.0 / 900;  // relative to the scene
constexpr std::uint8_t kOpacityWithNets = 176;
constexpr std::size_t kMostTubes = 1'000'000;

Box3d box_of_parts(const std::vector<ViewPart>& parts) {
  Box3d out = empty_box();
  for (const ViewPart& part : parts)
    for (const auto* const points : {&part.points, &part.net_points})
      for (const Point3d& p : *points) add(p, &out);
  return out;
}

void append_vertices(const std::vector<Point3d>& points, Colour colour, std::string& out) {
  std::string shades;
  for (const std::uint8_t channel : {colour.red, colour.green, colour.blue}) {
    const std::string digits = std::to_string((channel * 1000 + 127) / 255);
    shades += digits == "1000" ? " 1" : " 0." + std::string(3 - digits.size(), '0') + digits;
  }
  for (const Point3d& p : points) {
    out += 'v';
    for (const double x : p) out += ' ', internal::append_number(out, x);
    out += shades + '\n';
  }
}

template <std::size_t N>
void append_elements(char letter, const std::vector<std::array<std::uint32_t, N>>& elements,
                     std::uint64_t first, std::string& out) {
  for (const auto& element : elements) {
    out += letter;
    for (const std::uint32_t i : element) out += ' ' + std::to_string(first + i);
    out += '\n';
  }
}

// The primitives of a part, whose material has this number.
std::string primitives_of_part(const ViewPart& part, const Point3d& centre, std::size_t material,
                               std::size_t net_material, internal::GltfBuffer& buffer) {
  std::string out;
  const auto add_primitive = [&](std::span<const std::uint32_t> indices,
                                 const std::vector<Point3d>& points, int mode, std::size_t number) {
    const std::size_t accessor = buffer.add_points(points, centre);
    out += (out.empty() ? "" : ",") + buffer.open_primitive(indices, accessor, mode) +
           ",\"material\":" + std::to_string(number) + "}";
  };
  if (!part.triangles.empty())
    add_primitive({part.triangles[0].data(), 3 * part.triangles.size()}, part.points,
                  internal::GltfBuffer::kTriangles, material);
  if (!part.net_lines.empty())
    add_primitive({part.net_lines[0].data(), 2 * part.net_lines.size()}, part.net_points,
                  internal::GltfBuffer::kLines, net_material);
  return out;
}

bool is_shown(const ViewPart& part) { return !part.triangles.empty() || !part.net_lines.empty(); }

}  // namespace

Colour net_colour(Colour colour) {
  const auto darker = [](std::uint8_t c) { return static_cast<std::uint8_t>(c / 2); };
  return {darker(colour.red), darker(colour.green), darker(colour.blue)};
}

Result<Scene> parts_scene(std::vector<ViewPart> parts) {
  std::size_t lines = 0;
  for (const ViewPart& part : parts) lines += part.net_lines.size();
  if (lines > kMostTubes)
    return Error{Code::kOverLimit, {}, "the control nets have more than 1000000 lines"};
  Scene out;
  for (ViewPart& part : parts) {
    for (const auto& [a, b] : part.net_lines)
      out.lines.push_back({{part.net_points[a], part.net_points[b]}, net_colour(part.colour)});
    const Paint paint{part.colour, part.net_lines.empty() ? std::uint8_t{255} : kOpacityWithNets};
    out.surfaces.push_back({std::move(part.points), std::move(part.triangles), {paint}, part.name});
  }
  out.surfaces = with_solid_marks(std::move(out), kNetTubeRadius);
  out.lines.clear();
  return out;
}

std::string parts_obj(const std::vector<ViewPart>& parts) {
  std::string out;
  std::uint64_t first = 1;
  for (const ViewPart& part : parts) {
    std::string name;
    for (const char c : part.name) name += c <= ' ' || c > '~' || c == '\\' ? '_' : c;
    out += "g " + name + "\n";
    append_vertices(part.points, part.colour, out);
    append_vertices(part.net_points, net_colour(part.colour), out);
    append_elements('f', part.triangles, first, out);
    append_elements('l', part.net_lines, first + part.points.size(), out);
    first += part.points.size() + part.net_points.size();
  }
  return out;
}

Result<std::string> parts_gltf(const std::vector<ViewPart>& parts) {
  const std::size_t count =
      static_cast<std::size_t>(std::count_if(parts.begin(), parts.end(), is_shown));
  if (count == 0) return Error{Code::kEmpty, {}, "there is nothing to draw"};
  const Box3d box = box_of_parts(parts);
  if (const Status status = internal::check_gltf_size(box); !status) return status.error();
  const Point3d centre = approx_centre(box);
  internal::GltfBuffer buffer;
  std::string nodes, meshes, materials, children, translation;
  std::size_t i = 0;
  bool has_nets = false;
  for (const ViewPart& part : parts) {
    if (!is_shown(part)) continue;
    has_nets = has_nets || !part.net_lines.empty();
    const std::string comma = i == 0 ? "" : ",\n";
    meshes +=
        comma + "{\"primitives\":[" + primitives_of_part(part, centre, i, count, buffer) + "]}";
    materials += comma + internal::gltf_material(part.name, {part.colour});
    nodes +=
        ",\n{\"name\":" + internal::gltf_text(part.name) + ",\"mesh\":" + std::to_string(i) + "}";
    children += (i == 0 ? "" : ",") + std::to_string(i + 1);
    ++i;
  }
  if (has_nets) materials += ",\n" + internal::gltf_material("nets", {kNetsOfGltf});
  for (const double x : centre)
    translation += translation.empty() ? "" : ",", internal::append_number(translation, x);
  return "{\"asset\":{\"version\":\"2.0\",\"generator\":\"veritope\"},\n\"scene\":0,\"scenes\":[{"
         "\"nodes\":[0]}],\n\"nodes\":[{\"name\":\"model\",\"translation\":[" +
         translation + "],\"children\":[" + children + "]}" + nodes + "],\n\"materials\":[" +
         materials + "],\n\"meshes\":[" + meshes + "],\n" + buffer.json() + "}\n";
}

}  // namespace veritope
