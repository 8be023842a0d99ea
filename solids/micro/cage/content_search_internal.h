// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/micro/cage/content_search_internal.h: whether surfaces miss the content of a cage, and what of it is near.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "robust/base/box3d.h"
#include "solids/base/box_hierarchy.h"
#include "solids/micro/cage/cage_content.h"
#include "solids/micro/cage/hull_sides_internal.h"
#include "splines/bezier.h"

namespace veritope::internal {

/// A Bezier patch whose homogeneous control points are enclosed.
struct EnclosedBezier {
  Grid<2> grid;
  bool is_rational = false;
  std::vector<std::array<Interval, 4>> points;
};
EnclosedBezier enclosed(const BezierSurface<Rational>& patch);

class ContentSearch {
 public:
  explicit ContentSearch(const CageContent& content);

  /// Nothing only if the patch meets no hull of a part; else a part that it may meet. The patch is halved at most
  /// `halvings` times in a row. REQUIRES positive weights.
  std::optional<std::uint32_t> met_by(const EnclosedBezier& patch, int halvings) const;

  /// A point of the content nearest to p, as a search finds it: on triangles, else among the corners of parts.
  Point3d approx_nearest(const Point3d& p) const;

 private:
  std::optional<std::uint32_t> met(const EnclosedBezier& patch, std::vector<std::uint32_t> parts,
                                   int halvings) const;
  std::span<const HullPoint> hull(std::uint32_t part) const;

  std::vector<HullPoint> corners_;
  std::vector<std::size_t> ends_;
  std::vector<Box3d> boxes_;
  BoxHierarchy hierarchy_;
};

}  // namespace veritope::internal
