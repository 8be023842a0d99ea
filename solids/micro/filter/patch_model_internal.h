// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/micro/filter/patch_model_internal.h: a solid that a closed complex of patches bounds, for the filter. Internal
// to solids/micro/filter.
#pragma once
#include <cstdint>
#include <memory>
#include <vector>

#include "solids/base/box_hierarchy.h"
#include "solids/classify/corner_hull.h"
#include "solids/classify/patch_classifier.h"
#include "solids/classify/patch_piece.h"
#include "solids/micro/filter/filter_model_internal.h"

namespace veritope::internal {

/// A part of a patch, with what proves pieces of tiles apart from it.
struct PatchObstacle {
  explicit PatchObstacle(PatchPiece part) : piece(std::move(part)), hull(piece) {}
  PatchPiece piece;
  CornerHull hull;
};

class PatchModel final : public TileFilter::Model {
 public:
  /// REQUIRES a closed oriented surface that bounds a solid; it must outlive the model.
  explicit PatchModel(const PatchComplex& complex);

  PointAnswer classify(const ExactPoint& point) const override {
    return classifier_.classify(point);
  }
  std::unique_ptr<Obstacles> obstacles(const CellMap& cell, const TileShape& tile,
                                       const TileFilterLimits& limits) const override;
  Box3 vertex(std::uint32_t number) const override { return vertices_[number]; }

  /// Parts of patches whose union is the surface, each small beside the model if patches are few.
  const std::vector<PatchObstacle>& parts() const { return parts_; }
  template <typename Visit>
  void visit_parts(const Box3d& box, Visit visit) const {
    tree_.visit([&](const Box3d& b) { return meets(b, box); }, visit);
  }
  /// The longest side of a box around the surface.
  double size() const { return size_; }

 private:
  Value3 finite_value(const Box3d& box) const override { return classifier_.value(box); }
  void cut(const PatchComplex& complex);
  void find_shells(const PatchComplex& complex);

  PatchClassifier classifier_;
  std::vector<PatchObstacle> parts_;
  BoxHierarchy tree_;
  std::vector<Box3> vertices_;
  double size_ = 0;
};

}  // namespace veritope::internal
