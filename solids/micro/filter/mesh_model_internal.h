// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/micro/filter/mesh_model_internal.h: a solid that a mesh bounds, for the filter. Internal to
// solids/micro/filter.
#pragma once
#include <array>
#include <cstdint>
#include <memory>
#include <vector>

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

  /// In increasing order: all facets that meet the box, and perhaps others near it.
  std::vector<std::uint32_t> facets_near(const Box3d& box) const {
    return classifier_.facets_near(box);
  }
  FacetCorners corners(std::uint32_t facet) const {
    const auto& t = mesh_->faces[facet];
    return {mesh_->positions[t[0]], mesh_->positions[t[1]], mesh_->positions[t[2]]};
  }

 private:
  Value3 finite_value(const Box3d& box) const override { return classifier_.value(box); }
  void find_shells();

  const TriangleMesh* mesh_;
  MeshClassifier classifier_;
};

}  // namespace veritope::internal
