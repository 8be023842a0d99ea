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

enum class Walls {
  kApart,     ///< a solid whose walls have the distance of the gap, at least somewhere
  kTouching,  ///< they have a common point
  kCrossing,
};
struct Family {
  std::string name;
  Patches (*make)(const Rational& gap, Walls walls);
  std::vector<int> genus;  ///< of each shell of the sound solid
};
/// Every shape above; each sound one is one body.
std::vector<Family> families();

}  // namespace veritope::thin_shapes
