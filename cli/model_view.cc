// SPDX-License-Identifier: LGPL-3.0-or-later
#include "cli/model_view.h"

#include <utility>
#include <vector>

#include "io/base/scan.h"
#include "render/cell_grid.h"
#include "render/png.h"
#include "render/scene_files.h"
#include "render/view_parts.h"
#include "report/text_style.h"

namespace veritope::cli {

using namespace report;
namespace {

// Facets of curved faces are so small in pictures that their shades do not show, unless there are too many.
constexpr double kFinenessOfPixels = 1.0 / 20000;
constexpr std::size_t kManyPoints = std::size_t{1} << 21;
constexpr Colour kSolidView{178, 190, 205};

std::string content_of(const std::vector<ViewPart>& parts) {
  std::uint64_t triangles = 0, lines = 0;
  for (const ViewPart& part : parts)
    triangles += part.triangles.size(), lines += part.net_lines.size();
  std::string out = counted(triangles, "triangle", "triangles");
  if (lines != 0) out += ", " + counted(lines, "line", "lines");
  return out;
}

Result<std::vector<ViewPart>> parts_of_cells(const SplineModel& model, const VolumeLayout& layout,
                                             const VolumeViewOptions& options, ViewKind kind) {
  if (kind != ViewKind::kPng || options.chord) return volume_parts(model, layout, options);
  VolumeViewOptions fine = options;
  fine.fineness = kFinenessOfPixels;
  fine.max_points = kManyPoints;
  Result<std::vector<ViewPart>> parts = volume_parts(model, layout, fine);
  if (parts || parts.error().code != Code::kOverLimit) return parts;
  return volume_parts(model, layout, options);
}

Result<std::string> drawn_cells(std::vector<ViewPart> parts, const PictureOptions& look) {
  const Result<Scene> scene = parts_scene(std::move(parts));
  if (!scene) return scene.error();
  const Result<Image> image = draw_scene(*scene, look);
  if (!image) return image.error();
  return png_bytes(*image);
}

ViewPart part_of_mesh(const TriangleMesh& mesh) {
  ViewPart out;
  out.name = "solid";
  out.colour = kSolidView;
  for (const Vec3d& p : mesh.positions) out.points.push_back({p.x, p.y, p.z});
  out.triangles = mesh.faces;
  return out;
}

ViewFormat view_format(ViewKind kind) {
  return kind == ViewKind::kVtu   ? ViewFormat::kVtu
         : kind == ViewKind::kObj ? ViewFormat::kObj
                                  : ViewFormat::kGltf;
}

Result<std::string> mesh_view(const TriangleMesh& mesh, ViewKind kind) {
  if (kind == ViewKind::kVtu) return vtu_bytes(triangle_grid(mesh));
  const std::vector<ViewPart> parts = {part_of_mesh(mesh)};
  if (kind == ViewKind::kObj) return parts_obj(parts);
  return parts_gltf(parts);
}

}  // namespace

std::optional<ViewKind> view_kind(const std::string& path) {
  const std::size_t dot = path.rfind('.');
  if (dot == path.npos || dot == 0) return std::nullopt;
  const std::string ending = path.substr(dot + 1);
  if (is_word(ending, "png")) return ViewKind::kPng;
  if (is_word(ending, "vtu")) return ViewKind::kVtu;
  if (is_word(ending, "gltf")) return ViewKind::kGltf;
  if (is_word(ending, "obj")) return ViewKind::kObj;
  return std::nullopt;
}

Result<ModelView> view_of_scene(ModelView out, const Scene& scene, ViewKind kind,
                                const PictureOptions& look) {
  Result<std::string> bytes = bad_argument("");
  if (kind == ViewKind::kVtu) {
    bytes = scene_vtu(scene);
  } else if (kind == ViewKind::kGltf) {
    bytes = scene_gltf(scene);
  } else if (Result<Image> image = draw_scene(scene, look); image) {
    bytes = png_bytes(*image);
  } else {
    return image.error();
  }
  if (!bytes) return bytes.error();
  const bool is_empty = scene.surfaces.empty() && scene.lines.empty();
  if (!is_empty) out.box = box_of(scene);
  out.bytes = std::move(*bytes);
  return out;
}

Result<ModelView> view_of_cells(const SplineModel& model, const VolumeViewOptions& options,
                                ViewKind kind, const PictureOptions& look) {
  if (const Status status = check_is_volumes(model); !status) return status.error();
  const Result<VolumeLayout> layout = volume_layout(model, options.explode);
  if (!layout) return layout.error();
  ModelView out;
  out.box = layout->box;
  out.content = counted(model.entities.size(), "cell", "cells");
  if (kind == ViewKind::kVtu) {
    Result<std::string> bytes = volume_vtu(model, *layout, options);
    if (!bytes) return bytes.error();
    out.bytes = std::move(*bytes);
    return out;
  }
  Result<std::vector<ViewPart>> parts = parts_of_cells(model, *layout, options, kind);
  if (!parts) return parts.error();
  if (kind != ViewKind::kPng) out.content += ", " + content_of(*parts);
  Result<std::string> bytes = kind == ViewKind::kPng   ? drawn_cells(std::move(*parts), look)
                              : kind == ViewKind::kObj ? Result<std::string>(parts_obj(*parts))
                                                       : parts_gltf(*parts);
  if (!bytes) return bytes.error();
  out.bytes = std::move(*bytes);
  return out;
}

Result<ModelView> view_of_micro(const Microstructure& micro, const MicroViewOptions& options,
                                ViewKind kind, const PictureOptions& look) {
  Result<std::vector<ViewPart>> parts = micro_parts(micro, options);
  if (!parts) return parts.error();
  std::uint64_t tiles = 0;
  for (const MicroGrid& grid : micro.grids)
    for (const std::uint8_t t : grid.tiles) tiles += t != 0;
  ModelView out;
  out.content = counted(tiles, "tile", "tiles");
  if (micro.num_bridges() != 0)
    out.content += ", " + counted(micro.num_bridges(), "bridge", "bridges");
  if (kind != ViewKind::kPng) out.content += ", " + content_of(*parts);
  if (kind == ViewKind::kObj) {
    out.bytes = parts_obj(*parts);
    return out;
  }
  return view_of_scene(std::move(out), micro_scene(std::move(*parts)), kind, look);
}

Result<ModelView> view_of_curves(const SplineModel& model, const CurveViewOptions& options,
                                 ViewKind kind, const PictureOptions& look) {
  Result<std::vector<ViewPart>> parts = curve_parts(model, options);
  if (!parts) return parts.error();
  const CurveCounts counts = counts_of_curves(model).value();
  ModelView out;
  out.content = counted(counts.curves, "curve", "curves");
  if (counts.sheets != 0) out.content += ", " + counted(counts.sheets, "sheet", "sheets");
  if (counts.bridges != 0) out.content += ", " + counted(counts.bridges, "bridge", "bridges");
  if (kind == ViewKind::kObj) {
    out.bytes = parts_obj(*parts);
    return out;
  }
  return view_of_scene(std::move(out),
                       curve_scene(std::move(*parts), counts.curves + counts.bridges), kind, look);
}

Result<ModelView> view_of_solid(const ModelFile& model, ViewKind kind) {
  ModelView out;
  const auto* const mesh = std::get_if<MeshFile>(&model);
  const auto* const splines = std::get_if<SplineFile>(&model);
  if (mesh == nullptr && splines == nullptr)
    return bad_argument("models of this kind have no files for viewers");
  out.content = mesh != nullptr ? counted(mesh->mesh.faces.size(), "triangle", "triangles")
                                : counted(splines->model.entities.size(), "entity", "entities");
  Result<std::string> bytes = mesh != nullptr ? mesh_view(mesh->mesh, kind)
                                              : view_bytes(splines->model, view_format(kind), {});
  if (!bytes) return bytes.error();
  out.bytes = std::move(*bytes);
  return out;
}

}  // namespace veritope::cli
