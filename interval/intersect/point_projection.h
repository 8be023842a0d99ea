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
/// critical also without holding it is reported once, with the fewest held axes, if its parameters are exact; else both
/// are reported, each in its own right.
template <std::size_t N>
struct CriticalPoint {
  ExactBox<N> parameters;
  std::optional<std::array<Rational, N>>
      exact;  ///< its parameters, if they are known to be short fractions
  std::array<bool, N> is_held{};
  RootPlace place = RootPlace::
      kInside;  ///< in the part; kAtBoundary: perhaps just outside, then no critical point of the map
  CriticalKind kind = CriticalKind::kUndecided;  ///< kMinimum if all axes are held
  std::vector<Interval> point;                   ///< its coordinates
  Interval distance;
};

/// Parameters where critical points were neither isolated nor excluded.
template <std::size_t N>
struct OpenRegion {
  ExactBox<N> parameters;
  OpenReason reason = OpenReason::kNarrow;
  Interval distance;  ///< of all its points
};

template <std::size_t N>
struct Projection {
  std::vector<CriticalPoint<N>> points;
  std::vector<OpenRegion<N>> open;
  Interval least_distance;  ///< encloses the distance from the point to the map
  std::vector<std::size_t>
      nearest;  ///< of points: one is nearest, if open regions are no nearer; one entry: it is
  std::optional<std::size_t> certified_nearest;  ///< of points: proved nearer than all others
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
