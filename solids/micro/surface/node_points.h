// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/micro/surface/node_points.h: the points of a node of docs/certificates/micro-inside.md, section 3, and slabs
// of space that may lie beside all of them.
#pragma once
#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "interval/box.h"
#include "robust/base/box3d.h"

namespace veritope {

/// Enclosures of points, as middles and one radius for each coordinate: |q[c] - middle[c]| <= radius[c].
struct NodePoints {
  std::array<std::vector<double>, 3> middles;
  Point3d radius{};
  Box3d box = empty_box();  ///< around all of them

  std::size_t size() const { return middles[0].size(); }
  /// REQUIRES a live ScopedUpward.
  void assign(std::span<const Box3> points);
  /// Lets each coordinate of each point differ by so much more. REQUIRES a live ScopedUpward.
  void widen(double by);
};

/// A bound of |fl(d.m) - d.q| for the middles m of the points q, where fl(d.m) is the plain sum of three products; not
/// finite if that may overflow. REQUIRES a live ScopedUpward.
double dot_slack(const Point3d& d, const NodePoints& points);

/// A direction, with bounds of its products with the points of a part of a surface.
struct Slab {
  Point3d direction{};
  double lo = 0, hi = 0;
};
/// The slab around points. A direction that is not finite is replaced by 0. REQUIRES a live ScopedUpward.
Slab slab_around(const Point3d& direction, std::span<const Box3> points);
/// True only if all points lie strictly on one side of the slab. REQUIRES a live ScopedUpward.
bool is_beside(const Slab& slab, const NodePoints& points);

/// A box that contains all of these. REQUIRES a live ScopedUpward.
Box3d box_around(std::span<const Box3> points);

}  // namespace veritope
