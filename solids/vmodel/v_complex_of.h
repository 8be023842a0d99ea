// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/vmodel/v_complex_of.h: the V-complex of a V-model, which knows what equals what without coordinates.
#pragma once
#include "robust/base/result.h"
#include "solids/vmodel/v_model.h"
#include "topology/hexahedral_v_complex.h"

namespace veritope {

/// V-cells are the model's cells. V-surfaces are glued pairs of faces, and single faces that are not collapsed.
/// Corners are one V-point iff they are the same exact point. Edges that are not collapsed are one V-curve iff they
/// are the same curve in either direction: as maps up to degrees, knots, affine changes of the domain and one
/// positive factor of homogeneous coordinates. So cells without a common V-surface can have common V-curves and
/// V-points, and the complex need not be a manifold there (v_complex_links.h). Ids are dense; V-points and V-curves
/// are in the order of their least corners and edges, and each V-curve runs as its least edge. Cells are reversed
/// as the model says.
/// @error kBadArgument, with the cell, where a collapse leaves no V-complex: a face whose four sides are collapsed
///        although it is not, an edge between collapsed faces only, a corner at which all edges are collapsed
/// @cost  near-linear
Result<HexahedralVComplex> v_complex_of(const VModel& model);

}  // namespace veritope
