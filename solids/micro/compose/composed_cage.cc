// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/micro/compose/composed_cage.h"

#include <algorithm>
#include <array>
#include <string>
#include <utility>

#include "solids/micro/cell_piece.h"
#include "splines/bezier_lowering.h"
#include "splines/bspline_pieces.h"
#include "splines/composition_integer.h"

namespace veritope {
namespace {

class CageComposer {
 public:
  CageComposer(const Microstructure& micro, const VolumesOfTile& volumes, std::size_t max_volumes)
      : micro_(micro), volumes_(volumes), max_volumes_(max_volumes), piece_(micro) {}

  Result<std::vector<VVolume>> compose() {
    for (std::size_t g = 0; g < micro_.grids.size(); ++g) {
      const MicroGrid& grid = micro_.grids[g];
      const Grid<3> shape = grid.shape();
      for (std::size_t c = 0; c < grid.tiles.size(); ++c)
        if (grid.tiles[c] != 0)
          if (Status status = add_cell(g, shape.index_of(c)); !status) return status.error();
    }
    if (out_.empty()) return Error{Code::kEmpty, {}, "no cell holds a tile"};
    return std::move(out_);
  }

 private:
  Status add_cell(std::size_t number, const std::array<std::size_t, 3>& cell) {
    const MicroGrid& grid = micro_.grids[number];
    piece_.enter(number, cell);
    const std::size_t tile = grid.tiles[grid.shape().at(cell)] - std::size_t{1};
    for (const BezierVolume<Rational>& volume : volumes_(tile, grid.numbers_of(cell))) {
      if (out_.size() == max_volumes_)
        return Error{Code::kOverLimit,
                     {},
                     "the tiles have more than " + std::to_string(max_volumes_) +
                         " volumes, and a cage has no more"};
      if (Status status = add(volume, number, cell); !status) return status;
    }
    return ok_status();
  }
  Status add(BezierVolume<Rational> inner, std::size_t number,
             const std::array<std::size_t, 3>& cell) {
    for (std::size_t a = 0; a < 3; ++a)
      for (Rational& x : inner.component(static_cast<int>(a))) x = piece_.brought(a, x);
    const Result<BezierVolume<Rational>> composed = compose_by_integers(piece_.map(), inner);
    if (!composed) return composed.error();
    BezierVolume<Rational> least = lowered(*composed);
    const int degree = *std::max_element(least.degrees().begin(), least.degrees().end());
    if (degree > kMaxVDegree)
      return Error{Code::kOverLimit,
                   {},
                   "a volume of the tile in cell (" + std::to_string(cell[0]) + ", " +
                       std::to_string(cell[1]) + ", " + std::to_string(cell[2]) + ") of grid " +
                       std::to_string(number) + " would have degree " + std::to_string(degree) +
                       " after composition, and volumes of a cage have at most " +
                       std::to_string(kMaxVDegree)};
    out_.push_back(to_bspline(least));
    return ok_status();
  }

  const Microstructure& micro_;
  const VolumesOfTile& volumes_;
  std::size_t max_volumes_;
  CellPiece piece_;
  std::vector<VVolume> out_;
};

}  // namespace

Result<std::vector<VVolume>> composed_cage(const Microstructure& micro,
                                           const VolumesOfTile& volumes, std::size_t max_volumes) {
  return CageComposer(micro, volumes, max_volumes).compose();
}

}  // namespace veritope
