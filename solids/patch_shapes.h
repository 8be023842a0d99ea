// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/patch_shapes.h: example models as patches with exact rational control points, their truth known by construction: sound ones, and
// broken ones whose names say what is wrong.
#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "solids/patch.h"

namespace veritope::patch_shapes {

using Point = RationalPoint;
using Patches = std::vector<Patch>;

// All normals point out of the solid. Circles are cut into quarters at the directions +x, +y, -x, -y; the weights of a quarter's ends
// are 1 and 2, so that they agree where quarters meet.

/// Six bilinear faces. REQUIRES low < high in every coordinate.
Patches box(const Point& low, const Point& high);
/// The unit sphere as six rational biquartic patches without a singular point: the images of a square around either pole by stereographic
/// projection, and four patches between them. chi = 8 - 12 + 6.
Patches sphere();
/// The unit sphere as eight biquadratic octants with collapsed sides at the poles. chi = 6 - 12 + 8.
Patches octant_sphere();
/// Distance R from the z axis to the middle of a circle of radius r: 16 rational biquadratic patches. Embedded iff r < R; r = R touches
/// itself in the origin, r > R crosses itself in two points of the axis.
Patches torus(const Rational& big_radius, const Rational& radius);
/// The same torus as one patch of degrees (5, 5), glued to itself along both pairs of opposite sides. chi = 1 - 2 + 1.
Patches one_patch_torus(const Rational& big_radius, const Rational& radius);

/// x -> factor * x + shift for each patch; a negative factor reverses them. REQUIRES factor != 0.
Patches placed(const Patches& patches, const Rational& factor, const Point& shift);
/// All of them, numbered anew.
Patches joined(std::initializer_list<Patches> parts);
/// Every normal the other way.
Patches inside_out(const Patches& patches);

}  // namespace veritope::patch_shapes
