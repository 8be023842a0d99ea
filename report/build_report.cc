// SPDX-License-Identifier: LGPL-3.0-or-later
#include "report/build_report.h"

#include <algorithm>

#include "report/decimal_text.h"
#include "report/json_text.h"
#include "report/text_style.h"
#include "verify/certify/certify.h"

namespace veritope::report {
namespace {

constexpr std::size_t kMostNotes = 20;  // of the text

Json angle_json(const BuildReport::Note& note) {
  if (!note.degrees) return nullptr;
  return {{"degrees", note.degrees->to_string()},
          {"lo", (*note.degrees - *note.error).to_string()},
          {"hi", (*note.degrees + *note.error).to_string()}};
}

Json matrix_json(const BuildReport::Note& note) {
  if (!note.determinant) return nullptr;
  return {{"determinant", note.determinant->to_string()},
          {"distance_from_rotation", note.distance_from_rotation->to_string()}};
}

std::string exact_or(const Rational& x, const char* exact, const std::string& before) {
  return x.sign() == Sign::kZero ? exact : before + short_decimal(round_up(x));
}

std::string note_text(const BuildReport::Note& note) {
  std::string text = "  " + note.pointer + ": ";
  if (note.degrees)
    return text + short_decimal(nearest_double(*note.degrees)) + " degrees" +
           exact_or(*note.error, ", exactly", ", within ") + "\n";
  return text + "the matrix is " +
         exact_or(*note.distance_from_rotation, "a rotation", "off a rotation by ") +
         (note.determinant->sign() == Sign::kNegative ? " and mirrors" : "") + "\n";
}

}  // namespace

std::string build_json(const BuildReport& report) {
  Json out, notes = Json::array();
  for (const auto& note : report.notes)
    notes.push_back({{"pointer", note.pointer},
                     {"op", note.op},
                     {"angle", angle_json(note)},
                     {"matrix", matrix_json(note)}});
  out["schema"] = "veritope-build-1";
  out["tool"] = tool_name();
  out["input"] = {{"path", report.path}, {"sha256", report.sha256}};
  out["output"] = {{"path", report.output_path},
                   {"sha256", report.output_sha256},
                   {"bytes", report.output_bytes}};
  out["counts"] = {{"cells", report.cells},
                   {"control_points", report.control_points},
                   {"nodes", report.nodes},
                   {"files", report.files}};
  out["notes"] = notes;
  out["seconds"] = seconds_json(report.seconds);
  return dump(out) + "\n";
}

std::string build_text(const BuildReport& report) {
  std::string text = "wrote  " + unbroken(harmless(report.output_path)) + "  " +
                     counted(report.cells, "cell", "cells") + ", " +
                     counted(report.control_points, "control point", "control points") + "\n";
  for (std::size_t i = 0; i < std::min(kMostNotes, report.notes.size()); ++i)
    text += note_text(report.notes[i]);
  if (report.notes.size() > kMostNotes)
    text +=
        "  and " + std::to_string(report.notes.size() - kMostNotes) + " more, which --json lists\n";
  return text;
}

}  // namespace veritope::report
