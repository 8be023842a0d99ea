// SPDX-License-Identifier: LGPL-3.0-or-later
// report/cage_report.h: what veritope cage says of a cage that was written.
#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <string>

#include "robust/base/box3d.h"
#include "robust/rational.h"
#include "verify/certify/patch_facts.h"

namespace veritope::report {

struct CageReport {
  std::string kind;                        ///< "box"
  std::optional<std::string> path;         ///< of the model, the cage that was split, or the field
  std::string sha256;                      ///< of its bytes
  std::string output_path, output_sha256;  ///< of the cells
  std::uint64_t output_bytes = 0, control_points = 0;
  PatchFacts facts;  ///< of the cage that was certified. REQUIRES facts about cells
  struct Pull {
    std::uint64_t rounds = 0, shortened = 0;
  };
  std::optional<Pull> pull;  ///< of a hull
  struct Fit {
    std::uint64_t vectors = 0, steps = 0, shortened = 0;
    bool has_tensors = false;
    double median = 0, worst = 0;                           ///< angles in degrees, approximately
    std::uint64_t worst_line = 0;                           ///< of the file
    std::optional<std::array<std::uint64_t, 3>> stop_span;  ///< where det J > 0 ended the fit
    Point3d stop_near{};
    std::optional<double> thickness_error;  ///< the greatest one, approximately; of an attribute
  };
  std::optional<Fit> fit;
  std::optional<Rational> angle_error;  ///< of a sector, in degrees
  double seconds = 0;
};

/// The schema: docs/report.schema.json, cage. One line.
std::string cage_json(const CageReport& report);

/// Lines for people.
std::string cage_text(const CageReport& report);

}  // namespace veritope::report
