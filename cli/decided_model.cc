// SPDX-License-Identifier: LGPL-3.0-or-later
#include "cli/decided_model.h"

#include <utility>

#include "cli/output.h"
#include "report/report_text.h"
#include "robust/base/check.h"
#include "solids/patches/patch_sources.h"
#include "verify/certify/stand_in.h"

namespace veritope::cli {
namespace {

ExitCode refuse_model(const Error& error) {
  complain(harmless(to_string(error)));
  return kExitUnreadable;
}

ExitCode take_mesh(const TriangleMesh& mesh, DecidedModel& out) {
  Result<PatchInput> patches = patches_of(mesh);
  if (!patches) return refuse_model(patches.error());
  Result<PatchComplex> made = make_patch_complex(std::move(*patches));
  if (!made) return refuse_model(made.error());
  out.complex.emplace(std::move(*made));
  out.is_mesh = true;
  return kExitValid;
}

ExitCode take_splines(const SplineFile& file, DecidedModel& out) {
  const Result<std::optional<StandIn>> stand_in = stand_in_of(file);
  if (!stand_in) return refuse_model(stand_in.error());
  Result<FilePatches> patches = patches_of(file, *stand_in);
  if (!patches) return refuse_model(patches.error());
  VT_CHECK(patches->complex != nullptr, "a valid model has patches");
  out.complex.emplace(*patches->complex);
  return kExitValid;
}

}  // namespace

Status require_surface(const ModelFile& model, const std::string& path) {
  if (std::holds_alternative<MeshFile>(model) || std::holds_alternative<SplineFile>(model))
    return ok_status();
  Error error{Code::kUnknownFormat,
              {},
              std::string("this is ") + title_of(kind_of(model)) +
                  "; needed is a mesh or a file of splines"};
  error.place.file = path;
  return error;
}

ExitCode take_decided_model(const std::string& path, CertifySettings settings,
                            const std::string& refusal, Progress& progress, DecidedModel& out) {
  ModelFile model;
  settings.model = &model;
  const CertifiedFile done = certify_file(path, settings, {}, progress);
  progress.clear();
  if (done.report.verdict != Verdict::kValid) {
    std::string line = verdict_line(done.report, TextOptions());
    while (line.ends_with('\n')) line.pop_back();
    complain(refusal + line);
    return done.report.exit;
  }
  if (const Status status = require_surface(model, path); !status)
    return refuse_model(status.error());
  out.sha256 = done.report.sha256;
  const auto* const mesh = std::get_if<MeshFile>(&model);
  const ExitCode exit =
      mesh != nullptr ? take_mesh(mesh->mesh, out) : take_splines(std::get<SplineFile>(model), out);
  if (exit != kExitValid) return exit;
  if (out.complex->is_closed_oriented_surface()) return kExitValid;
  complain(harmless(path + ": " + describe(*out.complex, out.complex->findings().front())));
  return kExitInvalid;
}

}  // namespace veritope::cli
