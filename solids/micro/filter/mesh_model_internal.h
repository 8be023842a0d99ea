// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/micro/filter/mesh_model_internal.h: a solid that a mesh bounds, for the filter. Internal to
// solids/micro/filter.
#pragma once
#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "solids/base/box_hierarchy.h"
#include "solids/classify/mesh_classifier.h"
#include "solids/micro/filter/filter_model_internal.h"

namespace veritope::internal {

using FacetCorners = std::array<Vec3d, 3>;

class MeshModel final : public TileFilter::Model {
 public:
  /// The mesh must outlive it.
  MeshModel(const TriangleMesh& mesh, MeshClassifier classifier);

  const MeshClassifier& classifier() const { return classifier_; }
  PointAnswer classify(const ExactPoint& point) const override {
    return classifier_.classify(point);
  }
  std::unique_ptr<Obstacles> obstacles(const CellMap& cell, const TileShape& tile,
                                       const TileFilterLimits& limits) const override;
  Box3 vertex(std::uint32_t number) const override {
    const Vec3d& p = mesh_->positions[number];
    return Box3(Interval(p.x), Interval(p.y), Interval(p.z));
  }

  /// Calls visit(facet) for every facet whose box meets the box. Facets have numbers of their own.
  template <typename Visit>
  void visit_facets(const Box3d& box, Visit visit) const {
    facet_tree_.visit([&](const Box3d& b) { return meets(b, box); }, visit);
  }
  const FacetCorners& corners(std::uint32_t facet) const { return corners_[facet]; }

 private:
  Value3 finite_value(const Box3d& box) const override { return classifier_.value(box); }
  void find_shells();

  const TriangleMesh* mesh_;
  MeshClassifier classifier_;
  std::vector<FacetCorners> corners_;
  BoxHierarchy facet_tree_;
};

}  // namespace veritope::internal
