// SPDX-License-Identifier: LGPL-3.0-or-later
// models/round_parts.h: parts of round solids, cut out by planes, which fit together along curved walls and edges.
#pragma once
#include <array>

#include "models/patch_shapes.h"

namespace veritope::patch_shapes {

/// The cylinder of radius 1 from z = 0 to z = height; both ends are discs of four patches with a pole in the middle.
Patches disc_cylinder(const Rational& height);
/// The cone of radius 1 at z = 0 with the apex at z = height, on such a disc.
Patches disc_cone(const Rational& height);

/// The union of the ball of radius 5 around the origin and the cylinder of radius 3 around the z axis from z = 0 to
/// z = 8, which leaves the ball in a circle at z = 4: patches of revolution, with one pole, at (0, 0, -5).
Patches ball_with_neck();

/// The patches whose points all have coordinates of these signs, or zero; 0 allows both.
Patches patches_with_signs(const Patches& patches, const std::array<int, 3>& signs);
/// A part of a boundary, closed by the segments from its border curves to a point: flat where these lie in a plane with
/// it. A solid if the part and the point are a star.
Patches coned(const Patches& part, const Point& apex);

}  // namespace veritope::patch_shapes
