// SPDX-License-Identifier: LGPL-3.0-or-later
// report/projection_report.h: what veritope project says: for one point and the curves and surfaces of a file.
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "interval/intersect/point_projection.h"
#include "report/exit_code.h"

namespace veritope::report {

/// One curve or surface of the file.
struct ProjectionTarget {
  std::uint64_t entity = 0;           ///< its number in the file, from 0
  std::optional<std::uint64_t> face;  ///< of a model, from 0
  std::string kind;                   ///< spline_kind_name
  std::variant<Projection<1>, Projection<2>> projection;
};
struct ProjectionReport {
  std::vector<Rational> point;
  std::string path, sha256;
  std::vector<ProjectionTarget> targets;
  std::uint64_t skipped_volumes = 0, skipped_triangles = 0;
  ExitCode exit = kExitValid;

  /// Encloses the distance to all targets. REQUIRES targets.
  Interval distance() const;
  /// The target and its point that are proved nearest.
  std::optional<std::pair<std::size_t, std::size_t>> nearest() const;
  bool is_complete() const;
};

/// The schema: docs/report.schema.json, projection. One line.
std::string projection_json(const ProjectionReport& report);
std::string projection_text(const ProjectionReport& report);

}  // namespace veritope::report
