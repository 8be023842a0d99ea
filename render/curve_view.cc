// SPDX-License-Identifier: LGPL-3.0-or-later
#include "render/curve_view.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "render/micro_view.h"
#include "render/solid_marks.h"
#include "render/spline_view.h"

namespace veritope {
namespace {

constexpr Colour kSheetColour{226, 186, 60};
constexpr double kCurveFineness = 1.0 / 5000;  // relative to the diagonal

// The radius of tubes, relative to the scene. Where n curves fill a space, neighbours are apart by n^(-1/3) of it.
double tube_radius(std::size_t num_curves) {
  return std::clamp(0.0125 / std::cbrt(static_cast<double>(num_curves)), 1.0 / 800, 1.0 / 150);
}

// REQUIRES positive weights.
template <typename Map>
void add_control_points(const Map& map, Box3d& box) {
  const auto at = [&](int c, std::size_t i) { return nearest_double(map.component(c)[i]); };
  for (std::size_t i = 0; i < map.component(0).size(); ++i) {
    const double w = map.is_rational() ? at(map.num_components() - 1, i) : 1;
    add({at(0, i) / w, at(1, i) / w, at(2, i) / w}, &box);
  }
}
double default_chord(const SplineModel& model) {
  Box3d box = empty_box();
  for (const SplineEntity& entity : model.entities) {
    if (const auto* const curve = std::get_if<ExactCurve>(&entity.shape))
      add_control_points(*curve, box);
    else if (const auto* const surface = std::get_if<ExactSurface>(&entity.shape))
      add_control_points(*surface, box);
    else if (const auto* const triangle = std::get_if<ExactTriangle>(&entity.shape))
      add_control_points(*triangle, box);
  }
  return kCurveFineness *
         std::hypot(box.hi[0] - box.lo[0], box.hi[1] - box.lo[1], box.hi[2] - box.lo[2]);
}

bool is_bridge(const SplineModel& model, const SplineEntity& entity) {
  return entity.group && model.groups[*entity.group].name == "bridges";
}
ViewPart part_of_colour(const char* name, Colour colour) {
  ViewPart out;
  out.name = name, out.colour = colour;
  return out;
}

void add_lines(const Tessellation& from, ViewPart& to) {
  const auto first = static_cast<std::uint32_t>(to.net_points.size());
  to.net_points.insert(to.net_points.end(), from.points.begin(), from.points.end());
  for (const auto& line : from.lines)
    for (std::size_t i = 0; i + 1 < line.size(); ++i)
      to.net_lines.push_back({first + line[i], first + line[i + 1]});
}
void add_triangles(const Tessellation& from, ViewPart& to) {
  const auto first = static_cast<std::uint32_t>(to.points.size());
  to.points.insert(to.points.end(), from.points.begin(), from.points.end());
  for (const auto& t : from.triangles)
    to.triangles.push_back({first + t[0], first + t[1], first + t[2]});
}

}  // namespace

std::optional<CurveCounts> counts_of_curves(const SplineModel& model) {
  CurveCounts out;
  for (const SplineEntity& entity : model.entities) {
    if (const auto* const curve = std::get_if<ExactCurve>(&entity.shape)) {
      if (curve->dimension() < 3) return std::nullopt;
      ++(is_bridge(model, entity) ? out.bridges : out.curves);
    } else if (const auto* const surface = std::get_if<ExactSurface>(&entity.shape)) {
      if (surface->dimension() < 3) return std::nullopt;
      ++out.sheets;
    } else if (const auto* const triangle = std::get_if<ExactTriangle>(&entity.shape)) {
      if (triangle->dimension() < 3) return std::nullopt;
      ++out.sheets;
    } else {
      return std::nullopt;
    }
  }
  return out.curves + out.bridges == 0 ? std::nullopt : std::optional(out);
}

Result<std::vector<ViewPart>> curve_parts(const SplineModel& model,
                                          const CurveViewOptions& options) {
  ViewOptions how;
  how.chord = options.chord ? *options.chord : default_chord(model);
  const Result<std::vector<Tessellation>> made = tessellate(model, how);
  if (!made) return made.error();
  std::vector<ViewPart> out = {part_of_colour("curves", kTileColour),
                               part_of_colour("bridges", kBridgeColour),
                               part_of_colour("sheets", kSheetColour)};
  for (std::size_t i = 0; i < made->size(); ++i) {
    const SplineEntity& entity = model.entities[i];
    if (std::holds_alternative<ExactCurve>(entity.shape))
      add_lines((*made)[i], out[is_bridge(model, entity) ? 1 : 0]);
    else
      add_triangles((*made)[i], out[2]);
  }
  const std::size_t lines = out[0].net_lines.size() + out[1].net_lines.size();
  if (lines > options.max_lines)
    return Error{Code::kOverLimit,
                 {},
                 "the curves have " + std::to_string(lines) + " straight parts, more than " +
                     std::to_string(options.max_lines) + "; a greater --chord may help"};
  std::erase_if(
      out, [](const ViewPart& part) { return part.triangles.empty() && part.net_lines.empty(); });
  if (options.model != nullptr) out.push_back(part_around(*options.model));
  return out;
}

Scene curve_scene(std::vector<ViewPart> parts, std::size_t num_curves) {
  Scene out;
  for (ViewPart& part : parts) {
    for (const auto& [a, b] : part.net_lines)
      out.lines.push_back({{part.net_points[a], part.net_points[b]}, part.colour});
    if (!part.net_lines.empty()) out.legend.push_back({part.colour, part.name});
    if (part.triangles.empty()) continue;
    const bool is_model = part.name == "model";
    out.surfaces.push_back({std::move(part.points),
                            std::move(part.triangles),
                            {Paint{part.colour, is_model ? kAroundOpacity : std::uint8_t{255}}},
                            part.name});
  }
  out.surfaces = with_solid_marks(out, tube_radius(std::max<std::size_t>(1, num_curves)));
  out.lines.clear();
  out.legend.clear();
  return out;
}

}  // namespace veritope
