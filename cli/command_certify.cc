// SPDX-License-Identifier: LGPL-3.0-or-later
// veritope certify.
#include <sys/stat.h>

#include "cli/certification.h"
#include "cli/checker_process.h"
#include "cli/commands.h"
#include "cli/model_input.h"
#include "cli/output_plan.h"
#include "report/report_json.h"
#include "report/report_text.h"

namespace veritope::cli {
namespace {

using namespace report;

// Keeps certificate i where the plan says.
KeepCertificate keeper(const OutputPlan& plan, std::size_t i, StandardOutput& out) {
  if (plan.certificates.empty()) return {};
  return [&plan, i, &out](std::string_view bytes) -> Result<std::string> {
    // Made for the first certificate, so that a refused run leaves none behind. A failure shows in what follows.
    if (plan.new_folder) ::mkdir(plan.new_folder->c_str(), 0777);
    const Status status = write_output(plan.certificates[i], bytes, out);
    if (!status) return status.error();
    return plan.certificates[i];
  };
}

void print(const FileReport& report, bool quiet, bool lists_pairs, StandardOutput& out) {
  const TextOptions options{style_of_stdout(), lists_pairs};
  out.write(verdict_line(report, options.style) + (quiet ? "" : details_text(report, options)));
}

// A verdict with a fault beside it: the certificate could not be kept.
void complain_beside_verdict(const FileReport& report) {
  if (!report.has_verdict() || !report.fault) return;
  complain(harmless(report.fault->place.source.file + ": " + text_of(*report.fault)));
}

ExitCode fail(const Error& error) {
  complain(harmless(to_string(error)));
  return error.code == Code::kBadArgument ? kExitUsage : kExitUnreadable;
}

// kExitValid, or kExitUnreadable and why on standard error.
ExitCode write_picture(const std::string& path, const std::string& bytes, StandardOutput& out) {
  const Status status = write_output(path, bytes, out);
  if (status) return kExitValid;
  complain(harmless(to_string(status.error())));
  return kExitUnreadable;
}

ExitCode write_json(const Options& options, const OutputPlan& plan,
                    const std::vector<std::string>& files, StandardOutput& out) {
  if (plan.json_in_new_folder) ::mkdir(plan.new_folder->c_str(), 0777);
  const Status status = write_output(*options.json, document_json("veritope-report-1", files), out);
  if (status || *options.json == "-") return kExitValid;  // main looks at standard output
  complain(harmless(to_string(status.error())));
  return kExitUnreadable;
}

CertifySettings settings_of(const Options& options) {
  CertifySettings out;
  out.reading = options.reading;
  out.certify.jobs = options.jobs;
  if (options.max_defects) out.certify.max_findings = *options.max_defects;
  if (options.orient_auto) out.certify.orientation = PatchOrientation::kAuto;
  out.certify.with_collar = options.collar;
  out.certify.tolerance = options.tolerance;
  out.with_picture = options.picture.has_value();
  return out;
}

}  // namespace

ExitCode run_certify(const Options& options, StandardOutput& out) {
  const Result<OutputPlan> plan = plan_outputs(options.files, options.certificate, options.json);
  if (!plan) return fail(plan.error());
  if (options.picture &&
      ModelInput(options.files.front(), options.reading).kind() == ModelKind::kSplines)
    return fail(
        {Code::kBadArgument,
         {},
         "--picture shows the defects of meshes; " + options.files.front() + " is a spline file"});
  if (options.picture) {
    if (Status status =
            check_output("--picture", *options.picture, options.files, *plan, options.json);
        !status) {
      return fail(status.error());
    }
  }
  CertifySettings settings = settings_of(options);
  if (!options.no_check) {
    const Result<std::string> checker = find_checker();
    if (!checker) return complain(checker.error().message), kExitUsage;
    settings.checker = *checker;
  }
  std::vector<std::string> json;
  ExitCode exit = kExitValid;
  Progress progress(!options.quiet);
  for (std::size_t i = 0; i < options.files.size(); ++i) {
    const std::string& file = options.files[i];
    const CertifiedFile done = certify_file(file, settings, keeper(*plan, i, out), progress);
    const FileReport& report = done.report;
    progress.clear();
    exit = first_of(exit, report.exit);
    if (options.json) json.push_back(report_json(report));
    if (options.json != "-") print(report, options.quiet, options.max_defects.has_value(), out);
    complain_beside_verdict(report);
    if (!done.picture.empty())
      exit = first_of(exit, write_picture(*options.picture, done.picture, out));
  }
  return options.json ? first_of(exit, write_json(options, *plan, json, out)) : exit;
}

}  // namespace veritope::cli
