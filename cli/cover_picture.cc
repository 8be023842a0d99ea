// SPDX-License-Identifier: LGPL-3.0-or-later
#include "cli/cover_picture.h"

#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "io/formats.h"
#include "io/mesh/write_mesh.h"
#include "render/cell_grid.h"
#include "verify/certify/collar_solids.h"

namespace veritope::cli {
namespace {

constexpr std::array<std::pair<std::string_view, CoverPart>, 4> kParts = {{
    {"boxes", CoverPart::kBoxes},
    {"collar", CoverPart::kCollar},
    {"outer", CoverPart::kOuter},
    {"inner", CoverPart::kInner},
}};

bool is_vtu(const std::string& path) { return path.ends_with(".vtu"); }

// The box in model units, exactly.
Result<Box3d> scaled(const Box3d& box, int scale) {
  Box3d out;
  for (std::size_t k = 0; k < 3; ++k)
    for (const auto end : {&Box3d::lo, &Box3d::hi}) {
      (out.*end)[k] = std::ldexp((box.*end)[k], -scale);
      if (!std::isfinite((out.*end)[k]) || std::ldexp((out.*end)[k], scale) != (box.*end)[k])
        return Error{Code::kNotFinite,
                     {},
                     "a corner of a box is no binary64 number in the units of the model"};
    }
  return out;
}

Result<std::string> mesh_bytes(const TriangleMesh& mesh, const std::string& path) {
  if (is_vtu(path)) return vtu_bytes(triangle_grid(mesh));
  return mesh_to_bytes(
      mesh,
      default_write_options(std::get<MeshFormat>(format_from_path(path, ModelKind::kMesh)->id)));
}

Result<std::string> boxes_bytes(const std::string& path, const PieceForest& forest,
                                const StarCover& cover) {
  std::vector<Box3d> boxes;
  for (const CoverBox& b : cover.boxes) {
    boxes.push_back(forest.in_model(b.star.box));
  }
  if (!is_vtu(path)) return mesh_bytes(box_mesh(boxes), path);
  CellGrid grid;
  for (const Box3d& box : boxes) grid.add_box(box);
  std::vector<std::int64_t> shells(boxes.size());
  for (PieceForest::Id id = 0; id < cover.box_of_node.size(); ++id)
    if (cover.box_of_node[id] != StarCover::kNone)
      shells[cover.box_of_node[id]] = forest.complex().shell(forest.node(id).patch);
  grid.values.emplace_back("shell", std::move(shells));
  return vtu_bytes(grid);
}

Result<std::string> cells_bytes(const PieceForest& forest, const PatchCollar& collar) {
  CellGrid grid;
  std::vector<std::int64_t> levels, shells, shell_of_body(collar.collar.bodies.size());
  for (std::size_t s = 0; s < collar.place.body_of_shell.size(); ++s)
    shell_of_body[collar.place.body_of_shell[s]] = static_cast<std::int64_t>(s);
  for (std::uint32_t i = 0; i < collar.complex.num_cells(); ++i) {
    const OctreeKey key = collar.complex.cells()[i];
    const Result<Box3d> box = scaled(collar.root.box(key), forest.scale());
    if (!box) return box.error();
    grid.add_box(*box);
    levels.push_back(key.level());
    shells.push_back(shell_of_body[collar.collar.boundary.body_of_cell[i]]);
  }
  grid.values.emplace_back("level", std::move(levels));
  grid.values.emplace_back("shell", std::move(shells));
  return vtu_bytes(grid);
}

}  // namespace

std::optional<CoverPart> cover_part_from_name(std::string_view name) {
  for (const auto& part : kParts)
    if (part.first == name) return part.second;
  return std::nullopt;
}

bool is_cover_file(const std::string& path) {
  return is_vtu(path) || format_from_path(path, ModelKind::kMesh) != nullptr;
}

Result<std::string> cover_picture(CoverPart part, const std::string& path,
                                  const PieceForest& forest, const StarCover& cover,
                                  const PatchCollar* collar) {
  if (part == CoverPart::kBoxes) return boxes_bytes(path, forest, cover);
  if (part == CoverPart::kCollar && is_vtu(path)) return cells_bytes(forest, *collar);
  const Result<TriangleMesh> mesh = part == CoverPart::kOuter ? outer_solid(*collar, forest.scale())
                                    : part == CoverPart::kInner
                                        ? inner_solid(*collar, forest.scale())
                                        : collar_solid(*collar, forest.scale());
  if (!mesh) return mesh.error();
  return mesh_bytes(*mesh, path);
}

Result<std::string> surface_boxes_picture(const std::string& path, const SurfaceCover& cover) {
  if (!is_vtu(path)) return mesh_bytes(box_mesh(cover.plain_boxes()), path);
  CellGrid grid;
  std::vector<std::int64_t> kinds, entities;
  for (const SurfaceBox& b : cover.boxes) {
    grid.add_box(b.box);
    kinds.push_back(static_cast<std::int64_t>(b.kind));
    entities.push_back(b.entity);
  }
  grid.values.emplace_back("kind", std::move(kinds));
  grid.values.emplace_back("entity", std::move(entities));
  return vtu_bytes(grid);
}

}  // namespace veritope::cli
