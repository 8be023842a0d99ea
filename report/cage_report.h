// SPDX-License-Identifier: LGPL-3.0-or-later
// report/cage_report.h: what veritope cage says of a cage that was written.
#pragma once
#include <cstdint>
#include <optional>
#include <string>

#include "robust/rational.h"
#include "verify/certify/patch_facts.h"

namespace veritope::report {

struct CageReport {
  std::string kind;                        ///< "box"
  std::optional<std::string> path;         ///< of the model, or of the cage that was split
  std::string sha256;                      ///< of its bytes
  std::string output_path, output_sha256;  ///< of the cells
  std::uint64_t output_bytes = 0, control_points = 0;
  PatchFacts facts;  ///< of the cage that was certified. REQUIRES facts about cells
  struct Pull {
    std::uint64_t rounds = 0, shortened = 0;
  };
  std::optional<Pull> pull;             ///< of a hull
  std::optional<Rational> angle_error;  ///< of a sector, in degrees
  double seconds = 0;
};

/// The schema: docs/report.schema.json, cage. One line.
std::string cage_json(const CageReport& report);

/// Lines for people.
std::string cage_text(const CageReport& report);

}  // namespace veritope::report
