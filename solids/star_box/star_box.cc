// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/star_box/star_box.h"

namespace veritope {
namespace {

struct Descent {
  PieceForest& forest;
  const Box3d& box;
  double longest;
  std::size_t most;
  std::vector<PieceForest::Id>* tested;
  std::vector<PieceForest::Id>* held;

  std::size_t visits = 0;

  bool visit(PieceForest::Id id) {
    const Box3d hull = forest.node(id).hull;
    if (!meets(hull, box)) return true;
    // Hulls may be unbounded, where weights are not known to be positive, and all pieces of such a patch meet every box.
    if (++visits > 16 * most) return false;
    if (is_inside(hull, box)) held->push_back(id);
    if (extent(hull) <= longest) {
      tested->push_back(id);
      return tested->size() <= most;
    }
    if (forest.node(id).level == PieceForest::kMaxLevel) return false;
    const PieceForest::Id first = forest.children(id);
    for (PieceForest::Id k = 0; k < 4; ++k)
      if (!visit(first + k)) return false;
    return true;
  }
};

}  // namespace

bool find_pieces(PieceForest& forest, const Box3d& box, double longest, std::size_t most,
                 std::vector<PieceForest::Id>* tested, std::vector<PieceForest::Id>* held) {
  Descent descent{forest, box, longest, most, tested, held};
  bool is_done = true;
  forest.roots().visit(
      [&](const Box3d& b) { return is_done && meets(b, box); },
      [&](std::uint32_t number) { is_done = is_done && descent.visit(forest.root(number)); });
  return is_done;
}

bool has_star_signs(PieceForest& forest, const std::vector<PieceForest::Id>& tested,
                    const StarBox& star) {
  for (const PieceForest::Id id : tested)
    if (forest.side_of(id, star.inside) != Sign3::kPositive ||
        forest.side_of(id, star.outside) != Sign3::kNegative)
      return false;
  return true;
}

}  // namespace veritope
