// SPDX-License-Identifier: LGPL-3.0-or-later
// cli/certification.h: one run of certify on one file, whatever its kind: phases, the check by another process, the verdict.
#pragma once
#include <optional>
#include <string>
#include <utility>

#include "cli/certify.h"
#include "cli/checker_process.h"
#include "cli/scratch_file.h"
#include "io/base/file_bytes.h"
#include "robust/base/stopwatch.h"
#include "verify/format/mesh_certificate.h"

namespace veritope::cli {

class Certification {
 public:
  Certification(const std::string& path, const CertifySettings& settings,
                const KeepCertificate& keep, Progress& progress)
      : settings_(settings), keep_(keep), progress_(progress) {
    report_.path = path;
  }
  Certification(const Certification&) = delete;
  Certification& operator=(const Certification&) = delete;
  virtual ~Certification() = default;

  FileReport run();

 protected:
  // Each returns false after refuse() or give_up().
  virtual bool read() = 0;
  virtual bool decide() = 0;
  /// Leaves the certificate in bytes_ and report_.certificate.
  virtual bool certify() = 0;
  /// Of a decided file.
  virtual bool is_valid() const = 0;
  virtual std::string claim() const = 0;
  /// What give_up takes out of the report, beside the certificate.
  virtual void forget() = 0;
  /// Further options of a command line that repeats this run.
  virtual std::string own_options() const { return ""; }

  /// Always false.
  bool refuse(Fault fault);
  /// Always false. A verdict that nobody else confirmed is none, and its counts, defects and certificate are none.
  bool give_up(ExitCode exit, Fault fault);
  void phase(const char* what);
  /// Whether the input's name means another file in another process, or one that can be read once only; its bytes then are read here.
  bool needs_copy() const;
  Result<ByteBuffer> read_once();

  const CertifySettings& settings_;
  FileReport report_;
  Stopwatch watch_;
  certificate::Bytes bytes_;
  ByteBuffer spooled_;  ///< if needs_copy(): the input, for the checker

 private:
  bool check();
  bool judge_refusal(const CheckerOutcome& outcome);
  bool file_has_changed() const;
  void conclude();
  std::string how_to_report() const;

  const KeepCertificate& keep_;
  Progress& progress_;
  std::optional<ScratchFile> copy_;
};

/// Of a spline file: its patches. As certify_file.
FileReport certify_patch_file(const std::string& path, const CertifySettings& settings,
                              const KeepCertificate& keep, Progress& progress);

}  // namespace veritope::cli
