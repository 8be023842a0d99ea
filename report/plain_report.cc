// SPDX-License-Identifier: LGPL-3.0-or-later
// Reports about models of a kind that has no row of its own: the verdict, its findings, and the certificate.
#include "report/report_kinds_internal.h"

namespace veritope::report {
namespace {

void put_plain_source(const FileReport&, Json&) {}

Json plain_defect_json(const Finding& f) {
  return {{"code", f.code},
          {"message", f.message},
          {"line", optional_json(f.place.source.line)},
          {"byte", optional_json(f.place.source.byte)},
          {"entity", optional_json(f.place.source.entity)},
          {"point", f.place.near ? point_json(*f.place.near) : Json(nullptr)},
          {"box", box_json(f.place.box)}};
}

void put_plain_facts(const FileReport& report, Json& out) {
  out["defects"] = Json::array();
  for (const Finding& d : report.defects) out["defects"].push_back(plain_defect_json(d));
}

std::string plain_summary(const FileReport& report) {
  return report.defects.empty() ? "a solid" : harmless(report.defects.front().message);
}

std::string plain_findings(const FileReport& report, const TextOptions&) {
  std::string out;
  for (const Finding& d : report.defects)
    out += detail_line("defect", harmless(d.code + ": " + text_of(d)));
  return out;
}

std::string plain_details(const FileReport& report, const TextOptions&) {
  const auto& source = std::get<PlainSource>(report.source);
  return detail_line("file", source.format + ", " + counted(source.bytes, "byte", "bytes"));
}

}  // namespace

const internal::ReportKind internal::kPlainReports = {
    put_plain_source, put_plain_facts, false, plain_summary, plain_findings, plain_details};

}  // namespace veritope::report
