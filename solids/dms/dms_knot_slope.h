// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/dms/dms_knot_slope.h: exact derivatives of a solid's map with respect to its knots
// (splines/dms_knot_slope.h). Control points stay where they are.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "solids/dms/dms_evaluator.h"

namespace veritope {

class DmsKnotSlopes {
 public:
  /// The model must outlive this object. REQUIRES a model without defects and with shared control points.
  explicit DmsKnotSlopes(const DmsModel& model);

  /// For x, y, z and each attribute the derivatives, at the point of the place, along the axes of a move of knot
  /// `index` of the vertex. REQUIRES 0 <= index < degree. @cost that of an exact evaluation
  std::vector<std::array<Rational, 3>> slope(const DmsPlace& place, std::uint32_t vertex,
                                             int index);

 private:
  const DmsModel& model_;
  DmsEvaluator evaluator_;
  std::vector<ExactPoint3> knots_;
  std::vector<std::size_t> first_knot_;
};

}  // namespace veritope
