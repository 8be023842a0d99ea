// SPDX-License-Identifier: LGPL-3.0-or-later
// models/thin_shapes.h: solids with thin walls, with exact rational control points: sound ones, and forms of them whose
// walls touch or cross.
#pragma once
#include <string>
#include <vector>

#include "models/patch_shapes.h"

namespace veritope::thin_shapes {

using patch_shapes::Patches;

/// The unit sphere with a spherical hole whose radius is 1 - gap, moved by `shift` along x. REQUIRES gap < 1. The walls
/// touch iff |shift| = gap.
Patches spheres(const Rational& gap, const Rational& shift);
/// Two tori with axis circles of radius 3, in the same way: the radii are 1 and 1 - gap.
Patches tori(const Rational& gap, const Rational& shift);
/// The unit square with the thickness `begin` at x = 0 and `end` at x = 1: the walls cross if the signs differ.
Patches plate(const Rational& begin, const Rational& end);
/// Rotated by the matrix of rows (2, -1, 2), (2, 2, -1), (-1, 2, 2) over 3: no wall along the axes stays so.
Patches turned(const Patches& patches);
/// A conical shell about the z axis between flat rings at z = 0 and z = 2, with the outer radii 1 and `top` and the
/// thicknesses `begin` and `end`: a tube if top = 1.
Patches cone(const Rational& top, const Rational& begin, const Rational& end);
/// `count` spheres around one middle, at the distance `gap` from one another, the outermost of radius 1: walls and gaps
/// in turn; the innermost is moved by `shift` along x. REQUIRES count * gap < 1.
Patches nested_spheres(int count, const Rational& gap, const Rational& shift);
/// The unit sphere with a spherical hole of half its radius, moved by `shift` along x: the walls touch iff |shift| is
/// 1/2, in a point where their curvatures differ.
Patches eccentric_spheres(const Rational& shift);
/// The unit square bent into a bicubic sheet, with the thickness `begin` at x = 0 and `end` at x = 1, measured along z.
Patches curved_plate(const Rational& begin, const Rational& end);
/// A C2 sheet of n x n bicubic patches over the unit square, wavy by about a tenth of its spans, with this thickness
/// along z.
Patches spline_sheet(int n, const Rational& thickness);
/// The unit square with the thickness 1/8 and a square hole of side `width` in its middle, in 16 bilinear patches.
Patches plate_with_hole(const Rational& width);
/// Two tori of 2 * 24 * 16 PN triangles each, with the radii 1 and 1 - gap, whose vertices are rounded to multiples of
/// 2^-20. Embedded at the gap 0.01.
Patches pn_shell(double gap);

enum class Walls {
  kApart,     ///< a solid whose walls have the distance of the gap, at least somewhere
  kTouching,  ///< they have a common point
  kCrossing,
};
struct Family {
  std::string name;
  Patches (*make)(const Rational& gap, Walls walls);
  std::vector<int> genus;  ///< of each shell of the sound solid
  int bodies = 1;          ///< of the sound solid
};
/// Shapes above whose walls can touch and cross, of few patches.
std::vector<Family> families();

}  // namespace veritope::thin_shapes
