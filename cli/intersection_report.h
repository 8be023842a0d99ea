// SPDX-License-Identifier: LGPL-3.0-or-later
// cli/intersection_report.h: what veritope intersect says.
#pragma once
#include <string>
#include <vector>

#include "report/exit_code.h"
#include "interval/intersect/surface_intersection.h"
#include "io/splines/read_splines.h"

namespace veritope::cli {

using namespace report;

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

std::string intersection_json(const IntersectionReport& report);
std::string intersection_text(const IntersectionReport& report);
/// The curves alone: control points in both domains.
std::string curves_json(const IntersectionReport& report);
/// The curves as VTK polygons, 8 pieces a segment, with points on the first surfaces in binary64.
std::string curves_vtu(const IntersectionReport& report);

}  // namespace veritope::cli
