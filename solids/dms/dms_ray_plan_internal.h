// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/dms/dms_ray_plan_internal.h: what the moments of one tetrahedron's simplex splines along the rays of a grid
// are computed from: splines/simplex_line.h as tables of doubles with bounds of their errors.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "solids/dms/dms_evaluator.h"
#include "solids/dms/dms_ray_grid.h"

namespace veritope::internal {

/// Half the distance from 1 to the next double: the relative error of a rounding to nearest.
inline constexpr double kRayUnit = 0x1p-53;

/// A number for each ray of a plan's range, at + right i + down j, where i and j count from the plan's centre. What
/// `on` computes, rounding to nearest, differs from it by at most `error` on each of these rays.
struct RayNumber {
  double at = 0, right = 0, down = 0, error = 0;
  double on(double i, double j) const { return at + right * i + down * j; }
};
/// A barycentric coordinate: a RayNumber plus s times `along`, which has an error of at most along_error. s = (t -
/// centre) / radius is the plan's parameter of a ray; -1 <= s <= 1, up to roundings, where t is from 0 to 1 and the
/// plan's knots are.
struct RayCoordinate {
  RayNumber at;
  double along = 0, along_error = 0;
};

/// A tetrahedron of knots, as the parameters s where rays cross the planes of its faces.
struct RayCell {
  /// First num_in faces through which rays enter, then num_out through which they leave; `on` is the parameter. The
  /// rest are parallel to the rays; `on` is the barycentric coordinate.
  std::array<RayNumber, 4> face{};
  std::uint8_t num_in = 0, num_out = 0;
  double height = 0, height_error = 0;
};
/// A part of a ray: what its true bounds differ from these by adds up to at most `slack`.
struct RaySpan {
  double begin = 0, end = 0, slack = 0;
};
enum class RayClip { kMiss, kHit, kUnsure };
/// Replaces a part of a ray by that in the cell. kMiss is certain. If kHit, begin <= end, and if the truth is empty,
/// they differ from each other by no more than the slack. The slack is infinite where doubles do not suffice.
/// REQUIRES bounds up to 1.01, without an error.
RayClip clip_ray(const RayCell& cell, double i, double j, RaySpan& span);

/// A set of knots of a degree over 0: the splines without one of four knots, and their coordinates.
struct RayNode {
  int degree = 1;
  std::array<std::int32_t, 4>
      child{};  ///< a cell, or num_cells plus a node before this one; -1: a spline that is zero
  std::array<RayCoordinate, 4> coordinate;
};

/// A basis function: a set of knots, d(W) and its error, the coordinates with respect to W, and the control points of
/// W's corners; for control points that are separate, one control point alone.
struct RayTerm {
  std::int32_t set = 0;
  double volume = 0, volume_error = 0;
  std::array<RayCoordinate, 4> coordinate;
  std::array<std::uint32_t, 4> control{};
};

struct RayPlan {
  /// The rays beyond these miss the hull of all knots.
  std::uint32_t first_column = 0, end_column = 0, first_row = 0, end_row = 0;
  double centre_column = 0, centre_row = 0;  ///< integers
  double centre = 0, radius = 1;             ///< of t
  std::vector<RayCell> cells;                ///< the first one is the tetrahedron of the domain
  std::vector<RayNode> nodes;
  std::vector<RayTerm> terms;
};

/// The plans of the tetrahedra that rays may meet, ascending. REQUIRES d(W_γ) != 0 as DmsEvaluator::evaluate does.
std::vector<RayPlan> make_ray_plans(const DmsModel& model, DmsEvaluator& evaluator,
                                    const DmsRayGrid& grid);

}  // namespace veritope::internal
