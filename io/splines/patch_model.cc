// SPDX-License-Identifier: LGPL-3.0-or-later
#include "io/splines/patch_model.h"

#include <utility>

#include "robust/base/entity_error.h"
#include "solids/patches/patch_complex.h"
#include "solids/patches/patch_sources.h"
#include "splines/bspline_pieces.h"

namespace veritope {
namespace {

// Nothing if the entity lies in space.
std::optional<ForeignEntity> foreign_of(const SplineEntity& entity, std::uint64_t number) {
  const auto* const surface = std::get_if<ExactSurface>(&entity.shape);
  const auto* const triangle = std::get_if<ExactTriangle>(&entity.shape);
  ForeignEntity out{spline_kind_name(entity), {}, entity.place};
  out.place.entity = number;
  if (surface != nullptr) out.dimension = surface->dimension();
  if (triangle != nullptr) out.dimension = triangle->dimension();
  if (out.dimension == 3) return std::nullopt;
  return out;
}

// The model's surfaces in one list, with their numbers in the model.
struct Surfaces {
  std::vector<ExactSurface> maps;
  std::vector<std::uint64_t> numbers;
};
Surfaces surfaces_of(const SplineModel& model) {
  Surfaces out;
  for (std::uint64_t i = 0; i < model.entities.size(); ++i)
    if (const auto* surface = std::get_if<ExactSurface>(&model.entities[i].shape)) {
      out.maps.push_back(*surface);
      out.numbers.push_back(i);
    }
  return out;
}

// The pieces and the triangles in the model's order. REQUIRES that all entities are surfaces or triangles.
Result<PatchSource> in_file_order(const SplineModel& model, SurfacePieces pieces) {
  PatchSource out;
  std::size_t next_surface = 0, next_piece = 0;
  for (std::uint64_t i = 0; i < model.entities.size(); ++i) {
    PatchEntity& entity = out.entities.emplace_back();
    entity.first_patch = out.patches.size();
    if (const auto* triangle = std::get_if<ExactTriangle>(&model.entities[i].shape)) {
      auto patch = make_patch(*triangle, {PatchOrigin::Kind::kTriangle, i, {}});
      if (!patch) return error_at_entity(patch.error().code, i, patch.error().message);
      out.patches.push_back(*std::move(patch));
      entity.num_patches = 1;
      continue;
    }
    entity.breaks = std::move(pieces.breaks[next_surface++]);
    entity.num_patches = (entity.breaks[0].size() - 1) * (entity.breaks[1].size() - 1);
    for (std::size_t k = 0; k < entity.num_patches; ++k)
      out.patches.push_back(std::move(pieces.patches[next_piece++]));
  }
  return out;
}

}  // namespace

SplineModel model_of(std::span<const Patch> patches) {
  SplineModel out;
  out.entities.reserve(patches.size());
  for (const Patch& patch : patches) {
    if (patch.is_triangle()) {
      out.entities.push_back({patch.triangle(), {}, {}, {}});
    } else {
      out.entities.push_back({to_bspline(patch.tensor()), {}, {}, {}});
    }
  }
  return out;
}

std::string to_string(const ForeignEntity& foreign) {
  std::string text = "entity " + std::to_string(*foreign.place.entity) + ", a " + foreign.kind +
                     (foreign.kind == "trimmed" ? " surface" : "");
  if (!foreign.dimension) return text;
  return text + " with " + std::to_string(*foreign.dimension) +
         (*foreign.dimension == 1 ? " coordinate" : " coordinates");
}

Result<PatchSource> patch_source(const SplineModel& model) {
  PatchSource foreign;
  for (std::uint64_t i = 0; i < model.entities.size(); ++i)
    if (auto found = foreign_of(model.entities[i], i)) foreign.foreign.push_back(*std::move(found));
  if (!foreign.foreign.empty()) return foreign;
  const std::string too_many = "over " + std::to_string(kMaxPatches) + " patches";
  if (model.entities.size() > kMaxPatches)
    return error_at_entity(Code::kOverLimit, kMaxPatches, too_many);
  const Surfaces surfaces = surfaces_of(model);
  Result<SurfacePieces> pieces = pieces_of(surfaces.maps, surfaces.numbers);
  if (!pieces) return pieces.error();
  const std::size_t num_triangles = model.entities.size() - surfaces.maps.size();
  if (pieces->patches.size() > kMaxPatches - num_triangles)
    return error_at_entity(Code::kOverLimit, surfaces.numbers.back(),
                           "with the pieces of the surfaces " + too_many);
  return in_file_order(model, *std::move(pieces));
}

}  // namespace veritope
