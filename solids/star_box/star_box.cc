// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/star_box/star_box.h"

namespace veritope {
bool has_star_signs(PieceForest& forest, PieceForest::Id id, const CentreLine& centres) {
  return forest.side_of(id, centres.inside) == Sign3::kPositive &&
         forest.side_of(id, centres.outside) == Sign3::kNegative;
}

bool find_star_pieces(PieceForest& forest, const StarBox& star, std::size_t most,
                      std::vector<PieceForest::Id>* tested, std::vector<PieceForest::Id>* held) {
  const CentreLine centres{star.inside, star.outside};
  const auto is_small = [&](PieceForest::Id id) { return has_star_signs(forest, id, centres); };
  return internal::find_small_pieces(forest, star.box, is_small, most, tested, held);
}

bool has_star_signs(PieceForest& forest, const std::vector<PieceForest::Id>& tested,
                    const StarBox& star) {
  const CentreLine centres{star.inside, star.outside};
  for (const PieceForest::Id id : tested)
    if (!has_star_signs(forest, id, centres)) return false;
  return true;
}

}  // namespace veritope
