// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/dms/dms_exact_knots_internal.h: the knots of a model as the points that exact predicates take.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "predicates/exact_point.h"
#include "solids/dms/dms_model.h"

namespace veritope::internal {

class DmsExactKnots {
 public:
  explicit DmsExactKnots(const DmsModel& model) {
    for (const DmsCloud& cloud : model.clouds) {
      first_.push_back(points_.size());
      for (const DmsPoint& knot : cloud) points_.emplace_back(knot);
    }
    first_.push_back(points_.size());
  }
  /// Knot i of a vertex: t_0 where the cloud has none of that number.
  const ExactPoint3& at(std::uint32_t vertex, int i) const {
    const std::size_t n = static_cast<std::size_t>(i);
    return points_[first_[vertex] + (n < size(vertex) ? n : 0)];
  }
  std::size_t size(std::uint32_t vertex) const { return first_[vertex + 1] - first_[vertex]; }
  /// Whether knot i is one of the list, or t_0 for want of it.
  bool has(std::uint32_t vertex, int i) const {
    return i == 0 || static_cast<std::size_t>(i) < size(vertex);
  }

 private:
  std::vector<ExactPoint3> points_;
  std::vector<std::size_t> first_;
};

/// On which side of the plane through three points a fourth one lies: positive where they turn counter-clockwise.
inline Sign side_of(const std::array<const ExactPoint3*, 3>& plane, const ExactPoint3& p) {
  return orient3d(*plane[0], *plane[1], *plane[2], p);
}

}  // namespace veritope::internal
