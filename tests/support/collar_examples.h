// SPDX-License-Identifier: LGPL-3.0-or-later
// tests/support/collar_examples.h: octree cells that are collars, cells that are not, and cells that a wrong rule would
// accept.
#pragma once
#include <string>
#include <vector>

#include "tests/support/complex_oracle.h"
#include "tests/support/octree_shapes.h"
#include "topology/collar.h"

namespace veritope::octree_shapes {

/// REQUIRES cells of which none contains another one.
CommonSubdivision build(const Cells& cells);
/// The place of a vertex, in cells of the finest level that occurs.
oracle::GridPoint grid(const CommonSubdivision& complex, std::uint32_t vertex);

struct CollarExample {
  std::string name;
  Cells cells;
  CollarOutcome outcome;
  std::vector<int> genus;  ///< each body's, ascending, if it is a product
};

/// A wall of 6 cells of level 5 around a cubic cavity.
Cells thick_wall();
/// 7^3 cells of level 3 with a cavity of 3^3, and two cells on it that share half an edge and nothing else.
Cells edge_contact_of_different_length();
/// 9^3 cells of level 4 with a cavity of 3^3, and two pits in it: they touch in a vertex, or in an edge.
Cells pits_with_common_vertex();
Cells pits_with_common_edge();

/// All of the above and more; shells at levels 4 to 6, alone and mixed.
std::vector<CollarExample> collar_examples();

}  // namespace veritope::octree_shapes
