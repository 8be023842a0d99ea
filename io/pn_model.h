// SPDX-License-Identifier: LGPL-3.0-or-later
// io/pn_model.h: the smooth surface over the triangles of a mesh file, with the normals of the file
// (solids/patches/pn_mesh.h).
#pragma once
#include "io/mesh/read_mesh.h"
#include "io/splines/spline_model.h"
#include "robust/base/result.h"

namespace veritope {

/// A cubic Bezier triangle for each face, in their order, exactly: with the normals of the file if it has some, else
/// with the sums of the triangles' normals, weighted by their areas.
/// @error kBadArgument with the face and the vertex: a corner without a normal where others have one; two normals at
///        one vertex that differ, since edges between faces would not fit; what make_pn_mesh refuses
Result<SplineModel> pn_model(const MeshFile& file);

}  // namespace veritope
