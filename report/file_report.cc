// SPDX-License-Identifier: LGPL-3.0-or-later
#include "report/file_report.h"

#include <utility>

#include "io/formats.h"

namespace veritope::report {
namespace {

Source source_in(const MeshFile& file) { return file.report; }
Source source_in(const SplineFile& file) {
  return SplineSource{file.format, file.bytes, file.model.entities.size()};
}

void forget(std::monostate&) {}
// A mesh has no counts without its verdict.
void forget(MeshFacts&) {}
// Reports of solids that are not valid show what the file has.
void forget(DmsFacts& facts) {
  facts.defects.clear();
  facts.num_defects = 0;
}
// Reports of microstructures that are not valid show cells and tiles alone.
void forget(MicroFacts&) {}
// The counts of the complex stand without a verdict.
void forget(PatchFacts& facts) {
  PatchFacts kept;
  kept.patches = facts.patches, kept.edges = facts.edges;
  kept.vertices = facts.vertices, kept.shells = facts.shells;
  kept.reversed = std::move(facts.reversed);
  kept.boxes_tried = facts.boxes_tried;
  kept.auto_helps = facts.auto_helps;
  kept.vmodel = std::move(facts.vmodel);
  if (kept.vmodel) kept.vmodel->singular.clear(), kept.vmodel->volume.reset();
  facts = std::move(kept);
}

}  // namespace

const char* verdict_word(std::optional<Verdict> verdict) {
  return verdict ? verdict_name(*verdict) : "UNREADABLE";
}

Source source_of(const ModelFile& file) {
  return std::visit(
      [&](const auto& kind) -> Source {
        if constexpr (requires { source_in(kind); }) return source_in(kind);
        return PlainSource{model_format(format_of(file)).name, num_bytes(file)};
      },
      file);
}

std::optional<std::uint64_t> num_bytes(const FileReport& report) {
  if (const auto* mesh = std::get_if<ReadReport>(&report.source)) return mesh->bytes;
  if (const auto* splines = std::get_if<SplineSource>(&report.source)) return splines->bytes;
  if (const auto* plain = std::get_if<PlainSource>(&report.source)) return plain->bytes;
  return std::nullopt;
}

std::optional<std::string> format_name(const FileReport& report) {
  if (const auto* mesh = std::get_if<ReadReport>(&report.source))
    return mesh->container.empty() ? mesh_format_name(mesh->format) : mesh->container;
  if (const auto* splines = std::get_if<SplineSource>(&report.source))
    return spline_format_name(splines->format);
  if (const auto* plain = std::get_if<PlainSource>(&report.source)) return plain->format;
  return std::nullopt;
}

void give_up(FileReport& report, ExitCode exit, Finding fault) {
  report.certificate.reset();
  report.defects.clear();
  report.reasons.clear();
  if (std::holds_alternative<MeshFacts>(report.facts)) report.facts = std::monostate();
  std::visit([](auto& facts) { forget(facts); }, report.facts);
  report.exit = exit;
  report.verdict = Verdict::kUndecided;
  report.fault = std::move(fault);
}

void refuse(FileReport& report, Finding fault) {
  report.exit = kExitUnreadable;
  report.verdict.reset();
  report.fault = std::move(fault);
}

Finding fault_of(std::string code, std::string message) {
  Finding out;
  out.code = std::move(code);
  out.message = std::move(message);
  return out;
}

}  // namespace veritope::report
