// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/collar/collar_mesh.h: boundaries of unions of octree cells as triangle meshes, without gaps where cells of
// different size meet.
#pragma once
#include <cstdint>
#include <vector>

#include "robust/base/result.h"
#include "solids/collar/octree_root.h"
#include "solids/polyhedron/triangle_mesh.h"
#include "topology/complex_boundary.h"

namespace veritope {

enum class CellSide {
  kOut,  ///< normals point out of the cells: the mesh bounds what holds the cells
  kIn,   ///< normals point into the cells: the mesh bounds what is left without them
};

/// The boundary faces of some components, in model units: coordinates times 2^-scale. A face with four vertices becomes
/// two triangles; one with more, where smaller faces hang on its sides, a fan around its middle. Each coordinate is
/// exact. REQUIRES boundary = analyse_boundary(complex), which.size() == boundary.components.size(), K1.
/// @error kNotFinite if a coordinate is not a binary64 number; kEmpty without a face
Result<TriangleMesh> boundary_mesh(const CommonSubdivision& complex,
                                   const ComplexBoundary& boundary, const std::vector<bool>& which,
                                   CellSide side, const OctreeRoot& root, int scale);

}  // namespace veritope
