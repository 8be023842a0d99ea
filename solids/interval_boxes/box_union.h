// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/interval_boxes/box_union.h: |B| for boxes in any position, as a regular cell complex: coordinates are
// compressed to a grid, and the link test of the common subdivision decides whether it is a 3-manifold with boundary.
// Sources: Prop. 2.1, Cor. 2.1, 2.2 and Remark 2.1 of [SSP01].
#pragma once
#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "robust/base/box3d.h"
#include "robust/base/result.h"
#include "topology/complex_boundary.h"

namespace veritope {

/// The cells between neighbouring coordinates of a set of boxes, with a margin of one cell all around; each lies in |B|
/// or has its interior off |B|.
class BoxGrid {
 public:
  static constexpr std::uint64_t kMaxCells = std::uint64_t{1} << 24;
  /// @error kEmpty without a box; kBadArgument for a box with a side that is not longer than 0, or not finite;
  /// kOverLimit for more than kMaxCells
  static Result<BoxGrid> make(std::span<const Box3d> boxes);

  /// Cells along an axis.
  std::uint32_t size(std::size_t axis) const { return size_[axis]; }
  bool is_filled(std::uint32_t i, std::uint32_t j, std::uint32_t k) const {
    return filled_[index(i, j, k)];
  }
  /// Approximately the middle of a cell; in the margin, some point outside all boxes.
  Point3d approx_middle(std::uint32_t i, std::uint32_t j, std::uint32_t k) const;
  /// Fills the components of the complement for which `is_inside` answers yes at one point each. The component that
  /// reaches infinity stays empty. Returns nothing if some answer was nothing, that is, undecided. The filled cells are
  /// V_I∪|B| if V lies in |B| and is_inside says which points lie inside V. With dimension 2 the boxes are those of the
  /// plane, all with the same third side, and the components those in the plane.
  std::optional<BoxGrid> filled_where(
      const std::function<std::optional<bool>(const Point3d&)>& is_inside, int dimension = 3) const;

  /// The filled cells as cells of an octree, one level, with the same incidences. @error kOverLimit as
  /// CommonSubdivision::build
  Result<CommonSubdivision> subdivision() const;

 private:
  std::size_t index(std::uint32_t i, std::uint32_t j, std::uint32_t k) const {
    return (std::size_t{k} * size_[1] + j) * size_[0] + i;
  }
  // The coordinates along each axis, ascending; cell c of an axis lies between at_[c - 1] and at_[c].
  std::array<std::vector<double>, 3> at_;
  std::array<std::uint32_t, 3> size_{};
  std::vector<bool> filled_;
};

/// What a union of boxes is.
struct UnionTopology {
  bool is_manifold = false;  ///< a compact 3-manifold with boundary (the link test)
  std::string defect;        ///< unless it is: where the link test fails
  std::size_t bodies = 0;
  /// The Euler characteristic of each component of the boundary, if the union is a manifold.
  std::vector<std::int64_t> boundary_euler;
  /// A solid in the paper's sense: a connected 3-manifold with boundary (in space it is orientable).
  bool is_solid() const { return is_manifold && bodies == 1; }
  /// A closed ball: a solid bounded by one sphere (Alexander).
  bool is_ball() const {
    return is_solid() && boundary_euler.size() == 1 && boundary_euler[0] == 2;
  }
};
Result<UnionTopology> topology_of(const BoxGrid& grid);

/// |B| itself. Planar boxes (dimension 2) stand for their product with an interval.
Result<UnionTopology> union_topology(std::span<const Box3d> boxes, int dimension = 3);

}  // namespace veritope
