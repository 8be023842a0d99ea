// SPDX-License-Identifier: LGPL-3.0-or-later
// render/volume_view.h: the cells of a V-model for viewers: each in a colour of its own, moved apart on request, with
// control nets. These are pictures: everything is rounded to binary64, and nothing is decided.
#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "io/splines/spline_model.h"
#include "render/view_parts.h"
#include "robust/base/box3d.h"
#include "robust/base/result.h"

namespace veritope {

/// The most points of all parts together, unless options say less.
inline constexpr std::size_t kMostVolumeViewPoints = std::size_t{1} << 23;

struct VolumeViewOptions {
  /// Every cell is moved by this factor times c_i - c. The centre c_i of a cell is the middle of the least box around
  /// its control points, and c is the mean of the centres, in which each cell counts once.
  double explode = 0;
  bool has_nets = false;
  /// The aimed-at distance of chords from faces, see ViewOptions::chord; by default the share `fineness` of the
  /// diagonal of the box around the control points.
  std::optional<double> chord;
  double fineness = 1e-3;
  std::size_t max_points = kMostVolumeViewPoints;
};

/// Where the cells are drawn.
struct VolumeLayout {
  std::vector<Point3d> offsets;  ///< one for each cell, finite
  Box3d box;            ///< the least one around the control points of all cells as they are moved
  double diagonal = 0;  ///< of the box around the cells where they are
};

/// The colour of a cell: ten that are easily told apart, each in three shades.
Colour cell_colour(std::uint64_t cell);

/// @error kBadArgument, with the entity: an entity that is no volume, or has fewer than three coordinates; kEmpty
///        without an entity
Status check_is_volumes(const SplineModel& model);

/// @error kNotFinite, with the entity, for control points beyond binary64 before or after they are moved
/// REQUIRES check_is_volumes(model), as do all below.
Result<VolumeLayout> volume_layout(const SplineModel& model, double explode);

/// One part, "cell_i", for each cell: the triangles of its six faces, counterclockwise from outside if they enclose a
/// positive volume after all are reversed or none; triangles with two equal corners are left out. The lines are those
/// between neighbours among the control points.
/// @error as tessellate, and kOverLimit for more than options.max_points points
Result<std::vector<ViewPart>> volume_parts(const SplineModel& model, const VolumeLayout& layout,
                                           const VolumeViewOptions& options);

/// VTK's unstructured grid of the Bezier pieces of all cells. Its cells have their number (`cell`), their colour
/// (`colour`: red, green, blue, 255) and 0 as `net`; lines of control nets are cells of VTK's kind VTK_LINE with 1.
/// @error kNotFinite, kOverLimit as tessellate
Result<std::string> volume_vtu(const SplineModel& model, const VolumeLayout& layout,
                               const VolumeViewOptions& options);

}  // namespace veritope
