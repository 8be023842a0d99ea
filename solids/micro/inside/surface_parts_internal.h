// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/micro/inside/surface_parts_internal.h: the surface of a solid as parts whose distances from other points
// can be bounded. Internal to solids/micro/inside.
#pragma once
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "solids/base/box_hierarchy.h"
#include "solids/micro/inside/part_net_internal.h"
#include "solids/micro/surface/node_points.h"
#include "solids/patches/patch_complex.h"
#include "solids/polyhedron/triangle_mesh.h"

namespace veritope::internal {

/// At most the distance between any two points of the boxes. REQUIRES a live ScopedUpward.
double least_distance(const Box3d& a, const Box3d& b);
/// False only if all distances between points of the boxes are greater, in any rounding mode: differences, squares and
/// sums are each off by a factor within 1 +- 2^-52, or by less than 2^-1000 where they underflow.
inline bool may_be_nearer(const Box3d& a, const Box3d& b, double distance) {
  double sum = 0;
  for (std::size_t c = 0; c < 3; ++c) {
    const double gap = std::max({a.lo[c] - b.hi[c], b.lo[c] - a.hi[c], 0.0});
    sum += gap * gap;
  }
  return !(sum * (1 - 0x1p-48) > distance * distance + 0x1p-1000);
}

/// Parts by numbers: those that all views share, then those that this view has cut out of them. One thread uses a view.
/// All functions REQUIRE a live ScopedUpward.
class DistanceView {
 public:
  virtual ~DistanceView() = default;
  virtual const Box3d& box(std::uint32_t part) const = 0;
  /// A lower bound of the distances between the hull of the points and the part; the first that is found to be at least
  /// `enough`, or else the best one.
  virtual double gap(std::uint32_t part, const NodePoints& points, double enough) const = 0;
  /// No point of the box is farther from some point of the part.
  virtual double reach(std::uint32_t part, const Box3& point) const = 0;
  /// The number of the first of both halves of a part, which follow each other; kNoHalves if it is not cut.
  virtual std::uint32_t halves(std::uint32_t part) = 0;
  static constexpr std::uint32_t kNoHalves = 0xffffffffu;
};

/// Immutable: threads share it.
class DistanceParts {
 public:
  virtual ~DistanceParts() = default;
  virtual std::unique_ptr<DistanceView> view() const = 0;

  bool is_empty() const { return tree_.order().empty(); }
  /// Between the boxes of a shared part and another one.
  double distance(std::uint32_t part, const Box3d& box) const {
    return least_distance(boxes_[part], box);
  }
  /// Calls visit(part) for every shared part whose box may be nearer to the box than bound() when it is looked at.
  template <typename Bound, typename Visit>
  void visit_near(const Box3d& box, Bound bound, Visit visit) const {
    tree_.visit([&](const Box3d& b) { return bound() > 0 && may_be_nearer(b, box, bound()); },
                visit);
  }

  /// REQUIRES finite coordinates. The mesh must outlive it.
  static std::unique_ptr<const DistanceParts> of(const TriangleMesh& mesh);
  /// REQUIRES positive weights. The complex must outlive it.
  static std::unique_ptr<const DistanceParts> of(const PatchComplex& complex);

 protected:
  void set_boxes(std::vector<Box3d> boxes) {
    tree_ = BoxHierarchy(boxes);
    boxes_ = std::move(boxes);
  }
  const Box3d& box_of_shared(std::uint32_t part) const { return boxes_[part]; }

 private:
  std::vector<Box3d> boxes_;
  BoxHierarchy tree_;
};

}  // namespace veritope::internal
