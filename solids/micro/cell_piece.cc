// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/micro/cell_piece.h"
#include "splines/blossom_weights.h"
#include "splines/composition_span.h"

namespace veritope {

void CellPiece::enter(std::size_t number, const std::array<std::size_t, 3>& cell) {
  const MicroGrid& grid = micro_->grids[number];
  const VVolume& volume = micro_->cage[grid.volume];
  std::array<std::size_t, 3> spans;
  for (std::size_t a = 0; a < 3; ++a) {
    const Rational &low = grid.breaks[a][cell[a]], &high = grid.breaks[a][cell[a] + 1];
    spans[a] = internal::find_span(volume.axis(a), low);
    const Rational &begin = volume.axis(a).knots[spans[a]],
                   length = volume.axis(a).knots[spans[a] + 1] - begin;
    offset_[a] = (low - begin) / length;
    width_[a] = (high - low) / length;
  }
  if (map_.has_value() && grid_ == number && spans_ == spans) return;
  grid_ = number;
  spans_ = spans;
  map_ = bezier_piece(volume, spans);
}

}  // namespace veritope
