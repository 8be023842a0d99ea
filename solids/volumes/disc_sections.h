// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/volumes/disc_sections.h: the flat and round surfaces from which primitives are made, of radius 1.
#pragma once
#include <vector>

#include "solids/volumes/cell_maps.h"

namespace veritope::internal {

/// The disc of radius 1 around 0 in the plane z = 0: a square with corners at half the radius on the axes, and four
/// quarters from its sides to the circle, u outwards, v counterclockwise. The quarter arcs of degree 2 have the weights
/// 1, 1, 2 and 2, 1, 1 in turn, so that the homogeneous control points of neighbours are equal where they meet.
std::vector<CellSurface> disc_sections();

/// A face of the cube from -1 to 1, and the part of the sphere of radius 1 over it, with the normal s x t outwards. The
/// homogeneous control points of neighbouring parts of the sphere are equal along their common sides.
struct SphereSide {
  CellSurface cube, sphere;
};
/// z-, z+, x+, y+, x-, y-.
std::vector<SphereSide> sphere_sides();

/// Half of the disc of radius 1 in the plane y = 0, x >= 0: u upwards along the arc, v from the z-axis to it.
CellSurface half_disc();

}  // namespace veritope::internal
