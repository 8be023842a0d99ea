// SPDX-License-Identifier: LGPL-3.0-or-later
#include "report/chain_report.h"

#include <algorithm>

#include "report/decimal_text.h"
#include "report/json_text.h"
#include "report/text_style.h"
#include "verify/certify/certify.h"

namespace veritope::report {
namespace {

Json hypothesis_json(const ChainReport::Hypothesis& h) {
  return {{"holds", optional_json(h.holds)},
          {"violations", h.violations},
          {"first", text_json(h.first)}};
}

Json coordinates_json(const std::array<Rational, 3>& p) {
  return Json::array({p[0].to_string(), p[1].to_string(), p[2].to_string()});
}

std::string counts_text(const ChainReport::Counts& c) {
  std::string out = std::to_string(c.plus) + " plus, " + std::to_string(c.minus) + " minus, " +
                    std::to_string(c.zero) + " zero";
  if (c.mixed > 0) out += ", " + std::to_string(c.mixed) + " mixed";
  if (c.open > 0) out += ", " + std::to_string(c.open) + " undecided";
  return out;
}

std::string hypothesis_text(const ChainReport::Hypothesis& h, const std::string& places) {
  const std::string all = std::to_string(h.places) + " " + places;
  if (h.holds == true) return "hold at all " + all;
  std::string out = h.holds ? "fail at " + std::to_string(h.violations) : "undecided";
  if (h.undecided > 0) out += (h.holds ? ", undecided at " : " at ") + std::to_string(h.undecided);
  return out + " of " + all + "; " + h.first;
}

std::string cells_text(const ChainReport& r) {
  std::string out = std::to_string(r.plus_cells) + " plus, " + std::to_string(r.minus_cells) +
                    " minus; " + counted(r.split, "patch", "patches") + " split";
  if (r.undecided_cells > 0) out += ", " + std::to_string(r.undecided_cells) + " undecided";
  if (r.without_wedge > 0) out += ", " + std::to_string(r.without_wedge) + " without a wedge";
  return detail_line("own cells", out);
}

std::string refused_text(const std::vector<ChainReport::Refusal>& refused) {
  constexpr std::size_t kMostShown = 5;
  std::string out;
  for (std::size_t i = 0; i < std::min(kMostShown, refused.size()); ++i)
    out += detail_line(i == 0 ? "refused" : "",
                       "as in figure " + refused[i].figure + ": " + refused[i].why);
  if (refused.size() > kMostShown)
    out += detail_line("", std::to_string(refused.size() - kMostShown) + " more");
  return out;
}

std::string origins_text(const std::vector<ChainReport::Origin>& origins) {
  std::size_t width = 0;
  for (const auto& o : origins) width = std::max(width, columns(o.name));
  std::string out;
  for (const auto& o : origins)
    out += detail_line(&o == &origins.front() ? "cell tests" : "",
                       unbroken(o.name + std::string(width - columns(o.name) + 2, ' ') +
                                short_decimal(o.cell_tests, 6)));
  return out;
}

}  // namespace

std::string chain_json(const ChainReport& report) {
  Json out, origins = Json::array();
  for (const auto& o : report.origins)
    origins.push_back({{"origin", coordinates_json(o.point)}, {"cell_tests", o.cell_tests}});
  out["schema"] = "veritope-chain-report-1";
  out["tool"] = tool_name();
  out["model"] = {{"path", report.path}, {"sha256", report.sha256}};
  out["simplices"] = {{"plus", report.simplices.plus},
                      {"minus", report.simplices.minus},
                      {"zero", report.simplices.zero}};
  out["free_form"] = {{"plus", report.free_form.plus},
                      {"minus", report.free_form.minus},
                      {"zero", report.free_form.zero},
                      {"mixed", report.free_form.mixed},
                      {"undecided", report.free_form.open}};
  out["normal"] = report.is_normal;
  out["literal"] = {{"planes_share_lines", hypothesis_json(report.planes_share_lines)},
                    {"curves_in_planes", hypothesis_json(report.curves_in_planes)},
                    {"graphs", hypothesis_json(report.graphs)}};
  Json refused = Json::array();
  for (const auto& r : report.refused) refused.push_back({{"figure", r.figure}, {"cell", r.why}});
  out["cells"] = {{"plus", report.plus_cells},
                  {"minus", report.minus_cells},
                  {"split", report.split},
                  {"undecided", report.undecided_cells},
                  {"without_wedge", report.without_wedge},
                  {"connected", hypothesis_json(report.connected)},
                  {"one_side", hypothesis_json(report.on_one_side)},
                  {"vertices", hypothesis_json(report.with_vertices_on_patch)},
                  {"refused", refused}};
  out["origins"] = origins;
  return dump(out) + "\n";
}

std::string chain_text(const ChainReport& report) {
  return detail_line("simplices", counts_text(report.simplices)) +
         detail_line("free-form", counts_text(report.free_form)) +
         detail_line("normal", report.is_normal ? "yes" : "no") +
         detail_line("planes", hypothesis_text(report.planes_share_lines, "vertices")) +
         detail_line("curves", hypothesis_text(report.curves_in_planes, "edges")) +
         detail_line("graphs", hypothesis_text(report.graphs, "base triangles")) +
         cells_text(report) +
         (report.connected.places == 0
              ? std::string()
              : detail_line("connected", hypothesis_text(report.connected, "cells")) +
                    detail_line("one side", hypothesis_text(report.on_one_side, "cells")) +
                    detail_line("vertices",
                                hypothesis_text(report.with_vertices_on_patch, "cells"))) +
         refused_text(report.refused) + origins_text(report.origins);
}

}  // namespace veritope::report
