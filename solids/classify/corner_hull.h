// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/classify/corner_hull.h: hulls of four points, grown, and planes between them.
#pragma once
#include <array>

#include "interval/box.h"
#include "robust/base/box3d.h"
#include "solids/classify/patch_piece.h"

namespace veritope {

/// The hull of four points, which boxes enclose, grown by `excess` in each coordinate. All functions REQUIRE a live
/// ScopedUpward.
class CornerHull {
 public:
  /// `box` contains it.
  CornerHull(const std::array<Box3, 4>& corners, const Point3d& excess, const Box3d& box);
  /// Contains the part of the patch.
  explicit CornerHull(const PatchPiece& piece)
      : CornerHull(piece.corners(), piece.excess(), piece.box()) {}

  const Box3d& box() const { return box_; }
  /// True only if a plane separates the hulls: they are disjoint. Candidates: the planes along the axes, those of the
  /// diagonals of both, and those across the line between the middles; they are tried in plain numbers and proved in
  /// intervals.
  bool is_apart(const CornerHull& other) const;

 private:
  bool is_below(const CornerHull& other, const Point3d& direction) const;

  std::array<Box3, 4> corners_;
  std::array<Point3d, 4> approx_;
  Point3d excess_;
  Box3d box_;
  Point3d normal_;
};

}  // namespace veritope
