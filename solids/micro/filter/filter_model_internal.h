// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/micro/filter/filter_model_internal.h: the mesh of a filter with its look-ups: points, facets near a box, one
// vertex of each shell. Internal to solids/micro/filter.
#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "interval/box.h"
#include "solids/base/box_hierarchy.h"
#include "solids/classify/mesh_classifier.h"
#include "solids/micro/filter/cell_net_internal.h"
#include "solids/micro/filter/tile_filter.h"

namespace veritope {

using FacetCorners = std::array<Vec3d, 3>;

class TileFilter::Model {
 public:
  Model(const TriangleMesh& mesh, MeshClassifier classifier);

  const MeshClassifier& classifier() const { return classifier_; }
  const TriangleMesh& mesh() const { return *mesh_; }

  /// The finding for one cell whose map is `net`, enclosed. REQUIRES a live ScopedUpward.
  CellFinding find(const internal::CellNet& net, const CellMap& cell, const TileShape& tile,
                   const TileFilterLimits& limits) const;

  /// Calls visit(facet) for every facet whose box meets the box. Facets have numbers of their own.
  template <typename Visit>
  void visit_facets(const Box3d& box, Visit visit) const {
    facet_tree_.visit([&](const Box3d& b) { return meets(b, box); }, visit);
  }
  const FacetCorners& corners(std::uint32_t facet) const { return corners_[facet]; }

  /// One if all points of the box are in the interior of M, zero if they are off M. REQUIRES no empty box.
  Value3 value(const Box3d& box) const {
    return is_finite(box) ? classifier_.value(box) : Value3::kMixed;
  }

  /// Calls visit(shell) for every shell whose first vertex lies in the box.
  template <typename Visit>
  void visit_shells(const Box3d& box, Visit visit) const {
    shell_tree_.visit([&](const Box3d& b) { return meets(b, box); }, visit);
  }
  /// The vertices of a shell, ascending.
  std::span<const std::uint32_t> shell_vertices(std::uint32_t shell) const {
    return {shell_vertices_.data() + shell_begin_[shell],
            shell_begin_[shell + 1] - shell_begin_[shell]};
  }
  std::uint32_t num_shells() const { return static_cast<std::uint32_t>(shell_begin_.size() - 1); }
  const Vec3d& position(std::uint32_t vertex) const { return mesh_->positions[vertex]; }

 private:
  void find_shells();

  const TriangleMesh* mesh_;
  MeshClassifier classifier_;
  std::vector<FacetCorners> corners_;
  BoxHierarchy facet_tree_;
  std::vector<std::uint32_t> shell_begin_, shell_vertices_;
  BoxHierarchy shell_tree_;
};

}  // namespace veritope
