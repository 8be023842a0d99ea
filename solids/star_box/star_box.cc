// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/star_box/star_box.h"

namespace veritope {
namespace {

bool has_star_signs(PieceForest& forest, PieceForest::Id id, const StarBox& star) {
  return forest.side_of(id, star.inside) == Sign3::kPositive &&
         forest.side_of(id, star.outside) == Sign3::kNegative;
}

// is_small(id): whether a piece is taken as it is.
template <typename IsSmall>
struct Descent {
  PieceForest& forest;
  const Box3d& box;
  IsSmall is_small;
  std::size_t most;
  std::vector<PieceForest::Id>* tested;
  std::vector<PieceForest::Id>* held;
  std::size_t visits = 0;

  bool run() {
    bool is_done = true;
    forest.roots().visit(
        [&](const Box3d& b) { return is_done && meets(b, box); },
        [&](std::uint32_t number) { is_done = is_done && visit(forest.root(number)); });
    return is_done;
  }
  bool visit(PieceForest::Id id) {
    const Box3d hull = forest.node(id).hull;
    if (!meets(hull, box)) return true;
    // Hulls may be unbounded, where weights are not known to be positive, and all pieces of such a patch meet every box.
    if (++visits > 16 * most) return false;
    if (is_inside(hull, box)) held->push_back(id);
    if (is_small(id)) {
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

Box3d hull_of_roots(const PieceForest& forest) {
  Box3d out = forest.node(forest.root(0)).hull;
  for (std::uint32_t r = 1; r < forest.num_roots(); ++r)
    out = hull(out, forest.node(forest.root(r)).hull);
  return out;
}

bool find_pieces(PieceForest& forest, const Box3d& box, double longest, std::size_t most,
                 std::vector<PieceForest::Id>* tested, std::vector<PieceForest::Id>* held) {
  const auto is_small = [&](PieceForest::Id id) { return extent(forest.node(id).hull) <= longest; };
  return Descent<decltype(is_small)>{forest, box, is_small, most, tested, held}.run();
}

bool find_star_pieces(PieceForest& forest, const StarBox& star, std::size_t most,
                      std::vector<PieceForest::Id>* tested, std::vector<PieceForest::Id>* held) {
  const auto is_small = [&](PieceForest::Id id) { return has_star_signs(forest, id, star); };
  return Descent<decltype(is_small)>{forest, star.box, is_small, most, tested, held}.run();
}

bool has_star_signs(PieceForest& forest, const std::vector<PieceForest::Id>& tested,
                    const StarBox& star) {
  for (const PieceForest::Id id : tested)
    if (!has_star_signs(forest, id, star)) return false;
  return true;
}

}  // namespace veritope
