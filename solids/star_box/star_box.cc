// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/star_box/star_box.h"

#include "solids/star_box/piece_descent.h"

namespace veritope {
namespace {

bool has_star_signs(PieceForest& forest, PieceForest::Id id, const StarBox& star) {
  return forest.side_of(id, star.inside) == Sign3::kPositive &&
         forest.side_of(id, star.outside) == Sign3::kNegative;
}

// is_small(id): whether a piece is taken as it is.
template <typename IsSmall>
bool find(PieceForest& forest, const Box3d& box, IsSmall is_small, std::size_t most,
          std::vector<PieceForest::Id>* tested, std::vector<PieceForest::Id>* held) {
  return descend_to(forest, box, 16 * most, [&](PieceForest::Id id) {
    if (is_inside(forest.node(id).hull, box)) held->push_back(id);
    if (!is_small(id)) return PieceStep::kSplit;
    tested->push_back(id);
    return tested->size() <= most ? PieceStep::kTaken : PieceStep::kStop;
  });
}

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
  return find(forest, box, is_small, most, tested, held);
}

bool find_star_pieces(PieceForest& forest, const StarBox& star, std::size_t most,
                      std::vector<PieceForest::Id>* tested, std::vector<PieceForest::Id>* held) {
  const auto is_small = [&](PieceForest::Id id) { return has_star_signs(forest, id, star); };
  return find(forest, star.box, is_small, most, tested, held);
}

bool has_star_signs(PieceForest& forest, const std::vector<PieceForest::Id>& tested,
                    const StarBox& star) {
  for (const PieceForest::Id id : tested)
    if (!has_star_signs(forest, id, star)) return false;
  return true;
}

}  // namespace veritope
