// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/dms/fit/fit_constraint.h: where the knots of a vertex may move: in all planes of the boundary at the vertex,
// so that the domain stays the same set, and of features that the vertex lies on.
#pragma once
#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "solids/dms/dms_region.h"

namespace veritope {

/// A space, a plane, a line, or nothing, exactly.
class FitConstraint {
 public:
  /// Keeps what moves in the direction's plane. @param normal  not zero
  void add_normal(const DmsPoint& normal);

  std::size_t num_directions() const { return 3 - rank_; }
  /// The move that a step of 1 in direction i makes, rounded.
  std::array<double, 3> direction(std::size_t i) const;
  /// The point after steps in all directions, where it may be exactly; with zero steps the point itself. Coordinates
  /// that are free become binary64 numbers.
  DmsPoint moved(const DmsPoint& from, std::span<const double> steps) const;

 private:
  std::size_t rank_ = 0;
  std::size_t axis_ =
      0;  // of a plane the axis that depends on the others, of a line the one that the others depend on
  DmsPoint vector_;  // the normal of a plane, the direction of a line
};

/// For each vertex. REQUIRES the complex of the model.
std::vector<FitConstraint> fit_constraints(const DmsModel& model, const TetrahedralComplex& complex,
                                           std::span<const DmsPlane> features);

}  // namespace veritope
