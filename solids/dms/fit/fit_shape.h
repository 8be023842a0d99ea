// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/dms/fit/fit_shape.h: what tetrahedra of knots look like in binary64: for choices, and before exact tests.
#pragma once
#include <array>
#include <vector>

#include "solids/dms/dms_model.h"

namespace veritope {

/// The knots of a model, rounded. The model must outlive this object.
class RoundedKnots {
 public:
  explicit RoundedKnots(const DmsModel& model);

  /// d / longest edge^3, 0.71 for a regular tetrahedron; zero for a reversed one.
  double shape(const TetrahedronCorners& t) const;
  /// Whether the barycentre seems to be in all W_γ.
  bool has_core(const TetrahedronCorners& t) const;

 private:
  std::array<std::array<double, 3>, 4> knots(const TetrahedronCorners& t,
                                             const TetrahedralIndex& index) const;

  const DmsModel& model_;
  std::vector<std::vector<std::array<double, 3>>> clouds_;
};

}  // namespace veritope
