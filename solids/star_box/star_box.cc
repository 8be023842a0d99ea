// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/star_box/star_box.h"

namespace veritope {
namespace {

bool has_star_signs(PieceForest& forest, PieceForest::Id id, const StarBox& star) {
  return forest.side_of(id, star.inside) == Sign3::kPositive &&
         forest.side_of(id, star.outside) == Sign3::kNegative;
}

}  // namespace

bool find_star_pieces(PieceForest& forest, const StarBox& star, std::size_t most,
                      std::vector<PieceForest::Id>* tested, std::vector<PieceForest::Id>* held) {
  const auto is_small = [&](PieceForest::Id id) { return has_star_signs(forest, id, star); };
  return internal::find_small_pieces(forest, star.box, is_small, most, tested, held);
}

bool has_star_signs(PieceForest& forest, const std::vector<PieceForest::Id>& tested,
                    const StarBox& star) {
  for (const PieceForest::Id id : tested)
    if (!has_star_signs(forest, id, star)) return false;
  return true;
}

}  // namespace veritope
