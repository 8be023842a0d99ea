// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/classify/patch_octree_internal.h: an octree over a closed patch complex whose empty cells are labelled with
// the winding number, and whose other cells are labelled on both sides of a slab that contains the surface. Internal to
// solids/classify.
#pragma once
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "solids/classify/cell_octree_internal.h"
#include "solids/classify/patch_rays.h"
#include "solids/classify/value3.h"

namespace veritope::internal {

/// A cell of which all points of the surface lie between two parallel planes: the rest of the cell is in two convex
/// parts, each of which has one label.
struct SlabCell {
  static constexpr std::uint32_t kNoLabel = 0xffffffff;
  Point3d normal{};
  double
      lo = 0,
      hi =
          0;  ///< of normal·p on the surface, roundings of normal·p for points of the cell included
  std::uint32_t below = kNoLabel, above = kNoLabel;  ///< numbers of labels
};

class PatchOctree {
 public:
  /// The label of a point, or nothing if it may be on the surface.
  using LabelOf = std::function<std::optional<RegionLabel>(const RayPoint&)>;
  /// @param levels  of cells with a thin slab; others are divided once more
  PatchOctree(const PatchRays& rays, const LabelOf& label_of, int levels);

  /// The label of the point; nothing if it lies in a slab, or in a cell without one.
  const RegionLabel* find(const RayPoint& q) const;
  /// The value of all points of a box, divided as the nets, or mixed if it has points of both values; nothing if the
  /// cells do not tell. REQUIRES a box that is not empty.
  std::optional<Value3> value(const Box3d& box) const;
  LookupSize size() const;

 private:
  class Builder;
  class BoxQuestion;
  using Node = std::uint32_t;  // see kinds in the .cc file

  std::optional<OctreeFrame> frame_;  // nothing: no cells
  std::vector<Node> nodes_;
  std::vector<RegionLabel> labels_;
  std::vector<SlabCell> slabs_;
};

}  // namespace veritope::internal
