// SPDX-License-Identifier: LGPL-3.0-or-later
// cli/dms_domain_input.h: what the input of veritope dms domain is, and tetrahedra of other programs.
#pragma once
#include <array>
#include <string>
#include <vector>

#include "io/read_model.h"
#include "io/tetrahedra/read_tetrahedra.h"

namespace veritope::cli {

enum class DomainInput { kPoints, kMesh, kTetrahedra };

/// TetGen's files by the endings .node and .ele, all others by their content, or by an ending that certify knows: its
/// models count as meshes, and what is not recognised as points. Standard input and pipes are points.
/// @error kCannotOpen, kOverLimit
Result<DomainInput> kind_of_domain_input(const std::string& path, const ModelReadOptions& reading);

/// The path, or both of TetGen's files if it is one of them: .node, then .ele.
std::vector<std::string> files_of_domain_input(const std::string& path);

/// Reads both of TetGen's files if one of them is given. REQUIRES kTetrahedra.
/// @error as read_medit, read_gmsh and read_tetgen; kCannotOpen
Result<TetrahedraFile> read_tetrahedra(const std::string& path, const ModelReadOptions& reading);

/// Swaps two corners of each tetrahedron with d < 0: other programs have other orders.
void turn_to_positive(const std::vector<std::array<Rational, 3>>& points,
                      std::vector<TetrahedronCorners>& tetrahedra);

}  // namespace veritope::cli
