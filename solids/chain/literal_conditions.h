// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/chain/literal_conditions.h: definition 1 of seed 001 [GRF03] for the cells of the literal chain: three
// conditions, decided for each cell, or open.  Theory: docs/THEORY.md, CHAIN-8.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "solids/chain/literal_hypotheses.h"

namespace veritope {

/// A set that definition 1 does not accept as a free-form cell.
struct RefusedCell {
  std::uint32_t patch = 0;
  std::uint32_t half = 0;  ///< of a patch of four sides
  bool is_plus = true;
  const char* figure =
      "";           ///< "1a": it is not connected; "3a": three of its planes meet off the patch
  std::string why;  ///< with the name of the patch
};

/// The places of the conditions are cells. A patch that crosses the plane of its base has two, its parts on both sides
/// of that plane (figure 8), a patch in that plane none.
struct LiteralCells {
  std::uint64_t plus = 0, minus = 0;
  std::uint64_t split = 0;  ///< patches, or halves of them, with two cells
  std::uint64_t undecided =
      0;  ///< base triangles for which it is open on which sides there are cells: not counted
  std::uint64_t without_wedge = 0;  ///< base triangles over which no cell is defined
  /// Condition 1: the cell is closed and connected.
  LiteralHypothesis connected;
  /// Condition 2: no point in the interior of the cell lies on the surface of which the patch is a part.
  LiteralHypothesis on_one_side;
  /// Condition 3: points common to three of its bounding planes lie on the patch.
  LiteralHypothesis with_vertices_on_patch;
  std::vector<RefusedCell> refused;  ///< in the order of their patches
};

}  // namespace veritope
