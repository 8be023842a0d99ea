// SPDX-License-Identifier: LGPL-3.0-or-later
#include "report/report_text.h"

#include "report/report_kinds_internal.h"

namespace veritope::report {
namespace {

std::string coloured(std::optional<Verdict> verdict, const Style& style) {
  const std::string word = verdict_word(verdict);
  if (verdict == Verdict::kValid) return style.green(word);
  return verdict == Verdict::kInvalid ? style.red(word) : style.yellow(word);
}

std::string checked_summary(const FileReport& report) {
  if (!report.has_verdict()) return report.fault ? harmless(text_of(*report.fault)) : "";
  const bool is_checked = report.certificate && report.certificate->is_checked;
  return internal::kind_of(report).summary(report) + (is_checked ? " (checked)" : " (not checked)");
}

std::string certificate_text(const FileReport& report) {
  if (!report.certificate) return "";
  const CertificateReport& c = *report.certificate;
  std::string text = c.path ? harmless(*c.path) : "not kept (--certificate F keeps it)";
  text += ", " + counted(c.bytes, "byte", "bytes");
  text += c.is_checked ? ", accepted by veritope-check" : ", not checked (--no-check)";
  return detail_line("certificate", text);
}

std::string copy_text(const FileReport& report) {
  if (!report.copy) return "";
  const CopyReport& c = *report.copy;
  std::string text = c.what + (c.is_of_volumes ? ", not their cells" : "") + ", as .vjson";
  if (c.path)
    text += " in " + harmless(*c.path);
  else if (report.certificate && !report.certificate->path)
    text += " (--certificate F keeps it, too)";
  return detail_line("certified", text);
}

}  // namespace

std::string shown_path(const std::string& path) {
  return path == "-" ? "standard input" : harmless(path);
}

std::string verdict_line(const FileReport& report, const Style& style) {
  return coloured(report.verdict, style) + "  " + shown_path(report.path) + "  " +
         checked_summary(report) + "\n";
}

std::string details_text(const FileReport& report, const TextOptions& options) {
  const internal::ReportKind& kind = internal::kind_of(report);
  return kind.details(report, options) + certificate_text(report) + copy_text(report) +
         kind.last_details(report, options);
}

}  // namespace veritope::report
