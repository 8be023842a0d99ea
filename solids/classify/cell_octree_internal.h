// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/classify/cell_octree_internal.h: an octree over a closed mesh whose empty cells are labelled with the winding
// number, and whose other cells have a reference point with its label. Internal to solids/classify.
#pragma once
#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "robust/base/box3d.h"
#include "solids/classify/facet_tests_internal.h"
#include "solids/classify/mesh_classifier.h"
#include "solids/classify/shell_chain_internal.h"

namespace veritope::internal {

/// What is true of all points of a region: the winding number, and the shells around it.
struct RegionLabel {
  std::int32_t winding = 0;
  std::uint32_t chain = 0;  ///< a number of ShellChains
  friend auto operator<=>(const RegionLabel&, const RegionLabel&) = default;
};

/// A cell that some facet may meet.
struct OccupiedCell {
  /// On the plane of none of the cell's facets, unless they are degenerate.
  Vec3d reference;
  bool has_reference = false;  ///< false: none was found, and points of the cell need all facets
  std::uint32_t first = 0, count = 0;  ///< its facets in CellOctree::facets
  RegionLabel label;                   ///< of the reference point
};

/// A facet of a cell, and on which side of its plane the cell's reference point lies.
struct CellFacet {
  std::uint32_t facet : 31;
  std::uint32_t is_reference_in_front : 1;
  Sign reference_side() const {
    return is_reference_in_front != 0 ? Sign::kPositive : Sign::kNegative;
  }
};

/// A cube with exact corners and points.
struct OctreeCell {
  static constexpr int kNumPoints = 64;

  Vec3d lo;
  double size = 0;

  Vec3d corner() const { return {lo.x + size, lo.y + size, lo.z + size}; }
  Vec3d centre() const { return {lo.x + 0.5 * size, lo.y + 0.5 * size, lo.z + 0.5 * size}; }
  /// One of some points in the middle of the cell, spread without a pattern that a model could share: multiples of
  /// 1/128 of its size. REQUIRES 0 <= i < kNumPoints.
  Vec3d point(int i) const {
    const Vec3d c = centre();
    const double step = size / 128;
    return {c.x + ((37 * i + 11) % 61 - 30) * step, c.y + ((23 * i + 5) % 59 - 29) * step,
            c.z + ((17 * i + 29) % 53 - 26) * step};
  }
  OctreeCell child(unsigned i) const {
    const double half = 0.5 * size;
    return {{lo.x + ((i & 1u) != 0 ? half : 0), lo.y + ((i & 2u) != 0 ? half : 0),
             lo.z + ((i & 4u) != 0 ? half : 0)},
            half};
  }
  bool contains(const Vec3d& p) const {
    return lo.x <= p.x && p.x <= lo.x + size && lo.y <= p.y && p.y <= lo.y + size && lo.z <= p.z &&
           p.z <= lo.z + size;
  }
};

/// The cube of the root, whose cells have exact corners in binary64.
struct OctreeFrame {
  Vec3d origin;
  double size = 0;  ///< a power of two
  double margin =
      0;  ///< cells are taken greater by this much on all sides, so that roundings do not matter
  int max_level = 0;
  static constexpr int kIndexBits = 20;  ///< of a cell's place along an axis: no cell is smaller
  /// The place of a point's cell of the last level, in units of its size: at most `margin` wrong, and of points outside
  /// of the cube that of the nearest cell.
  std::array<std::uint32_t, 3> place_of(const Vec3d& q) const {
    const double scale = static_cast<double>(1 << kIndexBits) / size;
    const auto index = [&](double c, double from) {
      const double at = (c - from) * scale;
      constexpr double kLast = (1 << kIndexBits) - 1;
      return static_cast<std::uint32_t>(std::min(std::max(at, 0.0), kLast));
    };
    return {index(q.x, origin.x), index(q.y, origin.y), index(q.z, origin.z)};
  }
  /// Nothing if the box is too large, or a point. REQUIRES a finite box.
  static std::optional<OctreeFrame> around(const Box3d& box);
};

class CellOctree {
 public:
  /// A cell with at most `few_facets` is not divided.
  /// @cost near-linear in the facets, of which the cells hold at most ten copies each on average
  CellOctree(const FacetTests& tests, const OctreeFrame& frame, std::uint32_t num_facets,
             std::size_t few_facets, ShellChains& chains);

  /// The cell of a point of the box: the label of an empty cell, or an occupied cell.
  struct Found {
    const RegionLabel* label = nullptr;  ///< of an empty cell
    const OccupiedCell* occupied = nullptr;
    OctreeCell cell;  ///< of an occupied cell
  };
  Found find(const Vec3d& q) const;
  std::span<const CellFacet> facets(const OccupiedCell& cell) const {
    return {facets_.data() + cell.first, cell.count};
  }
  void prefetch_facets(const OccupiedCell& cell) const {
    __builtin_prefetch(facets_.data() + cell.first);
  }
  /// Calls `visit`, a function of std::span<const CellFacet>, for the facets of each cell that meets the closed box,
  /// until it returns false. Returns whether it always returned true. A facet that meets the box is among them, perhaps
  /// several times.
  template <typename Visit>
  bool visit_facets(const Box3d& box, const Visit& visit) const {
    return !meets({to_point(root().lo), to_point(root().corner())}, box) ||
           visit_facets(nodes_[0], root(), box, visit);
  }
  LookupSize size() const;

  /// Numbers the facets of the cells in the order in which cells name them, so that those of one cell are neighbours.
  /// Returns that order, in their old numbers.
  std::vector<std::uint32_t> renumber_facets(std::uint32_t num_facets);

 private:
  class Builder;
  void make_grid(std::uint32_t num_facets);
  OctreeCell cell_at(const std::array<std::uint32_t, 3>& place, int level) const;
  /// One of these kinds, with a number in the other 30 bits.
  using Node = std::uint32_t;
  static constexpr Node kInner = 0, kEmpty = 1u << 30, kOccupied = 2u << 30;
  static constexpr Node kNumber = (1u << 30) - 1;

  OctreeCell root() const { return {frame_.origin, frame_.size}; }
  template <typename Visit>
  bool visit_facets(Node node, const OctreeCell& cell, const Box3d& box, const Visit& visit) const;

  OctreeFrame frame_;
  int grid_level_ = 0;
  std::vector<Node> grid_;  // the nodes of one level, for the first steps of find
  std::vector<Node> nodes_;
  std::vector<RegionLabel> labels_;
  std::vector<OccupiedCell> occupied_;
  std::vector<CellFacet> facets_;
};

// REQUIRES that the box meets the cell: then it meets those children that are not beyond the centre along any axis.
template <typename Visit>
bool CellOctree::visit_facets(Node node, const OctreeCell& cell, const Box3d& box,
                              const Visit& visit) const {
  if (node >= kEmpty) return (node & kOccupied) == 0 || visit(facets(occupied_[node & kNumber]));
  constexpr std::array<unsigned, 3> kLow = {0x55, 0x33, 0x0f};
  const Point3d middle = to_point(cell.centre());
  unsigned children = 0xff;
  for (std::size_t k = 0; k < 3; ++k)
    children &= (box.lo[k] <= middle[k] ? kLow[k] : 0u) | (box.hi[k] >= middle[k] ? ~kLow[k] : 0u);
  for (; children != 0; children &= children - 1) {
    const auto i = static_cast<unsigned>(std::countr_zero(children));
    if (!visit_facets(nodes_[node + i], cell.child(i), box, visit)) return false;
  }
  return true;
}

}  // namespace veritope::internal
