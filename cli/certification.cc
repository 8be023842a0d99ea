// SPDX-License-Identifier: LGPL-3.0-or-later
#include "cli/certification.h"

#include <unistd.h>

#include <new>
#include <string_view>
#include <vector>

#include "cli/text_style.h"
#include "robust/base/check.h"
#include "verify/format/sha256.h"

namespace veritope::cli {
namespace {

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

}  // namespace

FileReport Certification::run() {
  try {
    if (read() && decide() && certify() && check()) conclude();
  } catch (const InternalError& error) {
    give_up(kExitBug, {"internal", {}, std::string(error.what()) + "; " + how_to_report()});
  } catch (const std::bad_alloc&) {
    give_up(kExitUndecided, {"out-of-memory", {}, "not enough memory for this file"});
  }
  return std::move(report_);
}

bool Certification::refuse(Fault fault) {
  report_.exit = kExitUnreadable;
  report_.verdict = FileVerdict::kUnreadable;
  report_.fault = std::move(fault);
  return false;
}

bool Certification::give_up(ExitCode exit, Fault fault) {
  report_.certificate.reset();
  report_.picture.clear();
  forget();
  report_.exit = exit;
  report_.verdict = FileVerdict::kUndecided;
  report_.fault = std::move(fault);
  return false;
}

void Certification::phase(const char* what) {
  const std::string& path = report_.path;
  const std::string name = harmless(path.substr(path.rfind('/') + 1));
  progress_.phase(path == "-" ? "standard input" : name, what);
  watch_.lap();
}

bool Certification::needs_copy() const {
  const std::string& path = report_.path;
  return path == "-" || path.starts_with("/dev/") || path.starts_with("/proc/");
}

Result<ByteBuffer> Certification::read_once() {
  const std::string& path = report_.path;
  const std::uint64_t max_bytes = settings_.reading.limits.max_bytes;
  return path == "-" ? read_descriptor(STDIN_FILENO, path, 0, max_bytes)
                     : read_file_bytes(path, max_bytes);
}

bool Certification::check() {
  if (settings_.checker.empty()) return true;
  phase("checking");
  Result<ScratchFile> certificate = ScratchFile::with(as_text(bytes_));
  if (!certificate) return give_up(kExitUnreadable, fault_of(certificate.error()));
  std::vector<int> inherited = {certificate->descriptor()};
  std::string model = report_.path;
  if (needs_copy()) {
    const ByteBuffer& b = spooled_;
    Result<ScratchFile> copy =
        ScratchFile::with({reinterpret_cast<const char*>(b.data()), b.size()});
    if (!copy) return give_up(kExitUnreadable, fault_of(copy.error()));
    copy_.emplace(std::move(*copy));
    inherited.push_back(copy_->descriptor());
    model = copy_->path();
  }
  const CheckerOutcome outcome =
      run_checker(settings_.checker, model, certificate->path(), claim(), inherited);
  report_.seconds.check = watch_.lap();
  report_.certificate->is_checked = outcome.is_accepted;
  return outcome.is_accepted || judge_refusal(outcome);
}

// Always false.
bool Certification::judge_refusal(const CheckerOutcome& outcome) {
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
                                    "the proof takes more work or memory than checkers of "
                                    "this certificate may spend (" +
                                        outcome.words + ")"});
  }
  if (outcome.exceeds_lengths) {
    return give_up(kExitUndecided, {"not-covered",
                                    {},
                                    "the file has longer numbers than certificates may be about (" +
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

bool Certification::file_has_changed() const {
  if (needs_copy()) return false;
  const Result<ByteBuffer> now = read_file_bytes(report_.path, settings_.reading.limits.max_bytes);
  return !now || to_hex(sha256({now->data(), now->size()})) != report_.sha256;
}

void Certification::conclude() {
  const bool valid = is_valid();
  report_.verdict = valid ? FileVerdict::kValid : FileVerdict::kInvalid;
  report_.exit = valid ? kExitValid : kExitInvalid;
  if (!keep_) return;
  const Result<std::string> kept = keep_(as_text(bytes_));
  if (kept) {
    report_.certificate->path = *kept;
    return;
  }
  report_.exit = first_of(report_.exit, kExitUnreadable);
  report_.fault = fault_of(kept.error());
}

std::string Certification::how_to_report() const {
  const std::string name = report_.path == "-" ? "FILE" : shell_word(report_.path);
  const std::string options = "--no-check --certificate bug.cert " + own_options();
  return "this is a bug of veritope, not of your file: please report it with the file, or with "
         "what this prints: veritope certify " +
         options + name + "; veritope-check " + name + " bug.cert; veritope --version";
}

}  // namespace veritope::cli
