// SPDX-License-Identifier: LGPL-3.0-or-later
// cli/model_view.h: pictures that need no rays: the cells of V-models, and files of solids for viewers.
#pragma once
#include <optional>
#include <string>

#include "io/model_file.h"
#include "render/curve_view.h"
#include "render/draw_scene.h"
#include "render/micro_view.h"
#include "render/spline_view.h"
#include "render/volume_view.h"

namespace veritope::cli {

/// Nothing: the name does not end in .png, .vtu, .gltf or .obj.
enum class ViewKind { kPng, kVtu, kGltf, kObj };
std::optional<ViewKind> view_kind(const std::string& path);

/// The bytes of a file, and what it shows.
struct ModelView {
  std::string bytes;
  std::string content;  ///< for a line of text: "5 cells, 120 triangles"
  Box3d box{};          ///< around the control points as they are drawn
};

/// @error as check_is_volumes, volume_layout, volume_parts, volume_vtu and draw_scene
Result<ModelView> view_of_cells(const SplineModel& model, const VolumeViewOptions& options,
                                ViewKind kind, const PictureOptions& look);

/// @error as curve_parts, draw_scene and the files for viewers
/// REQUIRES counts_of_curves(model).
Result<ModelView> view_of_curves(const SplineModel& model, const CurveViewOptions& options,
                                 ViewKind kind, const PictureOptions& look);

/// @error as micro_parts, draw_scene and the files for viewers
Result<ModelView> view_of_micro(const Microstructure& micro, const MicroViewOptions& options,
                                ViewKind kind, const PictureOptions& look);

/// The view with the bytes of a scene, and its box. REQUIRES a kind other than kObj.
/// @error as draw_scene and the files for viewers
Result<ModelView> view_of_scene(ModelView view, const Scene& scene, ViewKind kind,
                                const PictureOptions& look);

/// A solid in one colour: a mesh as it is, splines as convert shows them. REQUIRES a kind other than kPng.
/// @error as parts_gltf and view_bytes; kBadArgument for a model that is neither a mesh nor splines
Result<ModelView> view_of_solid(const ModelFile& model, ViewKind kind);

}  // namespace veritope::cli
