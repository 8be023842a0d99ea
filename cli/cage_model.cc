// SPDX-License-Identifier: LGPL-3.0-or-later
#include "cli/cage_model.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "io/read_model.h"
#include "io/splines/patch_model.h"
#include "io/splines/volume_faces.h"
#include "report/decimal_text.h"

namespace veritope::cli {
namespace {

Result<CageContent> content_of_splines(const SplineFile& file) {
  const auto is_volume = [](const SplineEntity& e) {
    return std::holds_alternative<ExactVolume>(e.shape);
  };
  const std::vector<SplineEntity>& entities = file.model.entities;
  if (std::ranges::all_of(entities, is_volume)) {
    const Result<VolumeFaces> faces = volume_faces(file.model);
    if (!faces) return faces.error();
    return content_of(faces->patches);
  }
  const Result<PatchSource> source = patch_source(file.model);
  if (!source) return source.error();
  if (!source->foreign.empty())
    return bad_argument("no cage is made around " + to_string(source->foreign.front()));
  return content_of(source->patches);
}

Result<CageContent> content_of_file(const ModelFile& file) {
  if (const auto* const mesh = std::get_if<MeshFile>(&file)) return content_of(mesh->mesh);
  if (const auto* const splines = std::get_if<SplineFile>(&file))
    return content_of_splines(*splines);
  return bad_argument(std::string("no cage is made around ") + title_of(kind_of(file)));
}

}  // namespace

Result<CagedModel> read_caged_model(const std::string& path, const ModelReadOptions& reading) {
  Result<ModelFile> file = read_model_file(path, reading);
  if (!file) return file.error();
  Result<CageContent> content = content_of_file(*file);
  if (!content) {
    Error error = content.error();
    error.place.file = path;
    return error;
  }
  CagedModel out;
  out.sha256 = sha256_of(*file);
  out.is_mesh = std::holds_alternative<MeshFile>(*file);
  out.content = std::move(*content);
  if (out.content.num_parts() > 0) return out;
  Error error{Code::kEmpty, {}, "there is nothing in it that a cage could contain"};
  error.place.file = path;
  return error;
}

std::string part_name(const CagedModel& model, std::size_t part) {
  if (model.is_mesh) return "triangle " + std::to_string(part);
  const CellPoint& p = model.content.points[model.content.part(part).front()];
  return "the part near " +
         report::point_text({nearest_double(p[0]), nearest_double(p[1]), nearest_double(p[2])});
}

}  // namespace veritope::cli
