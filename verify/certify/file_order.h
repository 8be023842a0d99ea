// SPDX-License-Identifier: LGPL-3.0-or-later
// verify/certify/file_order.h: pieces in the order in which certificates list them.
#pragma once
#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "solids/pieces/piece_forest.h"

namespace veritope {

/// Presents the patches of the forest as those of a file: the axes (in a triangle, corners 1 and 2) of an entity that
/// is reversed are exchanged.
class FileOrder {
 public:
  explicit FileOrder(const PieceForest& forest) : forest_(forest) {}

  /// Calls begin_patch(a, b), then visit(root) for 2^a x 2^b roots, v fastest.
  template <typename BeginPatch, typename Visit>
  void for_each_root(std::uint32_t patch, bool is_reversed, BeginPatch begin_patch,
                     Visit visit) const {
    const PieceForest::Form& form = forest_.form(patch);
    std::array<std::uint8_t, 2> bits{form.root_bits[0], form.root_bits[1]};
    const std::uint32_t columns = std::uint32_t{1} << bits[1];
    if (is_reversed) std::swap(bits[0], bits[1]);
    begin_patch(bits);
    for (std::uint32_t i = 0; i < std::uint32_t{1} << bits[0]; ++i)
      for (std::uint32_t j = 0; j < std::uint32_t{1} << bits[1]; ++j)
        visit(form.first_root + (is_reversed ? j * columns + i : i * columns + j));
  }
  /// Calls visit(child) four times. REQUIRES that the node has children.
  template <typename Visit>
  void for_each_child(PieceForest::Id id, bool is_reversed, Visit visit) const {
    const PieceForest::Id first = forest_.node(id).first_child;
    for (const PieceForest::Id k : {0u, 1u, 2u, 3u})
      visit(first + (is_reversed && (k == 1 || k == 2) ? 3 - k : k));
  }

 private:
  const PieceForest& forest_;
};

}  // namespace veritope
