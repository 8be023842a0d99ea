// SPDX-License-Identifier: LGPL-3.0-or-later
// report/dms_fit_report.h: what veritope dms fit says of a fit.
#pragma once
#include <cstdint>
#include <optional>
#include <string>

#include "solids/dms/dms_defects.h"
#include "solids/dms/fit/dms_fit.h"

namespace veritope::report {

/// The file of the domain.
struct DmsFitDomain {
  std::string path, sha256;
  std::uint64_t bytes = 0;
};

/// A domain that was made from the data.
struct DmsFitAuto {
  std::string kind;
  double spacing = 0;
  std::uint64_t vertices = 0, tetrahedra = 0, gradient_splits = 0;
};

struct DmsFitReport {
  std::optional<DmsFitDomain> domain;
  std::optional<DmsFitAuto> automatic;  ///< if there is no file
  std::string data, output;
  DmsDefects defects;  ///< of the domain; with them there is no fit
  std::optional<double> tolerance;
  std::optional<DmsFit> fit;
  double seconds = 0;
};

/// The schema: docs/report.schema.json, dms_fit.
std::string dms_fit_json(const DmsFitReport& report);

/// Sentences for people: the sizes, the errors, why the fit ended, and what the data lack. REQUIRES a fit.
std::string dms_fit_text(const DmsFitReport& report);

}  // namespace veritope::report
