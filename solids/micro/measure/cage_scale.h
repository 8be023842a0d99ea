// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/micro/measure/cage_scale.h: how much the cage stretches and shrinks the cells that hold tiles.
#pragma once
#include "robust/base/result.h"
#include "solids/micro/microstructure.h"

namespace veritope {

/// Bounds of det(T_u, T_v, T_w) over the cells that hold tiles, up to the sign that it has in a volume; u, v and w are
/// the parameters of the volume, each brought from its domain to [0, 1]. In cubic units of the model; the volume of a
/// small cell is that determinant times its part of the parameters.
struct CageScale {
  double lo = 0, hi = 0;  ///< 0 <= lo <= every value <= hi
};

/// Each bound is within 1 % of a value, or within 2^-20 of the greatest, unless the search ends before: at its limit of
/// work, or where a rational volume's determinant is not known better (2^-8 of the greatest, or more where weights are
/// very uneven). Then it is the bound that is known. {0, 0} if no cell holds a tile.
/// REQUIRES that the cage is that of micro, and that determinants of the cage have one sign in each volume.
/// @error kNotFinite: numbers beyond the range of binary64, or a weight that is not proved positive
/// @cost  a determinant for each span between knots that holds tiles, and for each bound at most 2^14 boxes, of 2^23
///        coefficients in all
Result<CageScale> scale_of(const Microstructure& micro, const VModel& cage);

}  // namespace veritope
