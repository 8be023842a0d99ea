// SPDX-License-Identifier: LGPL-3.0-or-later
#include "cli/dms_render.h"

#include <utility>

#include "cli/dms_verbs.h"
#include "render/dms_slice_picture.h"
#include "render/dms_volume_picture.h"
#include "render/dms_xray_picture.h"
#include "render/png.h"
#include "report/decimal_text.h"

namespace veritope::cli {
namespace {

report::DmsRays rays_of(const DmsRayGrid& grid) {
  return {grid.origin, grid.right, grid.down, grid.along};
}

Result<DmsDrawing> xray_of(const DmsModel& model, std::size_t component,
                           const DmsRenderOptions& options, const PictureOptions& look) {
  const Result<DmsXrayPicture> picture = draw_dms_xray(model, component, look, options.absorption);
  if (!picture) return picture.error();
  DmsDrawing out;
  out.view.bytes = png_bytes(picture->image);
  out.facts.mode = "xray";
  out.facts.rays = rays_of(picture->rays);
  out.facts.absorption = picture->absorption;
  out.facts.error = picture->error;
  out.view.content = "integrals up to " + report::short_decimal(picture->greatest);
  return out;
}

Result<DmsDrawing> volume_of(const DmsField& field, const DmsRenderOptions& options,
                             const PictureOptions& look) {
  const TransferFunction transfer =
      options.transfer ? TransferFunction(*options.transfer) : default_transfer(field);
  const Result<DmsVolumePicture> picture = draw_dms_volume(field, transfer, look, options.step);
  if (!picture) return picture.error();
  DmsDrawing out;
  out.view.bytes = png_bytes(picture->image);
  out.facts.mode = "volume";
  out.facts.rays = rays_of(picture->rays);
  out.facts.step = picture->step;
  out.view.content = "samples at distances of " + report::short_decimal(picture->step);
  return out;
}

Result<DmsDrawing> slice_of(const DmsField& field, const DmsRenderOptions& options,
                            const PictureOptions& look) {
  const Result<DmsSlicePlane> cut =
      options.plane ? *options.plane : middle_cut(field.box(), look.view);
  if (!cut) return cut.error();
  const Result<DmsSlicePicture> picture =
      draw_dms_slice(field, *cut, look, {options.range, options.isolines.value_or(0)});
  if (!picture) return picture.error();
  DmsDrawing out;
  out.view.bytes = png_bytes(picture->image);
  out.facts.mode = "slice";
  out.facts.rays = rays_of(picture->points);
  out.facts.range = {picture->low, picture->high};
  out.view.content = *options.attribute + " from " + report::short_decimal(picture->low) + " to " +
                     report::short_decimal(picture->high);
  return out;
}

}  // namespace

bool is_in_solid(const DmsRenderOptions& options) {
  const bool is_picture = options.mode == DmsMode::kVolume || options.mode == DmsMode::kSlice;
  return is_picture && !options.in_domain.value_or(true);
}

Result<DmsDrawing> draw_dms(const DmsModel& model, const DmsRenderOptions& options,
                            const PictureOptions& look) {
  const Result<DmsComponent> found = dms_component(model, *options.attribute);
  if (!found) return found.error();
  DmsField field{found->spline, found->component, nullptr};
  std::optional<DmsInverse> inverse;
  if (is_in_solid(options)) {
    DmsInverseOptions how;
    if (found->spline == &model) how.component = found->component;
    how.jobs = look.jobs;
    Result<DmsInverse> made = DmsInverse::make(model, how);
    if (!made) return made.error();
    field.solid = &inverse.emplace(std::move(*made));
  }
  Result<DmsDrawing> out = options.mode == DmsMode::kXray
                               ? xray_of(*field.spline, field.component, options, look)
                           : options.mode == DmsMode::kVolume ? volume_of(field, options, look)
                                                              : slice_of(field, options, look);
  if (!out) return out;
  out->view.box = field.solid != nullptr ? field.box() : domain_box(model);
  out->facts.in_solid = field.solid != nullptr;
  out->facts.attribute = *options.attribute;
  return out;
}

}  // namespace veritope::cli
