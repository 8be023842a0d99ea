// SPDX-License-Identifier: Apache-2.0 OR MIT
// patch_cone.h: the flat patches at a point of a spline model; docs/certificates/points.md, section 7.
#pragma once
#include "cone.h"
#include "patch_points.h"

// The wedges of the patches at the place, which holds the point; false if they are not flat there.
bool find_patch_cone(const PatchSurface& surface, const RationalPoint& q, const PlaceOnPatch& place,
                     PointUnits* units, Cone* cone);
