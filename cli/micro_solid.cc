// SPDX-License-Identifier: LGPL-3.0-or-later
#include "cli/micro_solid.h"

#include <utility>

#include "io/read_model.h"
#include "report/decimal_text.h"
#include "report/report_text.h"
#include "solids/micro/bridge/curve_bridges.h"
#include "solids/micro/synthesis/cage_around.h"
#include "verify/certify/certify.h"
#include "verify/certify/stand_in.h"

namespace veritope::cli {

Result<std::unique_ptr<const MicroSolid>> MicroSolid::read(const std::string& path,
                                                           const ModelReadOptions& reading) {
  Result<ModelFile> file = read_model_file(path, reading);
  if (!file) return file.error();
  Error error{
      Code::kBadArgument, {}, title_of(kind_of(*file)) + std::string(" is no solid for --model")};
  if (const ModelKind kind = kind_of(*file);
      kind == ModelKind::kMesh || kind == ModelKind::kSplines) {
    std::unique_ptr<MicroSolid> out(new MicroSolid(std::move(*file)));
    const Status decided = out->decide(static_cast<unsigned>(reading.jobs));
    if (decided) return std::unique_ptr<const MicroSolid>(std::move(out));
    error = decided.error();
  }
  error.place.file = path;
  return error;
}

Status MicroSolid::decide(unsigned jobs) {
  CertifyOptions certify;
  certify.jobs = jobs;
  const Result<Certified> certified = veritope::certify(file_, certify);
  if (!certified) return certified.error();
  if (certified->verdict != Verdict::kValid) {
    fault_ = std::string("the model is ") + verdict_name(certified->verdict) + ": " +
             text_of(certified->findings.front());
    is_open_ = certified->verdict == Verdict::kUndecided;
    return ok_status();
  }
  const auto* const splines = std::get_if<SplineFile>(&file_);
  if (splines == nullptr) return ok_status();
  const Result<std::optional<StandIn>> stand_in = stand_in_of(*splines);
  if (!stand_in) return stand_in.error();
  Result<FilePatches> patches = patches_of(*splines, *stand_in);
  if (!patches) return patches.error();
  patches_ = std::move(*patches);
  const PatchComplex* const complex = patches_.complex.get();
  if (complex != nullptr && complex->is_closed_oriented_surface()) return ok_status();
  fault_ = "the model is VALID, but its surface is not one that tiles are filtered by";
  is_open_ = true;
  return ok_status();
}

Result<TileFilter> MicroSolid::filter() const {
  if (const auto* const mesh = std::get_if<MeshFile>(&file_)) return TileFilter::make(mesh->mesh);
  return TileFilter::make(*patches_.complex);
}

double MicroSolid::default_skin() const {
  return mesh() != nullptr ? veritope::default_skin(*mesh()) : veritope::default_skin(*complex());
}

Result<std::optional<Clearance>> MicroSolid::clearance_of(const Microstructure& micro,
                                                          unsigned jobs) const {
  if (mesh() != nullptr) return veritope::clearance_of(micro, *mesh(), jobs);
  return veritope::clearance_of(micro, *complex(), jobs);
}

Result<BridgeReport> MicroSolid::bridge(const VModel& cage, const std::vector<AnalysedTile>& tiles,
                                        const BridgeOptions& options, bool in_space,
                                        Microstructure& micro) const {
  const auto build = [&](const auto& solid) {
    return in_space ? build_sweeps(solid, cage, tiles, options, micro)
                    : build_bridges(solid, cage, tiles, options, micro);
  };
  return mesh() != nullptr ? build(*mesh()) : build(*complex());
}

Result<std::optional<MicroSolid::Escape>> MicroSolid::escape_from(const VModel& cage) const {
  const auto told = [](const std::string& part, const std::optional<std::string>& outside,
                       const std::optional<VFaceNumber>& face) {
    Escape out{part, outside.has_value(), face};
    if (outside)
      out.message +=
          " does not lie inside of the cage: " + *outside + " is on its border or outside";
    else
      out.message += " is not proved to lie inside of the cage";
    return std::optional(out);
  };
  if (const auto* const mesh = std::get_if<MeshFile>(&file_)) {
    const Result<std::optional<CageEscape>> found = find_escape(cage, mesh->mesh);
    if (!found) return found.error();
    if (!found->has_value()) return std::optional<Escape>();
    std::optional<std::string> vertex;
    if ((*found)->vertex) vertex = "vertex " + std::to_string(*(*found)->vertex);
    return told("triangle " + std::to_string((*found)->triangle), vertex, (*found)->face);
  }
  const Result<std::optional<PatchEscape>> found = find_escape(cage, patches_.complex->patches());
  if (!found) return found.error();
  if (!found->has_value()) return std::optional<Escape>();
  std::optional<std::string> point;
  if (const auto& p = (*found)->point) {
    point = "its point near (";
    for (std::size_t c = 0; c < 3; ++c)
      *point += (c == 0 ? "" : ", ") + report::short_decimal(nearest_double((*p)[c]));
    *point += ")";
  }
  return told(to_string(patches_.complex->patch((*found)->patch).origin()), point, (*found)->face);
}

}  // namespace veritope::cli
