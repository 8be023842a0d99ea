// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/expression/same_sheet_internal.h: whether two sheets, or two curves, are one near a point.
// Theory: docs/THEORY.md, POINT-8.
#pragma once
#include "solids/expression/tangent_cone.h"

namespace veritope::internal {

/// The sheet of a sector of a cone.
struct SheetOf {
  const TangentCone* cone;
  std::size_t index;
  const Sector& sector() const { return cone->sectors[index]; }
  const ConeSheet& sheet() const { return cone->sheets[index]; }
};

/// Whether both are parts of one surface near the apex, in all directions that both sectors hold, and beside common
/// rims: flat in one plane, or one map up to an affine change of parameters. False if that is not proved.
/// @cost  two exact evaluations for each coefficient of their difference: 1 ms for bicubic patches
bool is_same_surface(const SheetOf& a, const SheetOf& b);

/// For patches at irrational parameters inside of both (TangentCone::enclosure): 1 if they are one map up to an affine
/// change of parameters, with the solids on the same side; -1: on different sides; 0: neither is proved.
int enclosed_tie(const TangentCone& a, const TangentCone& b);

/// Whether the curves along two rims in one direction are one near the apex. REQUIRES rims that are not cuts.
bool is_same_curve(const SheetRim& a, const SheetRim& b);
/// Whether a curve lies in the plane of a sector, through the apex.
bool is_in_plane(const SheetRim& curve, const Sector& plane);

}  // namespace veritope::internal
