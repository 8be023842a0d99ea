// SPDX-License-Identifier: LGPL-3.0-or-later
#include "report/report_text.h"

#include <algorithm>

#include "report/decimal_text.h"
#include "report/report_kinds_internal.h"
#include "report/totals.h"

namespace veritope::report {
namespace {

std::string coloured(std::optional<Verdict> verdict, const Style& style) {
  const std::string word = verdict_word(verdict);
  if (verdict == Verdict::kValid) return style.green(word);
  return verdict == Verdict::kInvalid ? style.red(word) : style.yellow(word);
}

std::string checked_summary(const FileReport& report) {
  if (!report.has_verdict()) return summary_text(report);
  const bool is_checked = report.certificate && report.certificate->is_checked;
  return summary_text(report) + (is_checked ? " (checked)" : " (not checked)");
}

std::string certificate_text(const FileReport& report) {
  if (!report.certificate) return "";
  const CertificateReport& c = *report.certificate;
  std::string text = c.path ? unbroken(harmless(*c.path)) : "not kept (--certificate F keeps it)";
  text += ", " + counted(c.bytes, "byte", "bytes");
  text += c.is_checked ? ", accepted by veritope-check" : ", not checked (--no-check)";
  return detail_line("certificate", text);
}

// What was certified, if not the file as it stands.
std::string certified_text(const FileReport& report) {
  if (!report.copy)
    return report.boundary_faces
               ? detail_line("certified", *report.boundary_faces + ", not their cells")
               : "";
  const CopyReport& c = *report.copy;
  std::string text = c.what + (c.is_of_volumes ? ", not their cells" : "") + ", as ." + c.format;
  if (c.path)
    text += " in " + unbroken(harmless(*c.path));
  else if (report.certificate && !report.certificate->path)
    text += " (--certificate F keeps it, too)";
  return detail_line("certified", text);
}

std::string picture_text(const FileReport& report) {
  return report.picture ? detail_line("picture", unbroken(harmless(*report.picture))) : "";
}

constexpr std::size_t kVerdictWidth = 10;  // "UNREADABLE"

std::string filler(std::size_t size, std::size_t width) {
  return std::string(width - std::min(size, width), ' ');
}

// A run of more than a second, with the phase that took longest.
std::string seconds_text(const PhaseSeconds& seconds) {
  const auto [total, longest] = total_and_longest(seconds);
  if (total < 1) return "";
  return detail_line("time", short_decimal(total, 2) + " s, of which " +
                                 short_decimal(longest.seconds, 2) + " s " + longest.name);
}

}  // namespace

std::string shown_path(const std::string& path) {
  return path == "-" ? "standard input" : harmless(path);
}

std::string summary_text(const FileReport& report) {
  if (report.has_verdict()) return internal::kind_of(report).summary(report);
  return report.fault ? harmless(text_of(*report.fault)) : "";
}

TextOptions TextOptions::of_stdout() {
  TextOptions out;
  out.style = style_of_stdout();
  out.verdict_width = report::verdict_width();
  out.width = report_width();
  out.shows_seconds = out.verdict_width != kNoWidth;
  return out;
}

std::string verdict_line(const FileReport& report, const TextOptions& options) {
  const std::string path = unbroken(shown_path(report.path));
  const bool is_table = options.path_width != 0;
  const std::size_t verdict_size = std::string_view(verdict_word(report.verdict)).size();
  const std::string line = coloured(report.verdict, options.style) +
                           unbroken(filler(verdict_size, is_table ? kVerdictWidth : 0)) + "  " +
                           path + unbroken(filler(columns(path), options.path_width)) + "  " +
                           checked_summary(report) + "\n";
  return fold(line, options.verdict_width);
}

std::string details_text(const FileReport& report, const TextOptions& options) {
  const internal::ReportKind& kind = internal::kind_of(report);
  return fold(kind.findings(report, options) + kind.details(report, options) +
                  certificate_text(report) + certified_text(report) + picture_text(report) +
                  (options.shows_seconds ? seconds_text(report.seconds) : ""),
              options.width);
}

}  // namespace veritope::report
