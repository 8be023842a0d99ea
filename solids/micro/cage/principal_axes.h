// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/micro/cage/principal_axes.h: the principal directions of a symmetric tensor, approximately.
#pragma once
#include <array>

#include "robust/base/box3d.h"

namespace veritope {

/// xx, yy, zz, xy, yz, zx.
using SymmetricTensor = std::array<double, 6>;

struct PrincipalAxes {
  std::array<double, 3> values;  ///< descending
  std::array<Point3d, 3>
      directions;  ///< of unit length, across each other, in this order; their signs mean nothing

  /// Whether the first value is above the second by at least 2^-30 of the greatest absolute value, so that the first
  /// direction means something.
  bool has_first() const;
};

/// Jacobi's rotations: the values are within a few roundings of the greatest one. No decision may use them.
/// REQUIRES finite numbers of at most 2^500.
PrincipalAxes approx_principal_axes(const SymmetricTensor& tensor);

}  // namespace veritope
