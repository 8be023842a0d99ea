// SPDX-License-Identifier: LGPL-3.0-or-later
// io/trees/build_tree.h: from a tree of volumes to the cells that it describes, exactly.
// Format: docs/formats/trees.md. Design: docs/design/0065-trees-of-volumes.md.
#pragma once
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "io/trees/tree_node.h"
#include "robust/base/result.h"
#include "solids/volumes/cell_maps.h"

namespace veritope {

/// The most cells of a tree, and the most coefficients of all its cells together.
inline constexpr std::size_t kMaxTreeCells = std::size_t{1} << 20,
                             kMaxTreeNumbers = std::size_t{1} << 24;

/// Reads the splines of a file that a node names; the path is as the tree has it.
using LoadSplines = std::function<Result<SplineModel>(const std::string& path)>;

/// What a node did that the tree does not say in full.
struct TreeNote {
  std::string pointer, op;
  /// A rotation by degrees, or a turn: how far the exact angle may be from the degrees asked for.
  std::optional<Rational> degrees, error;
  /// A matrix: solids/volumes/placed.h.
  std::optional<Rational> distance_from_rotation, determinant;
};

struct BuiltTree {
  std::vector<CellVolume>
      cells;  ///< nodes in the order of the tree, each node's cells in its documented order
  std::vector<TreeNote> notes;
  std::uint64_t num_nodes = 0, num_files = 0;
};

/// @error  kBadArgument, kOverLimit, or as `load`, with the line of the node; the message begins with the JSON pointer
///         of the node, or of its parameter if the sentence begins with that
/// @cost   sizes are checked before the memory is taken: kMaxTreeCells, kMaxTreeNumbers; numbers may take 64 MiB and 32
///         bytes for each byte of the tree and of its files
Result<BuiltTree> build_tree(const TreeFile& tree, const std::string& name,
                             const LoadSplines& load);

/// The cells as entities without groups.
SplineModel model_of_cells(const std::vector<CellVolume>& cells);

}  // namespace veritope
