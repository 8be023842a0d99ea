// SPDX-License-Identifier: LGPL-3.0-or-later
#include "cli/certification.h"

#include <algorithm>
#include <new>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "cli/checker_process.h"
#include "cli/model_picture.h"
#include "cli/output_plan.h"
#include "cli/scratch_file.h"
#include "io/chains/chain_file.h"
#include "io/formats.h"
#include "report/decimal_text.h"
#include "report/text_style.h"
#include "robust/base/check.h"
#include "robust/base/stopwatch.h"
#include "verify/certify/certify_file.h"
#include "verify/format/collar_certificate.h"
#include "verify/format/sha256.h"
#include "verify/format/star_box_certificate.h"

namespace veritope::cli {
namespace {

using namespace report;

std::string_view as_text(const certificate::Bytes& bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

// Starting the threads of one certification takes 1.5 ms of processor time; 4,000 faces take 15 ms in all.
bool is_small(const ModelFile& model) {
  constexpr std::size_t kWorthThreads = 4000;
  const auto* const file = std::get_if<MeshFile>(&model);
  return file != nullptr && file->mesh.faces.size() < kWorthThreads;
}

// A name, quoted for a shell.
std::string shell_word(const std::string& name) {
  constexpr std::string_view kPlain =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789._/+-";
  if (name.find_first_not_of(kPlain) == name.npos) return name;
  std::string out = "'";
  for (const char c : name) out += c == '\'' ? "'\\''" : std::string(1, c);
  return out + "'";
}

const char* phase_name(Phase phase) {
  switch (phase) {
    case Phase::kDeciding: return "deciding";
    case Phase::kSeekingCollar: return "looking for a collar";
    case Phase::kCertifying: return "certifying";
  }
  return "";
}

std::optional<double>& seconds_of(Phase phase, PhaseSeconds& seconds) {
  switch (phase) {
    case Phase::kDeciding: return seconds.decide;
    case Phase::kSeekingCollar: return seconds.collar;
    default: return seconds.certify;
  }
}

class Certification {
 public:
  Certification(const std::string& path, const CertifySettings& settings,
                const KeepCertificate& keep, Progress& progress)
      : settings_(settings), keep_(keep), progress_(progress) {
    report_.path = path;
  }

  CertifiedFile run() {
    try {
      if (read() && certify() && check()) conclude();
    } catch (const InternalError& error) {
      give_up(kExitBug, fault_of("internal", std::string(error.what()) + "; " + how_to_report()));
    } catch (const std::bad_alloc&) {
      give_up(kExitUndecided, fault_of("out-of-memory", "not enough memory for this file"));
    }
    return {std::move(report_), std::move(picture_), std::move(picture_fault_)};
  }

 private:
  // Ends the run without a verdict. Returns false, as give_up does.
  bool refuse(Finding fault) { return report::refuse(report_, std::move(fault)), false; }
  // Drops the verdict: no other program confirmed it. Returns false.
  bool give_up(ExitCode exit, Finding fault) {
    picture_.clear();
    picture_fault_.reset();
    return report::give_up(report_, exit, std::move(fault)), false;
  }

  void phase(const char* what) {
    const std::string& path = report_.path;
    const std::string name = harmless(path.substr(path.rfind('/') + 1));
    progress_.phase(path == "-" ? "standard input" : name, what);
    watch_.lap();
  }

  bool needs_copy() const { return cli::needs_copy(report_.path); }

  // A pattern for which the shell found no file is still a pattern.
  Finding unread(const Error& error) const {
    Finding out = finding_of(error);
    const bool is_pattern = report_.path.find_first_of("*?[") != report_.path.npos;
    if (error.code == Code::kCannotOpen && is_pattern)
      out.message += " (no file matches this pattern?)";
    return out;
  }

  bool read() {
    phase("reading");
    Result<ModelBytes> bytes = load_model(report_.path, settings_.reading);
    if (!bytes) return refuse(unread(bytes.error()));
    if (!settings_.reading.format && looks_like_chain(source_of(bytes->bytes, bytes->name))) {
      report_.sha256 = to_hex(sha256({bytes->bytes.data(), bytes->bytes.size()}));
      return give_up(
          kExitUndecided,
          fault_of("not-covered",
                   "this is a chain file, an expression of solids: its boundary is not "
                   "computed, so that nothing is certified about it; certify the operands, "
                   "and classify points"));
    }
    Result<ModelFile> model = read_model(*bytes, settings_.reading);
    report_.seconds.read = watch_.lap();
    if (!model) return refuse(finding_of(model.error()));
    if (needs_copy()) copy_ = std::move(bytes->bytes);
    if (settings_.model_bytes != nullptr && needs_copy())
      settings_.model_bytes->assign(reinterpret_cast<const char*>(copy_.data()), copy_.size());
    model_ = std::move(*model);
    report_.sha256 = sha256_of(model_);
    report_.source = source_of(model_);
    return true;
  }

  bool certify() {
    CertifyOptions options = settings_.certify;
    if (settings_.spares_threads && is_small(model_)) options.jobs = 1;
    if (settings_.picture) options.max_findings = std::max(options.max_findings, kMostDrawn);
    std::optional<Phase> current;
    const auto end_phase = [&] {
      if (current) seconds_of(*current, report_.seconds) = watch_.lap();
    };
    options.on_phase = [&](Phase next) {
      end_phase();
      current = next;
      phase(phase_name(next));
    };
    options.work = &progress_.work();
    if (settings_.inside != nullptr) {
      options.inside = &settings_.inside->file;
      report_.inside = settings_.inside->report;
    }
    Result<Certified> certified = veritope::certify(model_, options);
    end_phase();
    if (!certified) return refuse(finding_of(certified.error()));
    report_.facts = std::move(certified->facts);
    if (certified->copy) set_copy(std::move(*certified->copy));
    report_.boundary_faces = std::move(certified->boundary_faces);
    if (certified->verdict == Verdict::kUndecided) {
      Finding& first = certified->findings.front();
      if (first.code == "model-invalid")
        first.message = settings_.inside->report.path + ": " + first.message;
      give_up(kExitUndecided, certified->findings.front());
      report_.reasons = std::move(certified->findings);
      if (settings_.model != nullptr) *settings_.model = std::move(model_);
      return false;
    }
    report_.defects = std::move(certified->findings);
    verdict_ = certified->verdict;
    claim_ = std::move(certified->claim);
    set_certificate(std::move(certified->certificate));
    without_collar_ = std::move(certified->without_collar);
    if (settings_.picture) draw();
    if (settings_.model != nullptr) *settings_.model = std::move(model_);
    model_ = {};  // memory for the checker
    return true;
  }

  // Draws all defects that were listed for it, then drops those that nobody asked for. A picture that cannot be drawn
  // does not take the verdict back.
  void draw() {
    phase("drawing");
    report_.verdict = verdict_;  // whoever gives up or refuses takes it back
    try {
      const unsigned jobs = static_cast<unsigned>(settings_.reading.jobs);
      Result<std::string> picture = picture_of(model_, report_, *settings_.picture, jobs);
      if (picture)
        picture_ = std::move(*picture);
      else
        picture_fault_ = finding_of(picture.error());
    } catch (const InternalError& error) {
      picture_fault_ = fault_of("internal", std::string(error.what()) + "; " + how_to_report());
    } catch (const std::bad_alloc&) {
      picture_fault_ = fault_of("out-of-memory", "not enough memory for the picture");
    }
    keep_first(settings_.certify.max_findings, report_);
    report_.seconds.draw = watch_.lap();
  }

  void set_certificate(certificate::Bytes bytes) {
    bytes_ = std::move(bytes);
    report_.certificate = CertificateReport{{}, to_hex(sha256(bytes_)), bytes_.size(), false};
  }

  void set_copy(CertifiedCopy copy) {
    stand_in_ = {std::move(copy.format), std::move(copy.bytes)};
    report_.copy = CopyReport{{},
                              std::move(copy.sha256),
                              stand_in_->bytes.size(),
                              std::move(copy.what),
                              copy.is_of_volumes,
                              stand_in_->format};
  }

  // The cells are too many for the checker; the star boxes alone may not be.
  void drop_collar(const std::string& words) {
    set_certificate(std::exchange(without_collar_, {}));
    claim_ = claim_ == certificate::kCollar2Claim ? certificate::kStarBox2Claim
                                                  : certificate::kStarBoxClaim;
    CollarFacts& facts = *std::get<PatchFacts>(report_.facts).collar;
    Finding why = fault_of("over-budget", "one of " + std::to_string(facts.cells) +
                                              " cells was found, but the checker has too little "
                                              "memory or work for them" +
                                              words);
    facts = {};
    facts.open = std::move(why);
  }

  bool check() {
    if (settings_.checker.empty()) return true;
    phase("checking");
    Result<ScratchFile> certificate = ScratchFile::with(as_text(bytes_));
    if (!certificate) return give_up(kExitUnreadable, finding_of(certificate.error()));
    std::vector<int> inherited = {certificate->descriptor()};
    std::string model = report_.path;
    std::optional<ScratchFile> copy;
    if (stand_in_ || needs_copy()) {
      Result<ScratchFile> made = ScratchFile::with(
          stand_in_ ? std::string_view(stand_in_->bytes)
                    : std::string_view(reinterpret_cast<const char*>(copy_.data()), copy_.size()));
      if (!made) return give_up(kExitUnreadable, finding_of(made.error()));
      copy.emplace(std::move(*made));
      inherited.push_back(copy->descriptor());
      model = copy->path();
    }
    const CheckerOutcome outcome =
        run_checker(settings_.checker, model, certificate->path(), claim_, inherited, {},
                    settings_.inside != nullptr ? settings_.inside->report.path : "");
    report_.seconds.check = watch_.lap();
    report_.certificate->is_checked = outcome.is_accepted;
    return outcome.is_accepted || judge_refusal(outcome);
  }

  // Drops the verdict because of the checker's answer. Returns false.
  bool judge_refusal(const CheckerOutcome& outcome) {
    const std::string words = " (" + outcome.words + ")";
    if (!outcome.is_started)
      return give_up(kExitUndecided,
                     fault_of("not-checked", settings_.checker + " " + outcome.words));
    if ((outcome.lacks_resources || outcome.exceeds_work) && !without_collar_.empty()) {
      drop_collar(words);
      return check();
    }
    if (outcome.lacks_resources)
      return give_up(kExitUndecided,
                     fault_of("out-of-memory", "not enough memory for veritope-check" + words));
    if (outcome.exceeds_work)
      return give_up(kExitUndecided,
                     fault_of("over-budget",
                              "the proof takes more work or memory than checkers of "
                              "this certificate may spend" +
                                  words));
    if (outcome.exceeds_lengths)
      return give_up(
          kExitUndecided,
          fault_of("not-covered",
                   "the file has longer numbers than certificates may be about" + words));
    if (file_has_changed()) {
      FileReport blank;  // findings about bytes that are gone are not reported
      blank.path = report_.path;
      blank.seconds = report_.seconds;
      report_ = std::move(blank);
      return refuse(fault_of("file-changed", "the file changed while it was being certified"));
    }
    return give_up(kExitBug, fault_of("internal", "veritope-check did not accept our certificate" +
                                                      words + "; " + how_to_report()));
  }

  bool file_has_changed() const {
    if (settings_.inside != nullptr &&
        differs(settings_.inside->report.path, settings_.inside->report.sha256))
      return true;
    if (stand_in_ || needs_copy()) return false;
    return differs(report_.path, report_.sha256);
  }

  bool differs(const std::string& path, const std::string& digest) const {
    const Result<ModelBytes> now = load_model(path, settings_.reading);
    return !now || to_hex(sha256({now->bytes.data(), now->bytes.size()})) != digest;
  }

  void conclude() {
    report_.verdict = verdict_;
    report_.exit = verdict_ == Verdict::kValid ? kExitValid : kExitInvalid;
    if (!keep_) return;
    const Result<KeptFiles> kept = keep_(as_text(bytes_), stand_in_ ? &*stand_in_ : nullptr);
    if (kept) {
      report_.certificate->path = kept->certificate;
      if (kept->copy) report_.copy->path = kept->copy;
      return;
    }
    report_.exit = first_of(report_.exit, kExitUnreadable);
    report_.fault = finding_of(kept.error());
  }

  std::string how_to_report() const {
    const std::string name = report_.path == "-" ? "FILE" : shell_word(report_.path);
    return "this is a bug of veritope, not of your file: please report it with the file, or with "
           "what this prints: veritope certify --no-check --certificate bug.cert " +
           own_options() + name + "; veritope-check " +
           (stand_in_ ? copy_path("bug.cert", stand_in_->format) : name) + " bug.cert" +
           (settings_.inside != nullptr ? " --model " + shell_word(settings_.inside->report.path)
                                        : "") +
           "; veritope --version";
  }

  // The options of a command line that repeats this run.
  std::string own_options() const {
    std::string out;
    const CertifyOptions& o = settings_.certify;
    if (settings_.reading.as_indexed) out += "--as-indexed ";
    if (o.orientation == PatchOrientation::kAuto) out += "--orient auto ";
    if (o.wants_regular) out += "--regular ";
    if (o.with_collar) out += "--collar ";
    if (o.tolerance) out += "--tolerance " + short_decimal(*o.tolerance, 17) + " ";
    if (settings_.inside != nullptr)
      out += "--model " + shell_word(settings_.inside->report.path) + " ";
    if (o.max_cells) out += "--max-cells " + std::to_string(*o.max_cells) + " ";
    if (o.max_memory) out += "--max-memory " + std::to_string(*o.max_memory >> 20) + " ";
    if (settings_.reading.format)
      out += std::string("--format ") + model_format(*settings_.reading.format).name + " ";
    return out;
  }

  const CertifySettings& settings_;
  const KeepCertificate& keep_;
  Progress& progress_;
  Stopwatch watch_;
  FileReport report_;
  ModelFile model_;
  ByteBuffer copy_;                       ///< if needs_copy(): the input, for the checker
  std::optional<StandInBytes> stand_in_;  ///< the model that was certified in the place of the file
  Verdict verdict_ = Verdict::kUndecided;
  certificate::Bytes bytes_, without_collar_;
  std::string claim_, picture_;
  std::optional<Finding> picture_fault_;
};

}  // namespace

bool needs_copy(const std::string& path) {
  return path == "-" || path.starts_with("/dev/") || path.starts_with("/proc/");
}

CertifiedFile certify_file(const std::string& path, const CertifySettings& settings,
                           const KeepCertificate& keep, Progress& progress) {
  return Certification(path, settings, keep, progress).run();
}

}  // namespace veritope::cli
