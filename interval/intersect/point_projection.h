// SPDX-License-Identifier: LGPL-3.0-or-later
// interval/intersect/point_projection.h: all critical points of the distance from a point to a curve or surface, and
// which one is nearest. Design: docs/design/0012-certified-solvers.md.
#pragma once
#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "interval/interval.h"
#include "interval/solvers/root_report.h"
#include "robust/base/result.h"
#include "splines/bspline.h"

namespace veritope {

/// The kind of a critical point of the distance, on the part of the map where the held parameters are constant.
enum class CriticalKind { kMinimum, kSaddle, kMaximum, kUndecided };

/// Exactly one critical point, with the parameters in the box: on free axes the derivative of the distance is 0; a held
/// axis is a border of the domain or a knot line where the map need not be differentiable. A point on a border that is
/// also critical when the border's axis is free is reported once, with the fewest held axes, if its parameters are
/// exact; else both descriptions are reported, each with its own box.
template <std::size_t N>
struct CriticalPoint {
  ExactBox<N> parameters;
  /// The parameters, if they are known to be short fractions.
  std::optional<std::array<Rational, N>> exact;
  std::array<bool, N> is_held{};
  /// In the part; kAtBoundary: perhaps just outside, and then it is not a critical point of the map.
  RootPlace place = RootPlace::kInside;
  CriticalKind kind = CriticalKind::kUndecided;  ///< kMinimum if all axes are held
  std::vector<Interval> point;                   ///< its coordinates
  Interval distance;
};

/// Parameters where critical points were neither isolated nor excluded.
template <std::size_t N>
struct OpenRegion {
  ExactBox<N> parameters;
  OpenReason reason = OpenReason::kNarrow;
  Interval distance;  ///< encloses the distances of all points in the region
};

template <std::size_t N>
struct Projection {
  std::vector<CriticalPoint<N>> points;
  std::vector<OpenRegion<N>> open;
  Interval least_distance;  ///< encloses the distance from the point to the map
  /// Indices of points: one of these is nearest unless an open region is nearer; a single entry is the nearest.
  std::vector<std::size_t> nearest;
  std::optional<std::size_t>
      certified_nearest;  ///< index of a point that is proved nearer than all others
  SolverEffort effort;

  bool is_complete() const { return open.empty(); }
};

/// Projects onto curves (N = 1) and surfaces (N = 2) in any dimension, polynomial or rational.
/// @error kBadArgument: a point of another dimension, a weight that is not positive, or bad options; kOverLimit:
/// equations of too many coefficients
template <std::size_t N>
Result<Projection<N>> project_point(std::span<const Rational> point,
                                    const BSpline<Rational, N>& map,
                                    const SolverOptions& options = {});

const char* critical_kind_name(CriticalKind kind);
const char* open_reason_name(OpenReason reason);

}  // namespace veritope
