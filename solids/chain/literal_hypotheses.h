// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/chain/literal_hypotheses.h: what definitions 8 and 9 of seed 001 [GRF03] assume of a model without saying so,
// decided exactly.  Theory: docs/THEORY.md, CHAIN-6.
#pragma once
#include <cstdint>
#include <optional>
#include <string>

namespace veritope {

/// Whether something is true of all its places: vertices, edges or base triangles.
struct LiteralHypothesis {
  std::uint64_t places = 0, violations = 0, undecided = 0;
  std::string
      first;  ///< the first violation, else the first place that is undecided; empty: neither

  /// Nothing: undecided.
  std::optional<bool> holds() const {
    if (violations > 0) return false;
    return undecided > 0 ? std::nullopt : std::optional<bool>(true);
  }
};

struct LiteralHypotheses {
  /// At each vertex: the planes of all its edges exist and have a line in common.
  LiteralHypothesis planes_share_lines;
  /// At each edge: its plane exists, and the boundary curve lies in it.
  LiteralHypothesis curves_in_planes;
  /// At each base triangle: it has a wedge, and its patch is a graph over it, which means the next three together.
  LiteralHypothesis graphs;
  LiteralHypothesis in_wedges;  ///< CHAIN-6.G1: the patch is in the wedge
  LiteralHypothesis
      facing;  ///< CHAIN-6.G2: it nowhere turns its back, seen along the normal of the base
  LiteralHypothesis upright;  ///< CHAIN-6.G3: the wedge nowhere reaches over the patch
};

}  // namespace veritope
