// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/dms/dms_insert.h: a vertex inside of a tetrahedron, which becomes four, so that the map stays what it is.
// Theory and design: docs/design/0099-refining-and-editing-simplex-spline-solids.md.
#pragma once
#include <cstdint>

#include "robust/base/result.h"
#include "solids/dms/dms_defects.h"
#include "solids/dms/dms_model.h"
#include "splines/dms_blossom.h"

namespace veritope {

/// The polynomial of a tetrahedron: its control points as a B-patch.
/// REQUIRES d(W_γ) != 0 for |γ| < degree, a model that validate() accepts.
BPatch<Rational> patch_of_tetrahedron(const DmsModel& model, std::uint32_t tetrahedron);

struct DmsInsertion {
  /// The new vertex T is the last one. The part of the tetrahedron with T in the place of corner 0 has its number;
  /// those with T in the place of corners 1, 2, 3 come after all others.
  DmsModel model;
  std::uint32_t tetrahedron = 0;  ///< the one that was cut
  /// If there are any, condition (a) does not hold for the new knots, and the map of the model may be another.
  DmsDefects defects;
};

/// Cuts the tetrahedron that has the first knot of the cloud inside. Values and derivatives stay exactly equal: the
/// control points at T are values of the tetrahedron's blossom, and the others stay. (On the boundary rule H may enter
/// the domain on another path; then derivatives at creases are those of another cell.)
/// REQUIRES a model without defects. @error kBadArgument for separate control points, for a point that is not inside of
/// a tetrahedron, for a cloud of another size than 1, n or n + 1; kOverLimit for numbers too long for a file
/// @cost a blossom for each new control point; linear in the model
Result<DmsInsertion> insert_dms_vertex(const DmsModel& model, const DmsCloud& cloud);

}  // namespace veritope
