// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/patches/patch_sources.h: patches from triangles, PN triangles, B-spline surfaces and the faces of Bezier
// volumes. Design: docs/design/0015-patch-complex.md.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "robust/base/result.h"
#include "solids/patches/patch_complex.h"
#include "solids/patches/pn_mesh.h"
#include "solids/polyhedron/triangle_mesh.h"
#include "splines/bspline.h"

namespace veritope {

/// A flat triangle for each facet, in their order; a facet that is not finite is left out and named (kNotFinite).
/// @error kIndexOutOfRange with the facet; kOverLimit.
Result<PatchInput> patches_of(const TriangleMesh& mesh);

/// A cubic Bezier triangle for each face, with the same numbers. The numbers of a rounded mesh are all finite, as
/// make_pn_mesh promises.
std::vector<Patch> patches_of(const PnMesh<Rational>& mesh);
std::vector<Patch> patches_of(const PnMesh<double>& mesh);

/// The Bezier pieces of B-spline surfaces, surface by surface, along axis 0 slowest. One or several surfaces are one
/// complex: where a whole side of one surface is a side of another (or of itself), as the same curve over [0,1] in
/// either direction, whatever its degree and knots, both surfaces are cut at the knots of both, and so on along
/// opposite sides, until no cut is missing. Surfaces that share only a part of a side do not fit, nor do those whose
/// common curve runs at another speed.
/// @error kBadArgument for a surface not in space; kOverLimit if there would be over kMaxPatches pieces, or a degree is
///        over kMaxSplineDegree, with the surface.
/// @cost  near-linear in the pieces, except for the comparison of sides: O(spans degree^2) each
Result<std::vector<Patch>> patches_of(std::span<const BSplineSurface<Rational>> surfaces);

/// The pieces of the surfaces, and where each surface is cut.
struct SurfacePieces {
  std::vector<Patch> patches;
  /// Each surface's breaks along u and v, in its own parameters: ascending, from the domain's begin to its end, with
  /// every knot between. The surface has one piece for each pair of neighbours along u and pair along v.
  std::vector<std::array<std::vector<Rational>, 2>> breaks;
};
/// @param numbers  the surfaces' numbers in origins and errors; if empty, they are numbered from 0. REQUIRES empty, or
/// one number for each surface.
/// @error as patches_of
Result<SurfacePieces> pieces_of(std::span<const BSplineSurface<Rational>> surfaces,
                                std::span<const std::uint64_t> numbers = {});

/// The faces of each volume, with outward normals if its Jacobian determinant is positive; surface number 6 v + 2 axis
/// + end. A face that two volumes share as a whole, with opposite normals and in whatever parametrisation by turned
/// domains, is an inner wall and left out. @error kBadArgument for a volume not in space.
Result<std::vector<Patch>> faces_of(std::span<const BezierVolume<Rational>> volumes);

}  // namespace veritope
