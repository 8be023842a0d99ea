// SPDX-License-Identifier: LGPL-3.0-or-later
// Reports about microstructures: how many tiles they have and how these hang together; where a condition of their
// certificate is not proved to hold.
#include "report/decimal_text.h"
#include "report/report_kinds_internal.h"

namespace veritope::report {
namespace {

const MicroFacts& micro_of(const FileReport& report) { return std::get<MicroFacts>(report.facts); }

void put_micro_source(const FileReport&, Json&) {}

Json cell_part_json(const EntityPart& part) {
  Json box = Json::array();
  for (const auto& [lo, hi] : part.parameters) box.push_back(Json::array({lo, hi}));
  return {{"volume", part.entity}, {"box", std::move(box)}};
}

Json micro_reason_json(const Finding& f) {
  Json parts = Json::array();
  for (const EntityPart& part : f.place.parts) parts.push_back(cell_part_json(part));
  return {{"code", f.code}, {"message", f.message}, {"parts", std::move(parts)}};
}

// What is proved: null without --model.
Json inside_json(const FileReport& report) {
  const std::optional<InsideFacts>& f = micro_of(report).inside;
  if (report.verdict != Verdict::kValid || !report.inside || !f) return nullptr;
  const InsideReport& m = *report.inside;
  return {
      {"model", {{"path", m.path}, {"sha256", m.sha256}, {"bytes", m.bytes}, {"format", m.format}}},
      {"voids", f->voids},
      {"skin", f->skin ? Json(f->skin->to_string()) : Json(nullptr)}};
}
std::string inside_line(const FileReport& report) {
  const std::optional<InsideFacts>& f = micro_of(report).inside;
  if (!report.inside || !f) return "";
  std::string text = report.inside->path + ", in its interior";
  if (f->voids != 0) text += " off its " + counted(f->voids, "void", "voids");
  if (f->skin)
    text += "; ends of bridges are at most " + short_decimal(round_up(*f->skin), 6) +
            " from its surface";
  return detail_line("model", text);
}

void put_micro_facts(const FileReport& report, Json& out) {
  const MicroFacts& f = micro_of(report);
  const MicroCounts& n = f.counts;
  const bool is_valid = report.verdict == Verdict::kValid;
  const auto if_valid = [&](auto number) { return is_valid ? Json(number) : Json(nullptr); };
  out["counts"] = {{"volumes", f.volumes},
                   {"kinds", f.kinds},
                   {"cells", n.cells},
                   {"tiles", n.tiles},
                   {"bridges", n.bridges},
                   {"glued_caps", if_valid(n.glued_caps)},
                   {"components", if_valid(n.components)},
                   {"shells", if_valid(n.shells)},
                   {"genus", if_valid(n.genus)}};
  out["inside"] = inside_json(report);
  out["reasons"] = Json::array();
  for (const Finding& r : report.reasons) out["reasons"].push_back(micro_reason_json(r));
}

std::string micro_summary(const FileReport& report) {
  const MicroCounts& n = micro_of(report).counts;
  const std::string bridges = n.bridges == 0 ? "" : counted(n.bridges, "bridge", "bridges") + ", ";
  return counted(n.tiles, "tile", "tiles") + ", " + bridges +
         counted(n.components, "component", "components") + ", genus " + std::to_string(n.genus) +
         (report.inside ? ", inside " + report.inside->path : "");
}

std::string micro_findings(const FileReport&, const TextOptions&) { return ""; }

std::string micro_details(const FileReport& report, const TextOptions&) {
  const auto& source = std::get<PlainSource>(report.source);
  const MicroFacts& f = micro_of(report);
  std::string out =
      detail_line("file", source.format + ", " + counted(source.bytes, "byte", "bytes")) +
      detail_line("cage", counted(f.volumes, "volume", "volumes") + ", " +
                              counted(f.counts.cells, "cell", "cells"));
  if (report.verdict != Verdict::kValid) return out;
  return out +
         detail_line("tiles", counted(f.counts.tiles, "tile", "tiles") + ", " +
                                  counted(f.counts.glued_caps, "glued cap", "glued caps") + ", " +
                                  counted(f.counts.shells, "shell", "shells")) +
         inside_line(report);
}

}  // namespace

const internal::ReportKind internal::kMicroReports = {
    put_micro_source, put_micro_facts, false, micro_summary, micro_findings, micro_details};

}  // namespace veritope::report
