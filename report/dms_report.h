// SPDX-License-Identifier: LGPL-3.0-or-later
// report/dms_report.h: what veritope dms eval says of points, and dms iso of a surface.
#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "robust/rational.h"
#include "solids/dms/dms_defects.h"
#include "solids/dms/dms_iso.h"

namespace veritope::report {

/// One point of the file. All lists are empty outside of the domain, gradients if they were not wanted, too.
struct DmsPointReport {
  std::optional<std::uint32_t> tetrahedron;
  /// With fractions.
  std::vector<Rational> value;
  std::vector<std::array<Rational, 3>> gradient;
  /// Without: numbers within the bounds, and the bounds; infinite ones are beyond binary64.
  std::vector<double> number, lo, hi;
  std::vector<std::array<double, 3>> gradient_lo, gradient_hi;
};

struct DmsEvalReport {
  std::string path, sha256;
  std::uint64_t bytes = 0;
  int degree = 0;
  std::vector<std::string> attributes;
  bool is_exact = false;  ///< fractions, not enclosures
  DmsDefects defects;     ///< with them there are no points
  std::vector<DmsPointReport> points;
  double seconds = 0;
};

/// The schema: docs/report.schema.json, dms_eval. One line a point.
std::string dms_eval_json(const DmsEvalReport& report);

/// One line: the numbers of the value as fractions, or binary64 ones with 17 digits; "outside".
std::string dms_point_text(const DmsPointReport& point);

struct DmsIsoReport {
  std::string path, sha256;
  std::uint64_t bytes = 0;
  std::string attribute;
  Rational level, within;
  bool in_solid = false;
  DmsDefects defects;
  std::optional<DmsIso> iso;  ///< nothing if there are defects
  double seconds = 0;
};

/// The schema: docs/report.schema.json, dms_iso.
std::string dms_iso_json(const DmsIsoReport& report);

}  // namespace veritope::report
