// SPDX-License-Identifier: LGPL-3.0-or-later
#include "report/micro_run_report.h"

#include <algorithm>

#include "report/decimal_text.h"
#include "report/json_text.h"
#include "report/report_text.h"
#include "report/text_style.h"
#include "verify/certify/certify.h"

namespace veritope::report {
namespace {

Json file_json(const std::optional<MicroRunReport::File>& file) {
  if (!file) return nullptr;
  return {{"path", file->path}, {"sha256", file->sha256}, {"bytes", file->bytes}};
}

Json mesh_of_run_json(const std::optional<MicroRunReport::Mesh>& mesh) {
  if (!mesh) return nullptr;
  return {{"file", file_json(mesh->file)},
          {"facets", mesh->facets},
          {"vertices", mesh->vertices},
          {"distance", mesh->distance}};
}

Json range_of_bridges_json(const BridgeRange& r) {
  return {{"lo", number_json(r.lo)}, {"hi", number_json(r.hi)}};
}

Json bridges_json(const std::optional<BridgeReport>& bridges) {
  if (!bridges) return nullptr;
  Json dropped;
  for (std::size_t i = 0; i < kNumBridgeDrops; ++i)
    dropped[bridge_drop_name(static_cast<BridgeDrop>(i))] = bridges->dropped[i];
  return {{"caps", bridges->caps},
          {"built", bridges->built},
          {"dropped", dropped},
          {"kink_degrees", range_of_bridges_json(bridges->kink)},
          {"reach", range_of_bridges_json(bridges->reach)}};
}

std::string bridges_line(const BridgeReport& bridges, const char* one = "cap",
                         const char* many = "caps") {
  std::string text = std::to_string(bridges.built) + " of " + counted(bridges.caps, one, many);
  bool is_first = true;
  for (std::size_t i = 0; i < kNumBridgeDrops; ++i) {
    if (bridges.dropped[i] == 0) continue;
    text += (is_first ? "; not built: " : ", ") + std::to_string(bridges.dropped[i]) + " " +
            bridge_drop_name(static_cast<BridgeDrop>(i));
    is_first = false;
  }
  return detail_line("bridges", text);
}

Json composed_json(const std::optional<MicroRunReport::Composed>& composed) {
  if (!composed) return nullptr;
  return {{"file", file_json(composed->file)},
          {"patches", composed->patches},
          {"curves", composed->curves},
          {"bridges", composed->bridges},
          {"bridges_left_out", composed->bridges_left_out}};
}

// Names the first bridges that the composed surface lacks.
std::string left_out_line(const MicroRunReport::Composed& composed) {
  constexpr std::size_t kMostNamed = 8;
  const auto& numbers = composed.bridges_left_out;
  std::string text = counted(numbers.size(), "bridge", "bridges") +
                     " not composed, because a knot of the cage crosses " +
                     (numbers.size() == 1 ? "it" : "them") + ":";
  for (std::size_t i = 0; i < std::min(numbers.size(), kMostNamed); ++i)
    text += (i == 0 ? " " : ", ") + std::to_string(numbers[i]);
  return detail_line("left out", text + (numbers.size() > kMostNamed ? ", ..." : ""));
}

Json micro_bounds_json(const std::optional<MicroRunReport::Bounds>& b) {
  if (!b) return nullptr;
  return {{"lo", b->lo}, {"hi", b->hi}};
}

Json defect_in_run_json(const MicroRunReport::Defect& d) {
  Json cell = nullptr;
  if (d.cell)
    cell = {{"volume", (*d.cell)[0]},
            {"at", Json::array({(*d.cell)[1], (*d.cell)[2], (*d.cell)[3]})}};
  return {{"code", d.code},
          {"tile", optional_json(d.tile)},
          {"cell", cell},
          {"wall", optional_json(d.wall)},
          {"message", d.message}};
}

// The middle of bounds that differ by less than a millionth; of others both.
std::string bounds_text(const MicroRunReport::Bounds& b) {
  if (b.hi - b.lo <= 1e-6 * b.hi) return short_decimal(b.lo + (b.hi - b.lo) / 2);
  return short_decimal(b.lo) + " to " + short_decimal(b.hi);
}

// Bounds that may be one per cent apart.
std::string clearance_text(const MicroRunReport::Bounds& b) {
  const std::string lo = short_decimal(b.lo), hi = short_decimal(b.hi);
  return lo == hi ? lo : lo + " to " + hi;
}

Json outer_json(const std::optional<MicroRunReport::Outer>& outer) {
  if (!outer) return nullptr;
  return {{"total", outer->cells},       {"kept", outer->kept},
          {"crossing", outer->crossing}, {"touching", outer->touching},
          {"outside", outer->outside},   {"undecided", outer->undecided},
          {"volumes", outer->volumes}};
}

// The cells that were compared with the model.
std::string cells_line(const MicroRunReport& r) {
  const MicroRunReport::Outer n = r.outer.value_or(
      MicroRunReport::Outer{r.cells, r.kept, r.crossing, r.touching, r.outside, r.undecided, 0});
  return detail_line("cells", std::to_string(n.crossing) + " cross the boundary of the model, " +
                                  std::to_string(n.touching) + " touch it, " +
                                  std::to_string(n.outside) + " lie outside, " +
                                  std::to_string(n.undecided) + " undecided");
}

// Lines about curves and sheets: no claim is made of them.
std::string open_run_text(const MicroRunReport& r) {
  std::string text;
  if (r.composed) {
    const std::uint64_t sheets = r.composed->patches - r.composed->curves;
    std::string shapes;
    if (r.composed->curves != 0) shapes = counted(r.composed->curves, "curve", "curves");
    if (sheets != 0) shapes += (shapes.empty() ? "" : ", ") + counted(sheets, "sheet", "sheets");
    text = "wrote  " + unbroken(harmless(r.composed->file.path)) + "  " + shapes + " of " +
           counted(r.kept, "tile", "tiles") +
           (r.bridges ? ", " + counted(r.bridges->built, "bridge", "bridges") : "") + " in " +
           counted(r.cells, "cell", "cells") + "\n";
    if (r.bridges) text += bridges_line(*r.bridges, "free end", "free ends");
  } else if (r.cells != 0 && r.kept == 0 && r.defects.empty()) {
    text = "wrote nothing: no tile is kept in " + counted(r.cells, "cell", "cells") + "\n";
  }
  return r.model && !text.empty() ? text + cells_line(r) : text;
}

}  // namespace

std::string micro_run_json(const MicroRunReport& r) {
  Json out, defects = Json::array();
  for (const auto& d : r.defects) defects.push_back(defect_in_run_json(d));
  const auto counted_in = [&](auto member) {
    return r.counts ? Json((*r.counts).*member) : Json(nullptr);
  };
  out["schema"] = "veritope-micro-1";
  out["tool"] = tool_name();
  out["cage"] = file_json(r.cage);
  out["model"] = file_json(r.model);
  out["output"] = file_json(r.output);
  out["tiles"] = {{"total", r.cells},       {"kept", r.kept},       {"crossing", r.crossing},
                  {"touching", r.touching}, {"outside", r.outside}, {"undecided", r.undecided},
                  {"floating", r.floating}};
  out["outer"] = outer_json(r.outer);
  out["kinds"] = r.kinds;
  out["bridges"] = bridges_json(r.bridges);
  out["components"] = counted_in(&MicroCounts::components);
  out["glued_caps"] = counted_in(&MicroCounts::glued_caps);
  out["genus"] = counted_in(&MicroCounts::genus);
  out["shells"] = counted_in(&MicroCounts::shells);
  out["volume"] = micro_bounds_json(r.volume);
  out["density"] = micro_bounds_json(r.density);
  out["scale"] = micro_bounds_json(r.scale);
  out["clearance"] = micro_bounds_json(r.clearance);
  out["mesh"] = mesh_of_run_json(r.mesh);
  out["composed"] = composed_json(r.composed);
  out["defects"] = std::move(defects);
  out["seconds"] = {
      {"cage", seconds_json(r.seconds.cage)},       {"filter", seconds_json(r.seconds.filter)},
      {"bridge", seconds_json(r.seconds.bridge)},   {"topology", seconds_json(r.seconds.topology)},
      {"measure", seconds_json(r.seconds.measure)}, {"mesh", seconds_json(r.seconds.mesh)},
      {"compose", seconds_json(r.seconds.compose)}};
  return dump(out) + "\n";
}

std::string micro_run_text(const MicroRunReport& r) {
  if (r.is_open) return open_run_text(r);
  if (!r.output || !r.counts) return "";
  std::string text = "wrote  " + unbroken(harmless(r.output->path)) + "  " +
                     counted(r.kept, "tile", "tiles") +
                     (r.bridges ? ", " + counted(r.bridges->built, "bridge", "bridges") : "") +
                     " in " + counted(r.cells, "cell", "cells") + ", " +
                     counted(r.counts->components, "component", "components") + ", genus " +
                     std::to_string(r.counts->genus) + "\n";
  if (r.mesh)
    text += "wrote  " + unbroken(harmless(r.mesh->file.path)) + "  " +
            counted(r.mesh->facets, "facet", "facets") + ", a solid, within " +
            short_decimal(r.mesh->distance) + " of it\n";
  if (r.composed)
    text += "wrote  " + unbroken(harmless(r.composed->file.path)) + "  " +
            counted(r.composed->patches, "patch", "patches") + "\n";
  if (r.composed && !r.composed->bridges_left_out.empty()) text += left_out_line(*r.composed);
  if (r.volume && r.density)
    text += detail_line("volume", bounds_text(*r.volume) + ", " +
                                      bounds_text({100 * r.density->lo, 100 * r.density->hi}) +
                                      " % of the cells");
  if (r.clearance)
    text += detail_line(
        "clearance", clearance_text(*r.clearance) + " from the tiles to the surface of the model");
  if (r.wants_surface && r.kept == 0)
    text += detail_line("surface", "none is written, because no tile is kept");
  if (r.floating != 0)
    text += detail_line("floating", counted(r.floating, "tile", "tiles") + " off the largest part");
  if (r.bridges) text += bridges_line(*r.bridges);
  if (r.outer)
    text += detail_line("nested", counted(r.outer->volumes, "volume", "volumes") + " of " +
                                      counted(r.outer->kept, "outer tile", "outer tiles"));
  return r.model ? text + cells_line(r) : text;
}

}  // namespace veritope::report
