// SPDX-License-Identifier: LGPL-3.0-or-later
#include "report/weld_report.h"

#include <algorithm>

#include "report/decimal_text.h"
#include "report/json_text.h"
#include "report/text_style.h"
#include "solids/vmodel/v_parts.h"
#include "verify/certify/certify.h"

namespace veritope::report {
namespace {

constexpr std::size_t kMostWelds = 20;  // of the text

Json cell_face_json(VFaceNumber f) { return {{"cell", f / 6}, {"part", v_face_name(f % 6)}}; }
Json length_json(const Rational& length) {
  return {{"exact", length.to_string()}, {"decimal", number_json(nearest_double(length))}};
}

std::string cell_face_text(VFaceNumber f) {
  return "cell " + std::to_string(f / 6) + " " + v_face_name(f % 6);
}
std::string length_text(const Rational& length) { return short_decimal(round_up(length), 3); }

std::string apart_text(const VApartPair& pair) {
  const std::string distance =
      pair.distance ? "they differ by " + length_text(*pair.distance) : std::string();
  switch (pair.reason) {
    case VApartReason::kControlPoints: return distance;
    case VApartReason::kWeights: return "their weights are not proportional";
    case VApartReason::kSeveral: return distance + ", and one of them is near to several faces";
    case VApartReason::kGlued: return distance + ", and the second is glued to another face";
    case VApartReason::kTooFar:
      return distance + ", but faces that are near in a row would move too far";
    case VApartReason::kCollapse: return distance + ", but an edge or a face would collapse";
  }
  return distance;
}

std::string and_more(std::size_t count) {
  return count <= kMostWelds
             ? ""
             : "  and " + std::to_string(count - kMostWelds) + " more, which --json lists\n";
}

}  // namespace

std::string weld_json(const WeldReport& report) {
  const VWeld& weld = report.weld;
  Json out, welded = Json::array(), apart = Json::array();
  for (const VWeldedPair& pair : weld.welded)
    welded.push_back({{"winner", cell_face_json(pair.winner)},
                      {"loser", cell_face_json(pair.loser)},
                      {"symmetry", pair.symmetry},
                      {"distance", length_json(pair.distance)},
                      {"displacement", length_json(pair.displacement)}});
  for (const VApartPair& pair : weld.apart) {
    Json faces = Json::array({cell_face_json(pair.first), cell_face_json(pair.second)});
    apart.push_back({{"faces", std::move(faces)},
                     {"because", v_apart_reason_name(pair.reason)},
                     {"distance", pair.distance ? length_json(*pair.distance) : Json(nullptr)}});
  }
  out["schema"] = "veritope-weld-1";
  out["tool"] = tool_name();
  out["input"] = {{"path", report.path}, {"sha256", report.sha256}};
  out["output"] = {{"path", report.output_path},
                   {"sha256", report.output_sha256},
                   {"bytes", report.output_bytes}};
  out["eps"] = report.eps.to_string();
  out["counts"] = {{"cells", report.num_cells},
                   {"changed", weld.changed.size()},
                   {"glued_before", weld.glued_before},
                   {"glued_after", weld.glued_after}};
  out["welded"] = std::move(welded);
  out["apart"] = std::move(apart);
  out["largest_displacement"] = length_json(weld.largest_displacement);
  out["farthest_cell"] = optional_json(weld.farthest);
  out["seconds"] = seconds_json(report.seconds);
  return dump(out) + "\n";
}

std::string weld_text(const WeldReport& report) {
  const VWeld& weld = report.weld;
  std::string text = "  glued: " + counted(weld.glued_after, "pair", "pairs") + " of faces, " +
                     std::to_string(weld.glued_before) + " before; " +
                     counted(weld.changed.size(), "cell changes", "cells change");
  if (weld.farthest)
    text += ", by at most " + length_text(weld.largest_displacement) + " (cell " +
            std::to_string(*weld.farthest) + ")";
  text += "\n";
  for (std::size_t i = 0; i < std::min(kMostWelds, weld.welded.size()); ++i) {
    const VWeldedPair& pair = weld.welded[i];
    text += "  welded: " + cell_face_text(pair.winner) + " and " + cell_face_text(pair.loser) +
            ", moved by at most " + length_text(pair.displacement) + "\n";
  }
  text += and_more(weld.welded.size());
  for (std::size_t i = 0; i < std::min(kMostWelds, weld.apart.size()); ++i) {
    const VApartPair& pair = weld.apart[i];
    text += "  apart: " + cell_face_text(pair.first) + " and " + cell_face_text(pair.second) +
            ": " + apart_text(pair) + "\n";
  }
  return text + and_more(weld.apart.size());
}

}  // namespace veritope::report
