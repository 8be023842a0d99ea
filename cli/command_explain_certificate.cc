// SPDX-License-Identifier: LGPL-3.0-or-later
// veritope explain-certificate.
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <span>

#include "cli/commands.h"
#include "io/base/file_bytes.h"
#include "report/text_style.h"
#include "verify/format/claims.h"

namespace veritope::cli {

using namespace report;
namespace {

struct ExplainCertificateOptions {
  std::string file;
  std::uint64_t max_items = 20;
};

ExitCode run(const ExplainCertificateOptions& options, StandardOutput& out) {
  const Result<ByteBuffer> bytes =
      read_file_bytes(options.file, std::numeric_limits<std::uint64_t>::max());
  if (!bytes) {
    complain(harmless(to_string(bytes.error())));
    return kExitUnreadable;
  }
  const std::span<const unsigned char> file(bytes->data(), bytes->size());
  std::string why;
  std::optional<std::string> text = certificate::explain_certificate(file, options.max_items, why);
  if (!text) {
    complain(harmless(options.file +
                      ": not a certificate, as certify --certificate F writes it: " + why));
    return kExitUnreadable;
  }
  // A certificate may come from anywhere: its strings must not drive the terminal.
  for (char& c : *text) {
    if (static_cast<unsigned char>(c) < 32 && c != '\n') c = '?';
  }
  out.write(fold(*text, verdict_width()));
  return kExitValid;
}

}  // namespace

RunCommand declare_explain_certificate(OptionSet& set) {
  const auto o = std::make_shared<ExplainCertificateOptions>();
  declare_plain_file(set, "F", o->file, "a certificate file");
  set.number("--max-items", o->max_items, {0, kMost32}, "show at most N items of each list (20)");
  return [o](StandardOutput& out) { return run(*o, out); };
}

}  // namespace veritope::cli
