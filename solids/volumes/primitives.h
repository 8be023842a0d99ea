// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/volumes/primitives.h: boxes, cylinders, cones, tori and spheres as cells that share their walls exactly.
// Source: seed paper 000, section 3.2.3, figures 8 and 9.
#pragma once
#include <vector>

#include "solids/volumes/cell_maps.h"

namespace veritope {

using Cells = std::vector<CellVolume>;

/// All cells of the primitives are right-handed, and two cells that touch along a face have the same homogeneous
/// control points there. No Jacobian determinant vanishes, but in the apex of a cone (THEORY 7: the face that is a
/// point).

/// One cell, u, v and w along x, y and z. @error kBadArgument unless min < max in each coordinate
Result<Cells> box_cells(const CellPoint& min, const CellPoint& max);

/// On z = 0 around the z-axis, up to z = height. Cell 0 is the square prism in the middle; cells 1 to 4 are the
/// quarters around it, from the positive x-axis on: u outwards, v around, w up. @error kBadArgument unless radius,
/// height > 0
Result<Cells> cylinder_cells(const Rational& radius, const Rational& height);

/// A frustum on the same cells as a cylinder, with the radius `bottom` at z = 0 and `top` at z = height, top = 0 for
/// an apex. @error kBadArgument unless bottom, height > 0, top >= 0
Result<Cells> cone_cells(const Rational& bottom, const Rational& top, const Rational& height);

/// Around the z-axis, the circle of radius `minor` at the distance `major`. The cells are those of a disc, as in a
/// cylinder, w once around the axis; each is glued to itself. @error kBadArgument unless 0 < minor < major
Result<Cells> torus_cells(const Rational& major, const Rational& minor);

/// Around 0. Cell 0 is a cube; cells 1 to 6 lie between its faces z-, z+, x+, y+, x-, y- and the sphere, w outwards.
/// @error kBadArgument unless radius > 0
Result<Cells> sphere_cells(const Rational& radius);

/// Figure 8: the rectangle or half disc beside the z-axis, turned once around it. The cell is glued to itself, its face
/// v0 lies on the axis, and the two faces of a sphere's poles are points: N vanishes on these. @error as above
Result<Cells> one_cell_cylinder(const Rational& radius, const Rational& height);
Result<Cells> one_cell_sphere(const Rational& radius);

}  // namespace veritope
