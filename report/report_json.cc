// SPDX-License-Identifier: LGPL-3.0-or-later
#include "report/report_json.h"

#include "report/report_kinds_internal.h"

namespace veritope::report {
namespace {

Json certificate_json(const std::optional<CertificateReport>& certificate) {
  if (!certificate) return nullptr;
  return {{"path", optional_json(certificate->path)},
          {"sha256", certificate->sha256},
          {"bytes", certificate->bytes},
          {"checked", certificate->is_checked}};
}

Json phases_json(const PhaseSeconds& s, bool has_collar) {
  Json out = {{"read", seconds_json(s.read)},
              {"decide", seconds_json(s.decide)},
              {"certify", seconds_json(s.certify)},
              {"draw", seconds_json(s.draw)},
              {"check", seconds_json(s.check)}};
  if (has_collar) out["collar"] = seconds_json(s.collar);
  return out;
}

}  // namespace

const internal::ReportKind& internal::kind_of(const FileReport& report) {
  if (std::holds_alternative<SplineSource>(report.source)) {
    const auto* const facts = std::get_if<PatchFacts>(&report.facts);
    return facts != nullptr && facts->vmodel ? kVModelReports : kPatchReports;
  }
  if (std::holds_alternative<PlainSource>(report.source)) {
    if (std::holds_alternative<DmsFacts>(report.facts)) return kDmsReports;
    return std::holds_alternative<MicroFacts>(report.facts) ? kMicroReports : kPlainReports;
  }
  return kMeshReports;
}

std::string report_json(const FileReport& report) {
  const internal::ReportKind& kind = internal::kind_of(report);
  Json out;
  out["path"] = report.path;
  out["sha256"] = text_json(report.sha256);
  out["bytes"] = optional_json(num_bytes(report));
  out["format"] = optional_json(format_name(report));
  kind.put_source(report, out);
  out["verdict"] = verdict_word(report.verdict);
  out["exit"] = static_cast<int>(report.exit);
  out["error"] = fault_json(report.fault);
  kind.put_facts(report, out);
  out["certificate"] = certificate_json(report.certificate);
  out["picture"] = optional_json(report.picture);
  out["seconds"] = phases_json(report.seconds, kind.has_collar);
  return dump(out);
}

std::string document_json(const std::string& schema, const std::vector<std::string>& files) {
  std::string out = "{\"schema\":\"" + schema + "\",\"tool\":\"" + tool_name() + "\",\"files\":[";
  for (std::size_t i = 0; i < files.size(); ++i) out += (i == 0 ? "\n" : ",\n") + files[i];
  return out + "\n]}\n";
}

}  // namespace veritope::report
