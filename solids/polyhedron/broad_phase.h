// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/polyhedron/broad_phase.h: all pairs of facets whose boxes overlap, except pairs that a star vertex settles.
// Design: docs/design/0001-mesh-decision.md.
#pragma once
#include <cstdint>
#include <functional>
#include <span>
#include <utility>
#include <vector>

#include "robust/base/buffer.h"
#include "solids/polyhedron/box_order.h"
#include "solids/polyhedron/triangle_mesh.h"
#include "solids/polyhedron/vertex_star.h"

namespace veritope {

class WorkShare;

/// Two facets of the model.
using FacetPair = std::pair<std::uint32_t, std::uint32_t>;

/// An 8-ary tree of boxes over groups of eight consecutive facets, in single precision under a monotone map
/// (UnitScale), so that it misses no overlap. Walked in independent tasks. A decision takes this tree, and so does
/// a certificate without separators. Separators need BoxTree, whose nodes a page numbers: this one finds all pairs in a
/// quarter of the time (docs/design/0032-trees-of-boxes.md).
class BoxGroups {
 public:
  /// REQUIRES fewer than 2^30 facets in `order`. 36 bytes per facet.
  BoxGroups(const TriangleMesh& mesh, std::vector<std::uint32_t> order, const VertexStars& stars,
            const UnitScale& scale, unsigned jobs);

  /// Receives pairs, some at a time, each unordered pair once in all; `task` numbers the task that found them.
  using Sink = std::function<void(std::size_t task, std::span<const FacetPair>)>;

  /// Finds every unordered pair whose boxes overlap and whose common vertices, if any, are not stars. Which task finds
  /// a pair does not depend on jobs. Stops early and returns false when the work (facets compared with groups, and 8
  /// for each pair) exceeds `budget`: the boxes of long thin facets overlap too much for this method, and what the sink
  /// has seen is incomplete. Whether it returns false does not depend on jobs either. The tasks are a step of `work`,
  /// if it is not null.
  bool for_each_overlap(std::uint64_t budget, unsigned jobs, const Sink& sink,
                        WorkShare* work = nullptr) const;
  std::size_t num_tasks() const { return tasks_.size(); }

  /// Appends the facets whose boxes meet the ray from `from` along +axis (or -axis), in ascending position of the
  /// order; boxes that only touch it, and perhaps a few that just miss it, are among them. Returns false if there are
  /// more than `most`: then some are left out.
  bool stabbed(const Vec3d& from, int axis, bool positive, std::size_t most, std::vector<std::uint32_t>& out) const;

 private:
  struct alignas(32) Boxes8 {  // structure of arrays: one instruction compares eight boxes
    float lo[3][8], hi[3][8];
  };
  struct alignas(32) Ids8 {
    std::uint32_t id[3][8];  // star vertices of the facets; kNone where a corner is not a star
  };
  struct Task {
    std::uint32_t level, a, b;
  };
  friend struct BroadPhaseWalk;

  void build_groups(const TriangleMesh& mesh, const VertexStars& stars, unsigned jobs);
  void build_levels(unsigned jobs);
  void plan_tasks();
  bool stab(std::size_t level, std::size_t node, const float (&lo)[3], const float (&hi)[3], std::size_t most,
            std::vector<std::uint32_t>& out) const;

  UnitScale scale_;
  std::vector<std::uint32_t> order_;
  std::vector<Buffer<Boxes8>> levels_;  // levels_[0]: boxes of facets; levels_[k]: boxes of groups of level k - 1
  Buffer<Ids8> ids_;
  std::vector<Task> tasks_;
};

}  // namespace veritope
