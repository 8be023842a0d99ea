// SPDX-License-Identifier: LGPL-3.0-or-later
// verify/certify/grid_box.h: boxes along the axes whose sides lie on a grid of a power of two.
#pragma once
#include "verify/certify/star_cover.h"

namespace veritope {

/// Boxes and centres are multiples of their box's size divided by approximately this number.
inline constexpr double kUnitsInBox = 64;

/// The nearest multiple of the unit.
double on_grid(double v, double unit);

/// The box, rounded outward. `unit` is a power of two.
CoverBox on_grid(const Box3d& box, double unit);

/// A cube around this middle, with its corners on a grid of a power of two, that contains the cube of half edge `half`.
CoverBox cube_around(const Point3d& middle, double half);

}  // namespace veritope
