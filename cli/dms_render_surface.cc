// SPDX-License-Identifier: LGPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <variant>

#include "cli/dms_render.h"
#include "cli/dms_verbs.h"
#include "render/dms_surface_scene.h"
#include "report/decimal_text.h"
#include "report/text_style.h"
#include "solids/dms/dms_iso.h"
#include "solids/dms/dms_similarity.h"

namespace veritope::cli {
namespace {

using report::counted;
using report::short_decimal;

std::variant<std::vector<DmsBoundaryPiece>, DmsOpenFace> pieces_of(const DmsModel& model) {
  return boundary_pieces(
      model, TetrahedralComplex(model.tetrahedra, static_cast<std::uint32_t>(model.clouds.size())));
}

// Surfaces are of the geometry's splines: an attribute over a domain of its own has other pieces.
Result<std::size_t> geometry_component(const DmsModel& model, const std::string& attribute) {
  const Result<DmsComponent> found = dms_component(model, attribute);
  if (!found) return found.error();
  if (found->spline != &model)
    return bad_argument("--attribute " + attribute +
                        ": surfaces are not coloured or cut by attributes of the attribute domain; "
                        "xray, volume and slice draw them");
  return found->component;
}

// Puts the bytes of a scene into the view.
Status add_scene(Scene scene, ViewKind kind, const PictureOptions& look, ModelView& view) {
  if (kind != ViewKind::kObj) {
    Result<ModelView> out = view_of_scene(view, scene, kind, look);
    if (!out) return out.error();
    view = std::move(*out);
    return ok_status();
  }
  view.box = box_of(scene);
  std::vector<ViewPart> parts;
  for (SceneSurface& surface : scene.surfaces)
    parts.push_back({surface.name,
                     surface.paints[0].colour,
                     std::move(surface.points),
                     std::move(surface.triangles),
                     {},
                     {}});
  view.bytes = parts_obj(parts);
  return ok_status();
}

std::string triangles_of(const Scene& scene) {
  std::uint64_t count = 0;
  for (const SceneSurface& surface : scene.surfaces) count += surface.triangles.size();
  return counted(count, "triangle", "triangles");
}

Result<DmsDrawing> boundary_of(const DmsModel& model, const DmsRenderOptions& options,
                               ViewKind kind, const PictureOptions& look) {
  DmsDrawing out;
  out.facts.mode = "boundary";
  out.facts.in_solid = !options.in_domain.value_or(false);
  DmsSurfaceOptions how;
  how.in_solid = out.facts.in_solid;
  how.range = options.range;
  if (options.attribute) {
    const Result<std::size_t> component = geometry_component(model, *options.attribute);
    if (!component) return component.error();
    how.component = *component;
  }
  const auto pieces = pieces_of(model);
  if (std::holds_alternative<DmsOpenFace>(pieces)) {
    out.doubt = "a face of the boundary is not cut into parts that no triangle of knots meets";
    return out;
  }
  Result<DmsSurfaceView> drawn = view_of_boundary(std::get<0>(pieces), how);
  if (!drawn) return drawn.error();
  if (how.component) out.facts.range = drawn->range;
  Scene scene;
  scene.surfaces.push_back(std::move(drawn->surface));
  out.view.content = triangles_of(scene);
  if (how.component)
    out.view.content += ", " + *options.attribute + " from " + short_decimal(drawn->range[0]) +
                        " to " + short_decimal(drawn->range[1]);
  if (const Status status = add_scene(std::move(scene), kind, look, out.view); !status)
    return status.error();
  return out;
}

// 1/12 of the diagonal of the domain's box, up to rounding. A power of two brings its sides near 1, so that domains
// beyond binary64 have one, too.
Rational default_width(const DmsModel& model) {
  const DmsPoint& first = model.clouds[model.tetrahedra[0][0]][0];
  DmsPoint low = first, high = first;
  for (const TetrahedronCorners& tetrahedron : model.tetrahedra)
    for (const std::uint32_t vertex : tetrahedron)
      for (std::size_t k = 0; k < 3; ++k) {
        const Rational& x = model.clouds[vertex][0][k];
        low[k] = std::min(low[k], x);
        high[k] = std::max(high[k], x);
      }
  const DmsPoint side = difference(high, low);
  const std::int64_t exponent = exponent_of(std::max({side[0], side[1], side[2]}));
  std::array<double, 3> near;
  for (std::size_t k = 0; k < 3; ++k)
    near[k] = nearest_double(Rational::power_of_two(-exponent) * side[k]);
  return Rational::power_of_two(exponent) *
         Rational::from_double(std::hypot(near[0], near[1], near[2]) / 12);
}

Result<DmsIso> iso_of(const DmsModel& model, std::size_t component,
                      const DmsRenderOptions& options) {
  DmsIsoOptions how;
  how.attribute = component - 3;
  how.level = *options.level;
  how.max_cells = 10'000;
  how.keeps_places = true;
  how.within = options.within ? *options.within : default_width(model);
  return find_dms_iso(model, how);
}

// The level set, in front of the boundary, which is transparent.
Result<DmsDrawing> level_of(const DmsModel& model, const DmsRenderOptions& options, ViewKind kind,
                            const PictureOptions& look) {
  constexpr std::uint8_t kFaint = 50;
  const Result<std::size_t> component = geometry_component(model, *options.attribute);
  if (!component) return component.error();
  const Result<DmsIso> iso = iso_of(model, *component, options);
  if (!iso) return iso.error();
  const bool in_solid = !options.in_domain.value_or(false);
  DmsDrawing out;
  out.facts.mode = "iso";
  out.facts.in_solid = in_solid;
  out.facts.certified = iso->certified;
  if (!iso->certified)
    out.doubt = "the topology of the surface is not certified: " +
                counted(iso->num_undecided, "cell is", "cells are") + " in doubt";
  Result<SceneSurface> surface = view_of_iso(model, *component, *iso, in_solid);
  if (!surface) return surface.error();
  Scene scene;
  scene.surfaces.push_back(std::move(*surface));
  out.view.content = triangles_of(scene);
  if (const auto pieces = pieces_of(model); std::holds_alternative<DmsOpenFace>(pieces)) {
    out.view.content += ", without the boundary";
  } else {
    DmsSurfaceOptions how;
    how.in_solid = in_solid;
    how.opacity = kFaint;
    Result<DmsSurfaceView> boundary = view_of_boundary(std::get<0>(pieces), how);
    if (!boundary) return boundary.error();
    scene.surfaces.push_back(std::move(boundary->surface));
  }
  if (const Status status = add_scene(std::move(scene), kind, look, out.view); !status)
    return status.error();
  return out;
}

}  // namespace

Result<DmsDrawing> draw_dms_surface(const DmsModel& model, const DmsRenderOptions& options,
                                    ViewKind kind, const PictureOptions& look) {
  Result<DmsDrawing> out = options.mode == DmsMode::kIso ? level_of(model, options, kind, look)
                                                         : boundary_of(model, options, kind, look);
  if (out && options.attribute) out->facts.attribute = *options.attribute;
  return out;
}

}  // namespace veritope::cli
