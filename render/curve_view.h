// SPDX-License-Identifier: LGPL-3.0-or-later
// render/curve_view.h: curves and sheets in space for pictures and viewers, as micro --emit writes them, in the colours
// of microstructures: those in a group "bridges" are bridges. These are pictures: everything is rounded to binary64,
// and nothing is decided. Source: figure 9 of [HPE22].
#pragma once
#include <cstddef>
#include <optional>
#include <vector>

#include "io/splines/spline_model.h"
#include "render/view_parts.h"
#include "robust/base/result.h"
#include "solids/polyhedron/triangle_mesh.h"

namespace veritope {

struct CurveViewOptions {
  /// See ViewOptions::chord; by default 1/5000 of the diagonal of the box around the control points.
  std::optional<double> chord;
  const TriangleMesh* model = nullptr;  ///< drawn transparent
  std::size_t max_lines = std::size_t{1} << 20;
};

/// How many entities are what.
struct CurveCounts {
  std::size_t curves = 0, sheets = 0, bridges = 0;
};

/// Nothing unless every entity is a curve, a surface or a triangle with three or more coordinates, and one is a curve.
std::optional<CurveCounts> counts_of_curves(const SplineModel& model);

/// The parts "curves" and "bridges", which have lines only, "sheets" and "model", as far as they have lines or
/// triangles. Curves with more than three coordinates are drawn by the first three.
/// @error as tessellate; kOverLimit for more than max_lines lines
/// REQUIRES counts_of_curves(model).
Result<std::vector<ViewPart>> curve_parts(const SplineModel& model,
                                          const CurveViewOptions& options);

/// The parts as a scene of triangles: lines are tubes, thinner if there are many curves; the model is transparent.
Scene curve_scene(std::vector<ViewPart> parts, std::size_t num_curves);

}  // namespace veritope
