// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/micro/filter/separation_internal.h: planes between a piece of a tile and a facet. Internal to
// solids/micro/filter.
#pragma once
#include <array>
#include <vector>

#include "interval/box.h"
#include "predicates/vec.h"
#include "solids/micro/filter/tile_pieces_internal.h"

namespace veritope::internal {

/// The hull of some boxes, grown by `excess` along each axis, with the directions in which a plane is looked for.
/// All functions REQUIRE a live ScopedUpward.
class GrownHull {
 public:
  explicit GrownHull(const TilePiece& piece);
  /// The hull of the piece and another point.
  GrownHull(const TilePiece& piece, const Box3& apex);

  const Box3d& box() const { return box_; }
  /// True only if a plane separates the hull from the closed triangle: they are disjoint. Candidates: the planes along
  /// the axes, the triangle's, that of the piece's diagonals, and those along an edge of each.
  bool is_apart(const std::array<Vec3d, 3>& facet) const;
  /// Whether some candidate leaves the boxes, without excess, on one side and the triangle on the other, at a distance
  /// of `gap` times the direction's length; negative gaps allow an overlap. Approximate.
  bool may_have_gap(const std::array<Vec3d, 3>& facet, double gap) const;

 private:
  template <typename Separates>
  bool finds_direction(const std::array<Vec3d, 3>& facet, Separates separates) const;
  bool is_proved_apart(const Point3d& direction, const std::array<Vec3d, 3>& facet) const;
  bool may_be_apart(const Point3d& direction, const std::array<Vec3d, 3>& facet,
                    const Point3d& excess) const;

  std::vector<Box3> points_;
  std::vector<Point3d> approx_;
  Point3d excess_{};
  Box3d box_ = empty_box();
  std::vector<Point3d> edges_;
  Point3d normal_{};
};

}  // namespace veritope::internal
