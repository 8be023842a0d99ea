// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/pieces/find_pieces.h"

#include "solids/pieces/piece_descent.h"

namespace veritope {

Box3d hull_of_roots(const PieceForest& forest) {
  Box3d out = forest.node(forest.root(0)).hull;
  for (std::uint32_t r = 1; r < forest.num_roots(); ++r)
    out = hull(out, forest.node(forest.root(r)).hull);
  return out;
}

bool find_pieces(PieceForest& forest, const Box3d& box, double longest, std::size_t most,
                 std::vector<PieceForest::Id>* tested, std::vector<PieceForest::Id>* held) {
  const auto is_small = [&](PieceForest::Id id) { return extent(forest.node(id).hull) <= longest; };
  return internal::find_small_pieces(forest, box, is_small, most, tested, held);
}

}  // namespace veritope
