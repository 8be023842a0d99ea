// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/dms/fit/fit_frame.h: barycentric coordinates in tetrahedra of knots, also where these are so flat that
// binary64 computes no volumes.
#pragma once
#include <array>

#include "solids/dms/dms_model.h"
#include "splines/simplex_spline.h"

namespace veritope {

struct FitFrame {
  /// The coordinate m of u is lambda[m][0] + lambda[m][1] u_x + lambda[m][2] u_y + lambda[m][3] u_z.
  std::array<std::array<double, 4>, 4> lambda{};
};

/// REQUIRES four points that are not in one plane. @cost a microsecond; for flat ones some 20
FitFrame fit_frame(const std::array<DmsPoint, 4>& points);

/// W_γ of a tetrahedron of the model.
std::array<DmsPoint, 4> last_knots(const DmsModel& model, std::uint32_t tetrahedron,
                                   const TetrahedralIndex& gamma);

/// Whether one of the W_γ with |γ| = n - 1 is nearly flat.
bool has_flat_knots(const DmsModel& model, std::uint32_t tetrahedron);

}  // namespace veritope
