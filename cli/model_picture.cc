// SPDX-License-Identifier: LGPL-3.0-or-later
#include "cli/model_picture.h"

#include <map>
#include <sstream>
#include <utility>
#include <vector>

#include "io/base/scan.h"
#include "io/splines/boundary_faces.h"
#include "io/splines/patch_model.h"
#include "io/splines/volume_faces.h"
#include "render/defect_scene.h"
#include "render/draw_scene.h"
#include "render/png.h"
#include "render/scene_files.h"
#include "report/report_text.h"

namespace veritope::cli {

using namespace report;
namespace {

constexpr std::size_t kTitleColumns = 90;  // of 1200 pixels

// The faces that are certified: those of the rule, or the pieces that a copy has.
Result<BoundaryFaces> drawn_faces(const SplineModel& model, bool of_copy) {
  if (!of_copy) return boundary_faces(model);
  Result<VolumeFaces> pieces = volume_faces(model);
  if (!pieces) return pieces.error();
  BoundaryFaces out;
  out.model = model_of(pieces->patches);
  out.faces = std::move(pieces->places);
  return out;
}

// Volumes are drawn by their boundary faces.
bool is_drawn_by_faces(const FileReport& report) {
  const auto* const facts = std::get_if<PatchFacts>(&report.facts);
  return report.boundary_faces || (facts != nullptr && facts->vmodel);
}

Result<Scene> scene_of(const SplineFile& file, const FileReport& report) {
  std::vector<EntityPart> sides;
  std::uint64_t num_sides = 0;
  std::vector<Finding> findings = report.defects;
  if (const auto* facts = std::get_if<PatchFacts>(&report.facts)) {
    for (const OpenSideFacts& side : facts->open_sides) sides.push_back(side.part);
    num_sides = facts->open.sides;
  }
  if (!is_drawn_by_faces(report)) return defect_scene(file.model, findings, sides, num_sides);
  const Result<BoundaryFaces> faces = drawn_faces(file.model, report.copy.has_value());
  if (!faces) return faces.error();
  return defect_scene(file.model, findings, sides, num_sides, &*faces);
}

Result<Scene> scene_of(const ModelFile& model, const FileReport& report) {
  if (const auto* mesh = std::get_if<MeshFile>(&model))
    return defect_scene(mesh->mesh, report.defects,
                        std::get<MeshFacts>(report.facts).decision.rule_counts);
  if (const auto* splines = std::get_if<SplineFile>(&model)) return scene_of(*splines, report);
  return bad_argument("models of this kind have no picture");
}

Result<std::string> drawn(Scene scene, const FileReport& report, unsigned jobs) {
  const std::string& path = report.path;
  scene.title = {harmless(path == "-" ? "standard input" : path.substr(path.rfind('/') + 1))};
  std::istringstream lines(
      fold(std::string(verdict_word(report.verdict)) + "  " + summary_text(report), kTitleColumns));
  for (std::string line; std::getline(lines, line);) scene.title.push_back(line);
  PictureOptions options;
  options.jobs = jobs;
  const Result<Image> image = draw_scene(scene, options);
  if (!image) return image.error();
  return png_bytes(*image);
}

}  // namespace

std::optional<PictureKind> picture_kind(const std::string& path) {
  const std::size_t dot = path.rfind('.');
  if (dot == path.npos) return std::nullopt;
  const std::string ending = path.substr(dot + 1);
  if (is_word(ending, "png")) return PictureKind::kPng;
  if (is_word(ending, "ply")) return PictureKind::kPly;
  if (is_word(ending, "vtu")) return PictureKind::kVtu;
  if (is_word(ending, "gltf")) return PictureKind::kGltf;
  return std::nullopt;
}

bool has_pictures(ModelKind kind) {
  return kind == ModelKind::kMesh || kind == ModelKind::kSplines;
}

Result<std::string> picture_of(const ModelFile& model, const FileReport& report, PictureKind kind,
                               unsigned jobs) {
  Result<Scene> scene = scene_of(model, report);
  if (!scene) return scene.error();
  switch (kind) {
    case PictureKind::kPng: return drawn(std::move(*scene), report, jobs);
    case PictureKind::kPly: return scene_ply(std::move(*scene));
    case PictureKind::kVtu: return scene_vtu(std::move(*scene));
    case PictureKind::kGltf: return scene_gltf(std::move(*scene));
  }
  return bad_argument("no kind of picture");
}

void keep_first(std::size_t most, FileReport& report) {
  std::map<std::string, std::size_t> seen;
  if (std::holds_alternative<MeshFacts>(report.facts))
    std::erase_if(report.defects, [&](const Finding& f) { return seen[f.code]++ >= most; });
  auto* const facts = std::get_if<PatchFacts>(&report.facts);
  if (facts != nullptr && facts->open_sides.size() > most) facts->open_sides.resize(most);
}

}  // namespace veritope::cli
