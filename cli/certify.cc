// SPDX-License-Identifier: LGPL-3.0-or-later
#include "cli/certify.h"

#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <new>
#include <string_view>
#include <utility>
#include <vector>

#include "cli/checker_process.h"
#include "cli/defect_picture.h"
#include "cli/scratch_file.h"
#include "cli/text_style.h"
#include "io/file_bytes.h"
#include "io/reading_rule.h"
#include "robust/base/check.h"
#include "verify/certify/mesh_certifier.h"
#include "verify/format/mesh_certificate.h"
#include "verify/format/sha256.h"

namespace veritope::cli {
namespace {

class Stopwatch {
 public:
  double lap() {
    const auto now = std::chrono::steady_clock::now();
    return std::chrono::duration<double>(now - std::exchange(last_, now)).count();
  }

 private:
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

std::string_view as_text(const certificate::Bytes& bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

// A name as a shell takes it.
std::string shell_word(const std::string& name) {
  constexpr std::string_view kPlain =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789._/+-";
  if (name.find_first_not_of(kPlain) == name.npos) return name;
  std::string out = "'";
  for (const char c : name) out += c == '\'' ? "'\\''" : std::string(1, c);
  return out + "'";
}

// Names that mean another file in another process, or one that can be read once only.
bool needs_copy(const std::string& path) {
  return path == "-" || path.starts_with("/dev/") || path.starts_with("/proc/");
}

// The bytes of an input that the checker cannot open by its name.
struct SpooledInput {
  ByteBuffer bytes;
  std::optional<ScratchFile> copy;  // for the checker
};

class Certification {
 public:
  Certification(const std::string& path, const CertifySettings& settings,
                const KeepCertificate& keep, Progress& progress)
      : settings_(settings), keep_(keep), progress_(progress) {
    report_.path = path;
  }

  FileReport run() {
    try {
      if (read() && decide() && certify() && check()) conclude();
    } catch (const InternalError& error) {
      give_up(kExitBug, {"internal", {}, std::string(error.what()) + "; " + how_to_report()});
    } catch (const std::bad_alloc&) {
      give_up(kExitUndecided, {"out-of-memory", {}, "not enough memory for this file"});
    }
    return std::move(report_);
  }

 private:
  // Always false.
  bool refuse(Fault fault) {
    report_.exit = kExitUnreadable;
    report_.verdict = FileVerdict::kUnreadable;
    report_.fault = std::move(fault);
    return false;
  }
  // Always false. A verdict that nobody else confirmed is none, and its counts, defects and certificate are none.
  bool give_up(ExitCode exit, Fault fault) {
    report_.certificate.reset();
    report_.decision.reset();
    report_.defects.clear();
    report_.picture.clear();
    report_.exit = exit;
    report_.verdict = FileVerdict::kUndecided;
    report_.fault = std::move(fault);
    return false;
  }

  void phase(const char* what) {
    const std::string& path = report_.path;
    const std::string name = harmless(path.substr(path.rfind('/') + 1));
    progress_.phase(path == "-" ? "standard input" : name, what);
    watch_.lap();
  }

  bool read() {
    phase("reading");
    Result<MeshFile> file = read_mesh();
    report_.seconds.read = watch_.lap();
    if (!file) return refuse(fault_of(file.error()));
    report_.reading = file->report;
    report_.as_indexed =
        settings_.reading.as_indexed && file->report.format != MeshFormat::kStl;
    report_.sha256 = file->sha256;
    mesh_ = std::move(file->mesh);
    polygon_of_face_ = std::move(file->polygon_of_face);
    return true;
  }

  Result<MeshFile> read_mesh() {
    const std::string& path = report_.path;
    if (!needs_copy(path)) return read_mesh_file(path, settings_.reading);
    const std::uint64_t max_bytes = settings_.reading.limits.max_bytes;
    Result<ByteBuffer> bytes = path == "-" ? read_descriptor(STDIN_FILENO, path, 0, max_bytes)
                                           : read_file_bytes(path, max_bytes);
    if (!bytes) return bytes.error();
    spooled_.bytes = std::move(*bytes);
    const ByteBuffer& b = spooled_.bytes;
    return read_mesh_bytes({b.data(), b.size()}, path, settings_.reading);
  }

  bool decide() {
    phase("deciding");
    ValidityOptions options;
    options.jobs = settings_.jobs;
    options.max_defects = std::max<std::size_t>(settings_.max_defects, 1);  // for the witnesses
    report_.decision = decide_validity(mesh_, options);
    report_.seconds.decide = watch_.lap();
    return true;
  }

  bool certify() {
    phase("certifying");
    ValidityReport& decision = *report_.decision;
    certificate::Subject subject;
    subject.sha256 = report_.sha256;
    subject.bytes = report_.reading->bytes;
    subject.format = mesh_format_name(report_.reading->format);
    subject.as_indexed = report_.as_indexed;
    subject.reading_rule = kReadingRule;
    subject.tool = tool_name();
    bytes_ = make_mesh_certificate(mesh_, decision, subject, settings_.jobs);
    report_.certificate = CertificateReport{{}, to_hex(sha256(bytes_)), bytes_.size(), false};
    list_defects(decision);
    report_.seconds.certify = watch_.lap();
    if (settings_.with_picture) report_.picture = defect_picture(mesh_, report_.defects);
    mesh_ = {};  // memory for the checker
    decision.stars = {};
    return true;
  }

  void list_defects(ValidityReport& decision) {
    for (Defect& d : share_out(std::move(decision.defects), settings_.max_defects)) {
      ListedDefect listed;
      for (const std::uint32_t f : d.faces) {
        if (!polygon_of_face_.empty()) listed.polygons.push_back(polygon_of_face_[f]);
      }
      listed.defect = std::move(d);
      report_.defects.push_back(std::move(listed));
    }
    decision.defects.clear();
    polygon_of_face_ = {};
  }

  bool check() {
    if (settings_.checker.empty()) return true;
    phase("checking");
    Result<ScratchFile> certificate = ScratchFile::with(as_text(bytes_));
    if (!certificate) return give_up(kExitUnreadable, fault_of(certificate.error()));
    std::vector<int> inherited = {certificate->descriptor()};
    std::string model = report_.path;
    if (needs_copy(model)) {
      const ByteBuffer& b = spooled_.bytes;
      Result<ScratchFile> copy =
          ScratchFile::with({reinterpret_cast<const char*>(b.data()), b.size()});
      if (!copy) return give_up(kExitUnreadable, fault_of(copy.error()));
      spooled_.copy.emplace(std::move(*copy));
      inherited.push_back(spooled_.copy->descriptor());
      model = spooled_.copy->path();
    }
    const std::string claim(report_.decision->is_valid ? certificate::kValidClaim
                                                       : certificate::kInvalidClaim);
    const CheckerOutcome outcome =
        run_checker(settings_.checker, model, certificate->path(), claim, inherited);
    report_.seconds.check = watch_.lap();
    report_.certificate->is_checked = outcome.is_accepted;
    return outcome.is_accepted || judge_refusal(outcome);
  }

  // Always false.
  bool judge_refusal(const CheckerOutcome& outcome) {
    if (!outcome.is_started) {
      return give_up(kExitUndecided, {"not-checked", {}, settings_.checker + " " + outcome.words});
    }
    if (outcome.lacks_resources) {
      return give_up(
          kExitUndecided,
          {"out-of-memory", {}, "not enough memory for veritope-check (" + outcome.words + ")"});
    }
    if (outcome.exceeds_work) {
      return give_up(kExitUndecided, {"over-budget",
                                      {},
                                      "the proof takes more work than checkers of this "
                                      "certificate may spend (" +
                                          outcome.words + ")"});
    }
    if (file_has_changed()) {
      FileReport blank;  // what was found is about bytes that are gone
      blank.path = report_.path;
      blank.seconds = report_.seconds;
      report_ = std::move(blank);
      return refuse({"file-changed", {}, "the file changed while it was being certified"});
    }
    return give_up(kExitBug, {"internal",
                              {},
                              "veritope-check did not accept our certificate (" + outcome.words +
                                  "); " + how_to_report()});
  }

  bool file_has_changed() const {
    if (needs_copy(report_.path)) return false;
    const Result<ByteBuffer> now =
        read_file_bytes(report_.path, settings_.reading.limits.max_bytes);
    return !now || to_hex(sha256({now->data(), now->size()})) != report_.sha256;
  }

  void conclude() {
    const bool is_valid = report_.decision->is_valid;
    report_.verdict = is_valid ? FileVerdict::kValid : FileVerdict::kInvalid;
    report_.exit = is_valid ? kExitValid : kExitInvalid;
    if (!keep_) return;
    const Result<std::string> kept = keep_(as_text(bytes_));
    if (kept) {
      report_.certificate->path = *kept;
      return;
    }
    report_.exit = first_of(report_.exit, kExitUnreadable);
    report_.fault = fault_of(kept.error());
  }

  std::string how_to_report() const {
    const std::string name = report_.path == "-" ? "FILE" : shell_word(report_.path);
    std::string options = "--no-check --certificate bug.cert ";
    if (settings_.reading.as_indexed) options += "--as-indexed ";
    if (settings_.reading.format) {
      options += std::string("--format ") + mesh_format_name(*settings_.reading.format) + " ";
    }
    return "this is a bug of veritope, not of your file: please report it with the file, or with "
           "what this prints: veritope certify " +
           options + name + "; veritope-check " + name + " bug.cert; veritope --version";
  }

  const CertifySettings& settings_;
  const KeepCertificate& keep_;
  Progress& progress_;
  FileReport report_;
  Stopwatch watch_;
  TriangleMesh mesh_;
  std::vector<std::uint32_t> polygon_of_face_;
  SpooledInput spooled_;
  certificate::Bytes bytes_;
};

}  // namespace

FileReport certify_file(const std::string& path, const CertifySettings& settings,
                        const KeepCertificate& keep, Progress& progress) {
  return Certification(path, settings, keep, progress).run();
}

std::string tool_name() { return "veritope " VERITOPE_VERSION; }

}  // namespace veritope::cli
