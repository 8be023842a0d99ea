// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/dms/dms_insert.h: another vertex, inside of a tetrahedron, on a face or on an edge, so that the map stays what
// it is or changes by as little as is proved. Theory and design: docs/THEORY.md, DMS-3;
// docs/design/0099-refining-and-editing-simplex-spline-solids.md, 0103-attribute-domains-and-splits.md.
#pragma once
#include <cstdint>
#include <vector>

#include "robust/base/result.h"
#include "solids/dms/dms_change.h"
#include "solids/dms/dms_defects.h"
#include "solids/dms/dms_model.h"

namespace veritope {

struct DmsInsertion {
  /// The new vertex T is the last one. Each tetrahedron that was cut leaves its number to the part with T in the place
  /// of the first corner that T's simplex has; the others come after all others, by tetrahedra and then by corners.
  DmsModel model;
  DmsCut cut;
  std::uint32_t tetrahedron = 0;  ///< the first one that was cut
  /// If there are any, a condition does not hold for the new knots, the map of the model may be another, and there are
  /// no changes.
  DmsDefects defects;
  /// For each component: bounds of the change of the map, 0 where it stays equal.
  std::vector<DmsChange> change;
};

/// Cuts the tetrahedra that have the first knot of the cloud inside, on a face or on an edge. The control points at T
/// are values of the blossoms of these tetrahedra, and the others stay. Inside of a tetrahedron values and derivatives
/// stay exactly equal. (On the boundary rule H may enter the domain on another path; then derivatives at creases are
/// those of another cell.) On faces and edges a control point at T that several tetrahedra have is the mean of what
/// their blossoms say, component by component: that is the one with the least sum of squared distances from them.
/// REQUIRES a model without defects. @error kBadArgument for separate control points, for a point outside of the domain
/// or at a vertex, for a cloud of another size than 1, n or n + 1; kOverLimit for numbers too long for a file
/// @cost a blossom for each new control point, and what bound_dms_change costs; linear in the model
Result<DmsInsertion> insert_dms_vertex(const DmsModel& model, const DmsCloud& cloud);

}  // namespace veritope
