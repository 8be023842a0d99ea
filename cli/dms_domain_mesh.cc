// SPDX-License-Identifier: LGPL-3.0-or-later
#include "cli/dms_domain_mesh.h"

#include <utility>
#include <variant>

#include "cli/certification.h"
#include "cli/checker_process.h"
#include "report/report_text.h"
#include "report/text_style.h"

namespace veritope::cli {
namespace {

constexpr const char* kRefusal = "no domain is made: ";

ExitCode take_valid_mesh(const MeshDomainChoice& choice, Progress& progress, ModelFile& model) {
  CertifySettings settings;
  settings.reading = choice.reading;
  settings.certify.jobs = static_cast<unsigned>(choice.reading.jobs);
  settings.spares_threads = true;
  settings.model = &model;
  if (!choice.no_check) {
    const Result<std::string> checker = find_checker();
    if (!checker) return complain(checker.error().message), kExitUsage;
    settings.checker = *checker;
  }
  const CertifiedFile done = certify_file(choice.path, settings, {}, progress);
  progress.clear();
  if (done.report.verdict == Verdict::kValid) return kExitValid;
  std::string line = verdict_line(done.report, TextOptions());
  while (line.ends_with('\n')) line.pop_back();
  complain(kRefusal + line);
  return done.report.exit;
}

}  // namespace

ExitCode take_mesh_domain(const MeshDomainChoice& choice, Progress& progress, MeshDomain& out) {
  ModelFile model;
  const ExitCode exit = take_valid_mesh(choice, progress, model);
  if (exit != kExitValid) return exit;
  const auto* const file = std::get_if<MeshFile>(&model);
  if (file == nullptr) {
    complain(harmless(kRefusal + choice.path + ": this is " + title_of(kind_of(model)) +
                      "; needed is a mesh, or points"));
    return kExitUnreadable;
  }
  MeshDomainOptions options;
  if (choice.max_vertices) options.max_vertices = *choice.max_vertices;
  progress.phase(choice.path, "cutting tetrahedra");
  Result<MeshDomain> domain = domain_of_mesh(file->mesh, options);
  progress.clear();
  if (!domain) {
    complain(harmless(kRefusal + choice.path + ": " + domain.error().message));
    return kExitUndecided;
  }
  out = std::move(*domain);
  return kExitValid;
}

}  // namespace veritope::cli
