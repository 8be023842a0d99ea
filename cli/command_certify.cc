// SPDX-License-Identifier: LGPL-3.0-or-later
// veritope certify.
#include <sys/stat.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <filesystem>
#include <set>
#include <system_error>

#include "cli/certification.h"
#include "cli/checker_process.h"
#include "cli/commands.h"
#include "cli/model_files.h"
#include "cli/model_input.h"
#include "cli/model_picture.h"
#include "cli/output_plan.h"
#include "io/base/atomic_file.h"
#include "report/report_json.h"
#include "report/report_text.h"
#include "report/totals.h"
#include "verify/certify/certify_file.h"

namespace veritope::cli {
namespace {

using namespace report;

struct CertifyFilesOptions {
  InputOptions input;
  std::optional<std::string> json, certificate, picture, glob, tsv;
  std::optional<std::uint64_t>
      max_defects;  ///< nothing: 20, and pairs of faces are not listed one by one
  bool no_check = false, quiet = false;
  std::optional<int> jobs;           ///< nothing: all of the machine, one for small meshes
  std::optional<std::string> model;  ///< microstructures
  // spline files
  bool orient_auto = false, regular = false, collar = false;
  std::optional<double> tolerance;
  LimitOptions limits;
};

void declare(OptionSet& set, CertifyFilesOptions& o) {
  declare_files(set, o.input, "meshes, splines, folders; - is standard input (--format)");
  declare_json(set, o.json, "write the report");
  set.output("--tsv", o.tsv, "write a table; --glob PATTERN: files of folders");
  set.text("--glob", o.glob, "files of folders whose names match", "PATTERN");
  set.hide("--glob");  // the help line above names it
  set.text("--certificate", o.certificate, "keep the certificate; of several files in folder F");
  set.text("--picture", o.picture, "draw: .png, .ply, .vtu, .gltf; --max-defects N: 20 listed");
  set.number("--max-defects", o.max_defects, {0, kMost32},
             "list at most N defects of each rule (20)");
  set.hide("--max-defects");  // the help line above names it
  declare_jobs(set, o.jobs);
  declare_orientation(set, o.orient_auto, "patches, faces");
  set.length("--tolerance", "EPS", o.tolerance,
             "patches: relative width of the volume's interval (1e-5)");
  set.flag("--collar", o.collar, "patches: find a collar, and certify it, too");
  set.hide("--collar");  // the help line below names it
  set.text("--model", o.model, "microstructures: they lie in the interior of this solid", "M");
  set.hide("--model");  // the help line of --no-check names it
  set.flag("--regular", o.regular, "volumes: INVALID where det J is 0; --collar: find collars");
  set.flag("--no-check", o.no_check, "run no veritope-check; --model M: .vmicro inside solid M");
  set.flag("-q,--quiet", o.quiet, "the verdict lines only, as a table");
  declare_format(set, o.input);
  declare_reading(set, o.input.reading);
  declare_limits(set, o.limits);
}

std::string contradiction(const CertifyFilesOptions& o) {
  if (o.picture == "-") return "--picture needs a file name, not -";
  if (o.picture && o.input.files.size() > 1) return "--picture takes exactly one input";
  if (o.json == "-" && o.tsv == "-") return "--json and --tsv would both write standard output";
  if (o.regular && o.collar)
    return "--regular is about cells of volumes, and --collar about boundary faces alone";
  if (o.certificate == "-") return "--certificate needs a file name, not -";
  return "";
}

bool is_file_or_new(const std::string& path) {
  struct stat status {};
  return ::stat(path.c_str(), &status) != 0 || S_ISREG(status.st_mode);
}

// Folders are made for the first certificate in them, so that a refused run leaves none behind. If one cannot be made,
// writing the certificate fails. The folder above a new one must exist.
void make_folders_of_certificate(const OutputPlan& plan, std::size_t i) {
  if (!plan.has_folder) return;
  if (plan.new_folder && ::mkdir(plan.new_folder->c_str(), 0777) != 0 && errno != EEXIST) return;
  std::error_code none;
  std::filesystem::create_directories(std::filesystem::path(plan.certificates[i]).parent_path(),
                                      none);
}

bool is_file(const std::string& path) {
  struct stat status {};
  return ::stat(path.c_str(), &status) == 0 && S_ISREG(status.st_mode);
}

// Keeps certificate i, and what was certified, where the plan says.
KeepCertificate keeper(const OutputPlan& plan, std::size_t i, StandardOutput& out) {
  if (plan.certificates.empty()) return {};
  return [&plan, i, &out](std::string_view bytes, const StandInBytes* copy) -> Result<KeptFiles> {
    make_folders_of_certificate(plan, i);
    KeptFiles kept{plan.certificates[i], {}};
    // Beside a pipe or a device there is no place for it.
    if (copy != nullptr && is_file_or_new(kept.certificate))
      kept.copy = copy_path(kept.certificate, copy->format);
    const Status status = kept.copy ? write_files(std::array{WholeFile{*kept.copy, copy->bytes},
                                                             WholeFile{kept.certificate, bytes}})
                                    : write_output(kept.certificate, bytes, out);
    if (!status) return status.error();
    return kept;
  };
}

// Verdict lines alone are a table.
TextOptions text_options(const CertifyFilesOptions& o, std::size_t num_copies) {
  TextOptions out = TextOptions::of_stdout();
  const std::size_t most_wide = out.verdict_width == kNoWidth ? 70 : out.verdict_width / 2;
  out.lists_pairs = o.max_defects.has_value();
  if (!o.quiet || o.input.files.size() < 2) return out;
  for (std::size_t i = 0; i + num_copies < o.input.files.size(); ++i)
    out.path_width =
        std::max(out.path_width, std::min(columns(shown_path(o.input.files[i])), most_wide));
  return out;
}

// What stands in the way of outputs, each once: they are tried before the work begins, and written at its end.
class OutputComplaints {
 public:
  void add(const std::string& text) {
    if (made_.insert(text).second) complain(harmless(text));
  }
  void add(const Error& error) { add(to_string(error)); }

 private:
  std::set<std::string> made_;
};

// Reports a fault beside a verdict: the certificate could not be kept.
void complain_beside_verdict(const FileReport& report, OutputComplaints& complaints) {
  if (!report.has_verdict() || !report.fault) return;
  complaints.add(report.fault->place.source.file + ": " + text_of(*report.fault));
}

// Makes the new folder of the certificates, if this output goes there, too.
void make_folder_of(const std::string& path, const OutputPlan& plan) {
  if (is_in_new(plan, path)) ::mkdir(plan.new_folder->c_str(), 0777);
}

// Reports beside a verdict that its picture could not be drawn.
void complain_about_picture(const std::string& path, const Finding& fault, FileReport& report) {
  const bool is_bug = fault.code == "internal";
  report.exit = first_of(report.exit, is_bug ? kExitBug : kExitUnreadable);
  complain(harmless(path + ": not drawn: " + text_of(fault)));
}

// Writes the picture and names it in the report; complains if it cannot be written.
void keep_picture(const std::string& path, const std::string& bytes, const OutputPlan& plan,
                  FileReport& report, OutputComplaints& complaints, StandardOutput& out) {
  make_folder_of(path, plan);
  const Status status = write_output(path, bytes, out);
  if (status) {
    report.picture = path;
    return;
  }
  report.exit = first_of(report.exit, kExitUnreadable);
  complaints.add(status.error());
}

ExitCode write_table(const std::string& path, const std::string& rows, const OutputPlan& plan,
                     OutputComplaints& complaints, StandardOutput& out) {
  make_folder_of(path, plan);
  const Status status = write_output(path, tsv_head() + rows, out);
  if (status || path == "-") return kExitValid;  // main looks at standard output
  complaints.add(status.error());
  return kExitUnreadable;
}

ExitCode write_json(const CertifyFilesOptions& options, const OutputPlan& plan,
                    const std::vector<std::string>& files, OutputComplaints& complaints,
                    StandardOutput& out) {
  make_folder_of(*options.json, plan);
  const Status status = write_output(*options.json, document_json("veritope-report-1", files), out);
  if (status || *options.json == "-") return kExitValid;  // main looks at standard output
  complaints.add(status.error());
  return kExitUnreadable;
}

CertifySettings settings_of(const CertifyFilesOptions& options) {
  CertifySettings out;
  out.reading = options.input.reading;
  out.reading.jobs = options.jobs.value_or(default_jobs());
  out.certify.jobs = static_cast<unsigned>(out.reading.jobs);
  out.spares_threads = !options.jobs;
  if (options.max_defects) out.certify.max_findings = *options.max_defects;
  if (options.orient_auto) out.certify.orientation = PatchOrientation::kAuto;
  out.certify.wants_regular = options.regular;
  out.certify.with_collar = options.collar;
  out.certify.tolerance = options.tolerance;
  out.certify.max_cells = options.limits.max_cells;
  out.certify.max_memory = options.limits.max_memory();
  if (options.picture) out.picture = picture_kind(*options.picture);
  return out;
}

// Refuses a picture of another format, one of a model that has none, and one that would overwrite another file.
Status check_picture(const CertifyFilesOptions& options, const OutputPlan& plan) {
  if (!options.picture) return ok_status();
  const std::vector<std::string>& files = options.input.files;
  const std::optional<PictureKind> kind = picture_kind(*options.picture);
  if (!kind)
    return bad_argument("--picture writes .png, .ply, .vtu and .gltf, not " + *options.picture);
  // A pipe can be read once only.
  if (is_file(files.front())) {
    const ModelKind model = ModelInput(files.front(), options.input.reading).kind();
    if (!has_pictures(model))
      return bad_argument("pictures are of meshes and splines; " + files.front() + " is " +
                          title_of(model));
  }
  return check_output("--picture", *options.picture, files, plan, options.json);
}

Status check_table(const CertifyFilesOptions& options, const OutputPlan& plan) {
  if (!options.tsv || *options.tsv == "-") return ok_status();
  if (options.picture &&
      (*options.tsv == *options.picture ||
       (!is_in_new(plan, *options.tsv) && same_target(*options.tsv, *options.picture))))
    return bad_argument("--tsv and --picture would both write " + *options.tsv);
  return check_output("--tsv", *options.tsv, options.input.files, plan, options.json);
}

// Refuses files beside microstructures, and models that cannot be read twice.
Status check_model(const CertifyFilesOptions& options) {
  if (!options.model) return ok_status();
  if (needs_copy(*options.model))
    return bad_argument("--model needs the name of a file that can be read twice, not " +
                        *options.model);
  for (const std::string& file : options.input.files) {
    const auto& format = options.input.reading.format;
    const bool is_read = is_file(file);
    if (!is_read && !format) continue;
    const ModelKind kind =
        is_read ? ModelInput(file, options.input.reading).kind() : kind_of(*format);
    if (kind != ModelKind::kMicro)
      return bad_argument("--model is for microstructures; " + file + " is " + title_of(kind));
  }
  return ok_status();
}
// Reads the solid.
Result<InsideModelFile> read_inside_model(const std::string& path, ModelReadOptions reading) {
  reading.format.reset();
  Result<ModelFile> file = read_model_file(path, reading);
  if (!file) return file.error();
  if (std::holds_alternative<MicroFile>(*file)) {
    Error error{Code::kUnknownFormat, {}, "a microstructure is no solid for --model"};
    error.place.file = path;
    return error;
  }
  InsideModelFile out{std::move(*file), {}};
  out.report = {path, sha256_of(out.file), model_format(format_of(out.file)).name,
                num_bytes(out.file)};
  return out;
}

// Files of folders that are left out are named, so that nobody takes them for certified.
void report_copies(std::size_t num_copies, bool has_text, StandardOutput& out) {
  const std::string text = num_copies == 1 ? "1 copy beside its certificate was left out"
                                           : std::to_string(num_copies) +
                                                 " copies beside their certificates were left out";
  if (has_text)
    out.write(text + "\n");
  else
    complain(text);
}

ExitCode certify_all(const CertifyFilesOptions& options, const OutputPlan& plan,
                     const CertifySettings& settings, const std::vector<std::string>& copies,
                     StandardOutput& out) {
  const std::size_t num_files = options.input.files.size();
  std::set<std::string> certified_copies;  // SHA-256 of copies with a verdict
  std::size_t num_left_out = 0;
  const TextOptions text = text_options(options, copies.size());
  const bool has_text = options.json != "-" && options.tsv != "-";
  std::vector<std::string> json;
  std::string table;
  Totals totals;
  ExitCode exit = kExitValid;
  OutputComplaints complaints;
  if (const Status status = try_outputs(plan, {options.json, options.tsv, options.picture});
      !status) {
    complaints.add(status.error());
    exit = kExitUnreadable;
  }
  Progress progress(!options.quiet);
  for (std::size_t i = 0; i < num_files; ++i) {
    if (i + copies.size() >= num_files &&
        certified_copies.count(copies[i + copies.size() - num_files]) != 0) {
      ++num_left_out;
      continue;
    }
    progress.file(i + 1, num_files);
    CertifiedFile done =
        certify_file(options.input.files[i], settings, keeper(plan, i, out), progress);
    FileReport& report = done.report;
    progress.clear();
    if (done.picture_fault) complain_about_picture(*options.picture, *done.picture_fault, report);
    if (!done.picture.empty())
      keep_picture(*options.picture, done.picture, plan, report, complaints, out);
    exit = first_of(exit, report.exit);
    totals.add(report);
    if (report.copy && report.has_verdict()) certified_copies.insert(report.copy->sha256);
    if (options.json) json.push_back(report_json(report));
    if (options.tsv) table += tsv_row(report);
    if (has_text)
      out.write(verdict_line(report, text) + (options.quiet ? "" : details_text(report, text)));
    complain_beside_verdict(report, complaints);
  }
  if (has_text && num_files > 1) out.write(totals.text());
  if (num_left_out != 0) report_copies(num_left_out, has_text, out);
  if (options.tsv) exit = first_of(exit, write_table(*options.tsv, table, plan, complaints, out));
  return options.json ? first_of(exit, write_json(options, plan, json, complaints, out)) : exit;
}

ExitCode run(CertifyFilesOptions options, StandardOutput& out) {
  const bool has_folder = std::any_of(options.input.files.begin(), options.input.files.end(),
                                      [](const std::string& f) { return is_folder_of_models(f); });
  if (options.glob && !has_folder)
    return complain("--glob selects files of folders, and no folder is given"), kExitUsage;
  if (options.picture && has_folder)
    return complain("--picture takes exactly one input, not a folder"), kExitUsage;
  Result<ModelFiles> files = files_in_folders(options.input.files, options.glob);
  if (!files) return fail(files.error());
  options.input.files = std::move(files->paths);
  const Result<OutputPlan> plan =
      plan_outputs(options.input.files, options.certificate, options.json, has_folder);
  if (!plan) return fail(plan.error());
  if (const Status status = check_picture(options, *plan); !status) return fail(status.error());
  if (const Status status = check_table(options, *plan); !status) return fail(status.error());
  if (const Status status = check_model(options); !status) return fail(status.error());
  CertifySettings settings = settings_of(options);
  if (!options.no_check) {
    const Result<std::string> checker = find_checker();
    if (!checker) return complain(checker.error().message), kExitUsage;
    settings.checker = *checker;
  }
  std::optional<InsideModelFile> inside;
  if (options.model) {
    Result<InsideModelFile> read = read_inside_model(*options.model, settings.reading);
    if (!read) return fail(read.error());
    settings.inside = &inside.emplace(std::move(*read));
  }
  return certify_all(options, *plan, settings, files->copies, out);
}

}  // namespace

RunCommand declare_certify(OptionSet& set) {
  const auto o = std::make_shared<CertifyFilesOptions>();
  declare(set, *o);
  set.rule([o] { return contradiction(*o); });
  return [o](StandardOutput& out) { return run(*o, out); };
}

}  // namespace veritope::cli
