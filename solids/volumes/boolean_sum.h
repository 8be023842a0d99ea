// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/volumes/boolean_sum.h: the volume inside six surfaces, and the surface inside four curves.
// Source: seed paper 000, section 3.2.2; [Coons67] for surfaces.
#pragma once
#include <array>

#include "solids/volumes/cell_maps.h"

namespace veritope {

/// u0(v, w), u1(v, w), v0(u, w), v1(u, w), w0(u, v), w1(u, v): the faces of a volume in its own axes.
using SixFaces = std::array<CellSurface, 6>;

/// "u0", ..., "w1".
const char* face_name(std::size_t face);

/// The volumetric Boolean sum P_u + P_v + P_w - P_uv - P_uw - P_vw + P_uvw of the six faces, which are its boundary
/// exactly: P_u is linear in u between u0 and u1, and so on. If a face is rational, all are taken in homogeneous form,
/// each times a positive constant, so that the homogeneous curves along their edges are equal.
/// @error  kBadArgument with the edge and the largest difference if two faces differ along their edge as homogeneous
///         curves; with the control point where a weight is not positive. kOverLimit
Result<CellVolume> boolean_sum(SixFaces faces);

/// Six surfaces in any order and orientation, which bound a cuboid layout (seed paper 000, section 5.4): arranges them,
/// the first as w0, so that each two faces of an edge agree along it, and takes the Boolean sum. If that is left-handed
/// in the middle, its first two axes change places. @error kBadArgument if no arrangement exists; as boolean_sum
Result<CellVolume> boolean_sum_in_any_order(const SixFaces& surfaces);

/// The surface whose sides are the curves v0(u), v1(u), u0(v), u1(v): the planar Boolean sum. @error as boolean_sum
Result<CellSurface> boolean_sum(std::array<CellCurve, 4> sides);

}  // namespace veritope
