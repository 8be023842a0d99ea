// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/micro/bridge/cage_space_internal.h: the maps of a cage's volumes: hulls of images of boxes, and approximate
// values and preimages. Internal to solids/micro/bridge.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "interval/box.h"
#include "interval/ring_numbers.h"
#include "robust/base/box3d.h"
#include "robust/base/result.h"
#include "solids/micro/microstructure.h"
#include "splines/bezier.h"
#include "splines/fast_spline.h"

namespace veritope::internal {

/// A point of a volume with its image and the partial derivatives there, all approximate.
struct ApproxPlace {
  Point3d at{}, image{};
  std::array<Point3d, 3> partial{};
};

/// Points whose hull contains the image of a box in one knot span.
using HullPoints = std::vector<Box3>;

class VolumeSpace {
 public:
  /// @error as FastSpline::prepare
  static Result<VolumeSpace> make(const VVolume& volume);

  /// Nothing outside of the domain.
  std::optional<ApproxPlace> place(const Point3d& at) const;
  /// A point of the open domain whose image is near the goal, by Newton's method from `start`; nothing if it does not
  /// get there.
  std::optional<ApproxPlace> preimage(const Point3d& goal, const Point3d& start) const;

  /// One list for each knot span that the box meets; false if a weight may be 0, or the box meets more than 64 spans.
  /// REQUIRES a live ScopedUpward, and a box in the domain.
  bool hulls(const Box3d& box, std::vector<HullPoints>* out) const;

  /// Vectors whose hull contains one that has the direction of the derivative along the axis, away from a wall at a
  /// break, at each point of the wall. False as hulls.
  /// REQUIRES a box that lies in the plane of a break of the axis, and a span on the side that is named.
  bool directions(const Box3d& wall, std::size_t axis, bool is_upward, HullPoints* out) const;

 private:
  struct Axis {
    std::vector<Interval> breaks;
    double begin = 0, end = 0;
  };
  explicit VolumeSpace(FastSpline<3> fast) : fast_(std::move(fast)) {}
  using Part = std::array<double, 2>;  // of a span, from 0 to 1
  using SpanPart = std::pair<std::size_t, Part>;
  std::vector<SpanPart> parts_of(const Box3d& box, std::size_t axis) const;
  bool hull_in_span(std::size_t piece, const std::array<Part, 3>& part, HullPoints* out) const;

  FastSpline<3> fast_;
  std::array<Axis, 3> axes_;
  Grid<3> spans_;
  std::vector<BezierVolume<Interval>> pieces_;
};

}  // namespace veritope::internal
