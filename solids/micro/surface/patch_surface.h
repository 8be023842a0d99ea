// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/micro/surface/patch_surface.h: a complex of patches as the surface of a solid: nodes of patches, as
// docs/certificates/micro-inside.md, section 8, halves them.
#pragma once
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "solids/base/box_hierarchy.h"
#include "solids/classify/patch_piece.h"
#include "solids/micro/surface/solid_surface.h"
#include "solids/patches/patch_complex.h"

namespace veritope {

/// A node of a patch: level 0 is the patch, and a node of level l is halved in u if l is even, in v if it is odd. All
/// functions REQUIRE a live ScopedUpward.
class SurfaceNode {
 public:
  static constexpr int kMostLevel = 56;  // the page has 60
  explicit SurfaceNode(PatchPiece piece, int level = 0);

  const PatchPiece& piece() const { return piece_; }
  int level() const { return level_; }
  /// Bernstein coefficients, divided by their weights.
  const NodePoints& points() const { return points_; }
  bool can_halve() const { return level_ < kMostLevel; }
  std::pair<SurfaceNode, SurfaceNode> halves() const;
  /// True only if one of the four directions of the page has all points on one side of the node.
  bool is_apart(const NodePoints& points) const {
    return !meets(points_.box, points.box) || is_beside(slab_, points);
  }

 private:
  PatchPiece piece_;
  int level_;
  NodePoints points_;
  Slab slab_;
};

class PatchSurface final : public SolidSurface {
 public:
  /// REQUIRES positive weights, at least one patch. Does not refer to the complex.
  /// @cost  4,096 nodes, or one for each patch if these are more; 2 kilobytes each
  explicit PatchSurface(const PatchComplex& complex);

  /// Parts are nodes.
  std::unique_ptr<SurfaceView> view() const override;
  const Box3d& box() const override { return box_; }

  /// Nodes that cover the surface, each small beside it if patches are few.
  const std::vector<SurfaceNode>& nodes() const { return nodes_; }
  template <typename Visit>
  void visit(const Box3d& box, Visit visit) const {
    tree_.visit([&](const Box3d& b) { return meets(b, box); }, visit);
  }

 private:
  std::vector<SurfaceNode> nodes_;
  BoxHierarchy tree_;
  Box3d box_ = empty_box();
};

}  // namespace veritope
