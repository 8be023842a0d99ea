// SPDX-License-Identifier: LGPL-3.0-or-later
// report/weld_report.h: what veritope convert --weld did to the cells of a file of volumes.
#pragma once
#include <cstdint>
#include <string>

#include "robust/rational.h"
#include "solids/vmodel/v_weld.h"

namespace veritope::report {

struct WeldReport {
  std::string path, sha256;                ///< of the input
  std::string output_path, output_sha256;  ///< of the file that was written
  std::uint64_t output_bytes = 0;
  Rational eps;
  std::uint64_t num_cells = 0;
  VWeld weld;  ///< `cells` is not used
  double seconds = 0;
};

/// The schema: docs/report.schema.json, weld. One line.
std::string weld_json(const WeldReport& report);

/// Lines for people, to follow the line about the file.
std::string weld_text(const WeldReport& report);

}  // namespace veritope::report
