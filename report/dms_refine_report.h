// SPDX-License-Identifier: LGPL-3.0-or-later
// report/dms_refine_report.h: what veritope dms refine says of a new vertex.
#pragma once
#include <cstdint>
#include <optional>
#include <string>

#include "solids/dms/dms_insert.h"

namespace veritope::report {

struct DmsRefineReport {
  std::string path, sha256, output;
  std::uint64_t bytes = 0;
  DmsPoint at;
  std::optional<Rational> max_change;
  DmsDefects defects;                     ///< of the model, else of the refined one
  std::optional<DmsInsertion> insertion;  ///< nothing if the model has defects
  bool is_written = false;
  double seconds = 0;
};

/// Whether each component changes by at most so much, as far as is proved.
bool is_within(const DmsInsertion& insertion, const Rational& max_change);

/// The schema: docs/report.schema.json, dms_refine.
std::string dms_refine_json(const DmsRefineReport& report);

/// One line for what was cut and one for each component that changes. REQUIRES an insertion without defects.
std::string dms_refine_text(const DmsRefineReport& report);

}  // namespace veritope::report
