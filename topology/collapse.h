// SPDX-License-Identifier: LGPL-3.0-or-later
// topology/collapse.h: collapses of a cell complex onto a part of its boundary, found greedily or replayed.
// Theory: docs/THEORY.md, COLLAR-1.K3.
#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "topology/common_subdivision.h"
#include "topology/complex_boundary.h"

namespace veritope {

/// Removes a cell of dimension d and a free face of it, of dimension d - 1: a face that no other remaining cell has.
struct Collapse {
  std::uint32_t face, coface;
  friend bool operator==(const Collapse&, const Collapse&) = default;
};

/// All of `cells` come first, then `faces`, then `edges`, each in order. This order loses nothing: a collapse of higher
/// dimension may be moved before one of lower dimension, whose cells are not faces of a remaining cell.
struct CollapseSequence {
  std::vector<Collapse> cells;  ///< (face, cell)
  std::vector<Collapse> faces;  ///< (edge, face)
  std::vector<Collapse> edges;  ///< (vertex, edge)
  std::size_t size() const { return cells.size() + faces.size() + edges.size(); }
  friend bool operator==(const CollapseSequence&, const CollapseSequence&) = default;
};

/// Which free face goes next while cells remain. What can be collapsed afterwards does not depend on the order.
enum class CollapseOrder {
  kBreadthFirst,          ///< from all faces of d- at once, in the order of their numbers: the front moves like a wave
  kShuffledBreadthFirst,  ///< as kBreadthFirst, from the faces of d- in a random order
  kRandomFront,           ///< any face of the front
};

/// The result of a greedy collapse. `sequence` holds the collapses of the finished bodies only.
struct CollapseAttempt {
  CollapseSequence sequence;
  std::vector<std::uint32_t> stuck;  ///< bodies where something outside d+ remains, ascending
  /// The numbers of vertices, edges, faces and cells outside d+ that remain in them; no cell ever does.
  std::array<std::uint64_t, 4> remaining{};
  /// Dimension and id of a remaining cell of the greatest dimension.
  std::array<std::uint32_t, 2> remains_at{};
};

/// Collapses each body of `bodies` onto the boundary component d_plus[i] (of bodies[i]) as far as the greedy order
/// gets.
/// REQUIRES boundary = analyse_boundary(complex), is_manifold(), bodies ascending, d_plus[i] a component that bounds
/// bodies[i] and is not the only one that does (then some cell has a free face outside d+, and all cells of the body
/// are removed, since it is connected).
/// @cost O(size of the complex)
CollapseAttempt collapse_greedily(const CommonSubdivision& complex, const ComplexBoundary& boundary,
                                  std::span<const std::uint32_t> bodies,
                                  std::span<const std::uint32_t> d_plus, CollapseOrder order,
                                  std::uint64_t seed);

/// Why a claimed sequence is not a collapse.
enum class CollapseFault {
  kNone,
  kNoSuchCell,       ///< an id out of range, or d+ is not ascending
  kNotBoundary,      ///< a face of d+ lies between two cells
  kPartOfComponent,  ///< K2: an edge has boundary faces in d+ and others
  kInDPlus,          ///< the free face lies in d+
  kAbsent,           ///< the free face or the coface was removed before
  kNotFree,          ///< the free face has several remaining cofaces
  kNotCoface,        ///< the pair is not incident
  kLeft,             ///< something outside d+ remains
};

struct CollapseCheck {
  CollapseFault fault = CollapseFault::kNone;
  std::uint64_t step = 0;  ///< in the sequence, which numbers cells, faces and edges consecutively
  unsigned dimension = 0;  ///< of the cell at fault
  std::uint32_t id = 0;
  std::string message;  ///< a sentence with the place; empty without fault
};

/// Decides K2 and K3 as a checker does: are the faces d_plus whole boundary components, and does the sequence collapse
/// the complex onto them? Takes any input and trusts none of it. What follows from the answer REQUIRES K1.
/// @cost O(size of the complex)
CollapseCheck replay_collapse(const CommonSubdivision& complex,
                              std::span<const std::uint32_t> d_plus,
                              const CollapseSequence& sequence);

/// "edge (16 16 28)-(16 16 30) / 32": coordinates in units of the finest level that occurs.
/// REQUIRES dimension <= 3 and an id of that dimension.
std::string name_of(const CommonSubdivision& complex, unsigned dimension, std::uint32_t id);

}  // namespace veritope
