// SPDX-License-Identifier: LGPL-3.0-or-later
// report/intersection_report.h: what veritope intersect says.
#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "interval/intersect/surface_intersection.h"
#include "io/splines/spline_model.h"
#include "report/exit_code.h"

namespace veritope::report {

/// A surface of a file: of an entity, from 0, or of a face of a model there.
struct NamedSurface {
  std::size_t entity = 0;
  std::optional<std::size_t> face;
  const ExactSurface* surface = nullptr;
  bool is_trimmed = false;  ///< its loops were not examined
};
std::vector<NamedSurface> surfaces_of(const SplineModel& model);

struct PairIntersection {
  NamedSurface first, second;
  SurfaceIntersection found;
};

struct IntersectionReport {
  std::array<std::string, 2> paths, sha256;
  std::vector<PairIntersection> pairs;  ///< those that have something to say
  std::size_t num_pairs = 0;            ///< examined
  bool ignores_trimming = false;
  std::uint64_t ignored_triangles = 0;  ///< Bezier triangles of both files

  bool is_complete() const;
  ExitCode exit() const { return is_complete() ? kExitValid : kExitUndecided; }
};

/// "elliptic", "hyperbolic", "unknown".
const char* shape_name(IntersectionContact::Shape shape);

/// The schema: docs/report.schema.json, intersection.
std::string intersection_json(const IntersectionReport& report);
std::string intersection_text(const IntersectionReport& report);
/// The curves alone: control points in both domains. The schema: docs/report.schema.json, curves.
std::string curves_json(const IntersectionReport& report);

}  // namespace veritope::report
