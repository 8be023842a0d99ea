// SPDX-License-Identifier: LGPL-3.0-or-later
// Scenes of spline models with what is wrong with them.
#include <algorithm>
#include <cmath>
#include <utility>

#include "render/crossing_curves.h"
#include "render/defect_scene.h"
#include "render/rule_colour.h"
#include "render/spline_view.h"
#include "splines/bezier_triangle.h"
#include "splines/de_boor.h"

namespace veritope {
namespace {

// Steps of a line along a side, of which all sides together take a limited number: points are exact first.
constexpr int kMostSteps = 64, kLeastSteps = 4;
constexpr std::size_t kMostStepsInAll = 10'000;
int steps_of_each(std::size_t num_sides) {
  const std::size_t share = kMostStepsInAll / std::max<std::size_t>(num_sides, 1);
  return static_cast<int>(std::clamp<std::size_t>(share, kLeastSteps, kMostSteps));
}

// Points are in front of lines.
constexpr unsigned kLinesLayer = 1;

// Codes have the colours of the rules of meshes that they resemble.
Colour colour_of_code(std::string_view code) {
  if (code == "side-open") return colour_of(MeshRule::kM3);
  if (code == "side-overused") return colour_of(MeshRule::kM4);
  if (code == "side-direction") return colour_of(MeshRule::kM5);
  if (code == "shell-turned") return colour_of(MeshRule::kM9);
  if (code.starts_with("patch-") || code == "singular-line") return colour_of(MeshRule::kM2);
  return colour_of(MeshRule::kM7);
}

std::optional<Point3d> rounded(const Result<std::vector<Rational>>& p) {
  if (!p || p->size() != 3) return std::nullopt;
  const Point3d out = {nearest_double((*p)[0]), nearest_double((*p)[1]), nearest_double((*p)[2])};
  if (!std::isfinite(out[0]) || !std::isfinite(out[1]) || !std::isfinite(out[2]))
    return std::nullopt;
  return out;
}

// The point at the part t between the bounds of a surface's or volume's parameters, which are rounded outward.
template <std::size_t N>
std::optional<Point3d> point_at(const BSpline<Rational, N>& map, const EntityPart& part,
                                const Rational& t) {
  std::array<Rational, N> at;
  for (std::size_t k = 0; k < N; ++k) {
    const Rational begin = map.axis(k).domain_begin(), end = map.axis(k).domain_end();
    const auto [least, greatest] = part.parameters[k];
    const Rational lo = std::isfinite(least) ? Rational::from_double(least) : begin,
                   hi = std::isfinite(greatest) ? Rational::from_double(greatest) : end;
    at[k] = std::clamp(lo + t * (hi - lo), begin, end);
  }
  return rounded(point(map, at));
}
std::optional<Point3d> point_at(const ExactTriangle& triangle, const Barycentric<Rational>& at) {
  std::vector<Rational> values = evaluate(triangle, at);
  if (!triangle.is_rational()) return rounded(std::move(values));
  const Rational weight = values.back();
  values.pop_back();
  for (Rational& v : values) v /= weight;
  return rounded(std::move(values));
}

// Side s of a triangle runs from corner s to corner s + 1.
std::optional<Point3d> point_at(const ExactTriangle& triangle, const EntityPart& part,
                                const Rational& t) {
  Barycentric<Rational> at = {Rational(0), Rational(0), Rational(0)};
  at[*part.side % 3] = Rational(1) - t;
  at[(*part.side + 1) % 3] = t;
  return point_at(triangle, at);
}

template <typename Shape>
void add_side(const Shape& shape, const EntityPart& part, int steps, Scene& scene) {
  SceneLine line;
  line.colour = colour_of(MeshRule::kM3), line.layer = kLinesLayer;
  for (int i = 0; i <= steps; ++i)
    if (const auto p = point_at(shape, part, Rational(i) / Rational(steps)))
      line.points.push_back(*p);
  if (!line.points.empty()) scene.lines.push_back(std::move(line));
}

void add_side(const SplineModel& model, const EntityPart& part, int steps, Scene& scene) {
  if (part.entity >= model.entities.size()) return;
  const auto& shape = model.entities[part.entity].shape;
  const auto* const volume = std::get_if<ExactVolume>(&shape);
  if (volume != nullptr && part.face) add_side(*volume, part, steps, scene);
  if (!part.side) return;
  if (const auto* surface = std::get_if<ExactSurface>(&shape))
    add_side(*surface, part, steps, scene);
  if (const auto* triangle = std::get_if<ExactTriangle>(&shape))
    add_side(*triangle, part, steps, scene);
}

// The middle of a part of a surface, a volume or a triangle.
std::optional<Point3d> middle_of(const SplineModel& model, const EntityPart& part) {
  if (part.entity >= model.entities.size()) return std::nullopt;
  const auto& shape = model.entities[part.entity].shape;
  if (const auto* surface = std::get_if<ExactSurface>(&shape);
      surface && part.parameters.size() == 2)
    return point_at(*surface, part, Rational(1) / Rational(2));
  if (const auto* volume = std::get_if<ExactVolume>(&shape); volume && part.parameters.size() == 3)
    return point_at(*volume, part, Rational(1) / Rational(2));
  const auto* const triangle = std::get_if<ExactTriangle>(&shape);
  if (triangle == nullptr) return std::nullopt;
  const Rational third = Rational(1) / Rational(3);
  return point_at(*triangle, {third, third, third});
}

// Where the finding is, as far as it says so.
std::optional<Point3d> place_of(const SplineModel& model, const Finding& f) {
  if (f.place.near) return f.place.near;
  if (f.place.box) return approx_centre(*f.place.box);
  return f.place.parts.empty() ? std::nullopt : middle_of(model, f.place.parts.front());
}

void add_to_legend(const std::string& code, Scene& scene) {
  const auto is_it = [&](const LegendEntry& e) { return e.text == code; };
  if (std::none_of(scene.legend.begin(), scene.legend.end(), is_it))
    scene.legend.push_back({colour_of_code(code), code, tinted_paint(colour_of_code(code))});
}

// Whether the middle of a part of this face lies in the piece. Without pieces every part does.
bool is_in_piece(const EntityPart& part, const VolumeFace& face) {
  if (!face.piece) return true;
  const auto holds = [&](std::size_t axis, const Rational& lo, const Rational& hi) {
    const auto& [least, greatest] = part.parameters[axis];
    const double middle = least / 2 + greatest / 2;
    return round_down(lo) <= middle && middle <= round_up(hi);
  };
  const auto& along = *face.piece;
  return holds(face.axis, face.at, face.at) && holds(face.axes[0], along[0][0], along[0][1]) &&
         holds(face.axes[1], along[1][0], along[1][1]);
}

// Which surface of the scene a part lies on: those of entities, or of the boundary faces that are shown in their place.
std::optional<std::size_t> surface_of(const EntityPart& part, const BoundaryFaces* shown,
                                      const Scene& scene) {
  if (shown == nullptr) {
    if (part.entity < scene.surfaces.size()) return part.entity;
    return std::nullopt;
  }
  for (std::size_t i = 0; i < shown->faces.size() && part.face; ++i)
    if (const VolumeFace& face = shown->faces[i]; face.volume == part.entity &&
                                                  2 * face.axis + face.end == *part.face &&
                                                  is_in_piece(part, face))
      return i;
  return std::nullopt;
}
void tint_entities(const Finding& f, const BoundaryFaces* shown, Scene& scene) {
  for (const EntityPart& part : f.place.parts)
    if (const auto i = surface_of(part, shown, scene))
      scene.surfaces[*i].paints = {tinted_paint(colour_of_code(f.code))};
}
// A certificate proves one crossing. All curves in which the tessellated surfaces cross are drawn, first those of the
// surfaces that it names. The legend counts the pairs if there are several, and says if curves are left out.
void add_crossings(const Finding& f, const BoundaryFaces* shown, Scene& scene) {
  std::optional<std::pair<std::size_t, std::size_t>> first;
  if (f.place.parts.size() == 2) {
    const auto a = surface_of(f.place.parts[0], shown, scene),
               b = surface_of(f.place.parts[1], shown, scene);
    if (a && b) first = {*a, *b};
  }
  const CrossingCurves curves = approx_crossings(scene.surfaces, first);
  for (const auto& [from, to] : curves.segments)
    scene.lines.push_back({{from, to}, colour_of_code(f.code), SceneLine().width, kLinesLayer});
  const auto entry = std::find_if(scene.legend.begin(), scene.legend.end(),
                                  [&](const LegendEntry& e) { return e.text == f.code; });
  if (entry == scene.legend.end()) return;
  std::string& text = entry->text;
  if (curves.num_pairs > 1)
    text += " (approximate curves of " + std::to_string(curves.num_pairs) + " pairs of surfaces)";
  if (curves.is_cut) text += " (some curves left out: the surfaces have too many triangles)";
}

std::string name_of(std::size_t surface, const BoundaryFaces* shown) {
  if (shown == nullptr) return "entity " + std::to_string(surface);
  const VolumeFace& face = shown->faces[surface];
  return "entity " + std::to_string(face.volume) + ", face " +
         std::to_string(2 * face.axis + face.end);
}

}  // namespace

Result<Scene> defect_scene(const SplineModel& model, std::span<const Finding> findings,
                           std::span<const EntityPart> open_sides, std::uint64_t num_open_sides,
                           const BoundaryFaces* shown) {
  Result<std::vector<Tessellation>> pieces =
      tessellate(shown != nullptr ? shown->model : model, {});
  if (!pieces) return pieces.error();
  Scene out;
  const bool is_sound = findings.empty() && open_sides.empty();
  for (std::size_t i = 0; i < pieces->size(); ++i) {
    Tessellation& piece = (*pieces)[i];
    out.surfaces.push_back({std::move(piece.points),
                            std::move(piece.triangles),
                            {model_paint(is_sound)},
                            name_of(i, shown)});
  }
  for (const EntityPart& side : open_sides)
    add_side(model, side, steps_of_each(open_sides.size()), out);
  for (const Finding& f : findings) {
    const std::optional<Point3d> at = place_of(model, f);
    if (!at || !std::isfinite((*at)[0]) || !std::isfinite((*at)[1]) || !std::isfinite((*at)[2]))
      continue;
    out.markers.push_back({*at, colour_of_code(f.code), SceneMarker().radius,
                           kLinesLayer + 1 + static_cast<unsigned>(out.legend.size())});
    if (f.code == "side-open") continue;
    add_to_legend(f.code, out);
    tint_entities(f, shown, out);
  }
  const auto crossing = std::find_if(findings.begin(), findings.end(),
                                     [](const Finding& f) { return f.code == "patches-crossing"; });
  if (crossing != findings.end()) add_crossings(*crossing, shown, out);
  if (num_open_sides != 0)
    out.legend.push_back(
        {colour_of(MeshRule::kM3), "side-open (" + std::to_string(num_open_sides) + ")"});
  return out;
}

}  // namespace veritope
