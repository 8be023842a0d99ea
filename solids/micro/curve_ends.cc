// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/micro/curve_ends.h"

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

#include "robust/base/check.h"
#include "solids/micro/cell_piece.h"
#include "splines/bezier_calculus.h"
#include "splines/de_casteljau.h"

namespace veritope {
namespace {

const TilePatch& curve_of_end(const Microstructure& micro, const CurveEnd& end) {
  const std::uint8_t tile = micro.grids[end.grid].tiles[end.cell];
  VT_CHECK(tile != 0, "a curve of an empty cell");
  const TilePatch& out = micro.tiles[tile - 1u].patches[end.patch];
  VT_CHECK(out.is_curve() && !out.wall, "a curve that depends on no number of a wall");
  return out;
}
const TilePoint& point_of_end(const TilePatch& curve, bool is_last) {
  return is_last ? curve.points.front().back() : curve.points.front().front();
}

// A place in the parameters of a grid: the numbers of the cells that begin at or before it, and of the rest.
struct GridPlace {
  std::uint32_t grid = 0;
  std::array<std::uint64_t, 3> cell{};
  std::uint32_t rest = 0;
  friend auto operator<=>(const GridPlace&, const GridPlace&) = default;
};
// An end of a curve of a tile, wherever cells hold it.
struct TileEnd {
  std::uint32_t patch = 0;
  bool is_last = false;
  std::array<std::uint32_t, 3> step{};  // 1 at the far wall across an axis
  std::uint32_t rest = 0;  // the number of the coordinates, those at far walls taken as 0
  std::array<bool, 3> is_at_wall{};
};

class CurveEnds {
 public:
  explicit CurveEnds(const Microstructure& micro) : micro_(micro), piece_(micro) {
    for (const MicroTile& tile : micro.tiles) ends_.push_back(ends_of(tile));
  }

  std::vector<CurveEnd> run() {
    for (std::uint32_t g = 0; g < micro_.grids.size(); ++g)
      for (std::uint64_t c = 0; c < micro_.grids[g].tiles.size(); ++c)
        if (micro_.grids[g].tiles[c] != 0) add_cell(g, c);
    std::sort(found_.begin(), found_.end());
    std::vector<CurveEnd> out;
    for (std::size_t i = 0, j = 0; i < found_.size(); i = j) {
      while (j < found_.size() && found_[j].first == found_[i].first) ++j;
      const CurveEnd& end = found_[i].second;
      if (j - i == 1 && !is_met_across_grids(end)) out.push_back(end);
    }
    std::sort(out.begin(), out.end());
    return out;
  }

 private:
  std::vector<TileEnd> ends_of(const MicroTile& tile) {
    std::vector<TileEnd> out;
    for (std::uint32_t i = 0; i < tile.patches.size(); ++i) {
      if (!tile.patches[i].is_curve()) continue;
      for (const bool is_last : {false, true}) {
        TileEnd end;
        end.patch = i;
        end.is_last = is_last;
        TilePoint at = point_of_end(tile.patches[i], is_last);
        for (std::size_t a = 0; a < 3; ++a) {
          end.step[a] = at[a] == Rational(1);
          if (end.step[a] != 0) at[a] = Rational(0);
          end.is_at_wall[a] = at[a] == Rational(0);
        }
        if (end.is_at_wall == std::array<bool, 3>{}) continue;
        const auto next = static_cast<std::uint32_t>(rests_.size());
        end.rest = rests_.try_emplace(at, next).first->second;
        out.push_back(end);
      }
    }
    return out;
  }

  void add_cell(std::uint32_t g, std::uint64_t c) {
    const MicroGrid& grid = micro_.grids[g];
    const Grid<3> shape = grid.shape();
    const auto cell = shape.index_of(c);
    for (const TileEnd& end : ends_[grid.tiles[c] - 1u]) {
      GridPlace place{g, {}, end.rest};
      bool is_in_face = false;
      for (std::size_t a = 0; a < 3; ++a) {
        place.cell[a] = cell[a] + end.step[a];
        is_in_face = is_in_face ||
                     (end.is_at_wall[a] && (place.cell[a] == 0 || place.cell[a] == shape.size[a]));
      }
      const CurveEnd found{g, c, end.patch, end.is_last};
      found_.emplace_back(place, found);
      if (!is_in_face) continue;
      std::uint32_t& num = num_at_[place_of(micro_, found, piece_).at];
      ++num;
      in_faces_.emplace(found, &num);
    }
  }
  // Grids meet in their faces: there ends are compared in space.
  bool is_met_across_grids(const CurveEnd& end) const {
    const auto in_face = in_faces_.find(end);
    return in_face != in_faces_.end() && *in_face->second > 1;
  }

  const Microstructure& micro_;
  std::map<TilePoint, std::uint32_t> rests_;
  std::vector<std::vector<TileEnd>> ends_;  // by tiles
  std::vector<std::pair<GridPlace, CurveEnd>> found_;
  CellPiece piece_;
  std::map<std::array<Rational, 3>, std::uint32_t> num_at_;  // how many ends have an image
  std::map<CurveEnd, const std::uint32_t*> in_faces_;        // those numbers
};

}  // namespace

std::vector<CurveEnd> free_curve_ends(const Microstructure& micro) {
  return CurveEnds(micro).run();
}

CurveEndPlace place_of(const Microstructure& micro, const CurveEnd& end, CellPiece& piece) {
  const TilePatch& curve = curve_of_end(micro, end);
  const std::vector<TilePoint>& points = curve.points.front();
  const TilePoint& last = point_of_end(curve, end.is_last);
  const TilePoint& before = end.is_last ? points[points.size() - 2] : points[1];
  piece.enter(end.grid, micro.grids[end.grid].shape().index_of(end.cell));
  std::array<Rational, 3> at, direction;
  for (std::size_t a = 0; a < 3; ++a) {
    at[a] = piece.brought(a, last[a]);
    direction[a] = piece.stretched(a, Rational(curve.degrees[0]) * (last[a] - before[a]));
  }
  // The map X / w is taken as the polynomial map (X, w), whose derivative is (X', w'): (X / w)' = (X' - (X / w) w') /
  // w.
  const BezierVolume<Rational>& map = piece.map();
  const auto net = map.coefficients();
  const BezierVolume<Rational> homogeneous(map.degrees(), map.num_components(), false,
                                           {net.begin(), net.end()});
  std::vector<Rational> value = evaluate<Rational, 3>(homogeneous, at), slope(value.size());
  for (std::size_t a = 0; a < 3; ++a) {
    if (direction[a] == Rational(0)) continue;
    const std::vector<Rational> partial = evaluate<Rational, 3>(derivative(homogeneous, a), at);
    for (std::size_t c = 0; c < slope.size(); ++c) slope[c] += direction[a] * partial[c];
  }
  CurveEndPlace out;
  for (std::size_t c = 0; c < 3; ++c) {
    out.at[c] = map.is_rational() ? value[c] / value[3] : value[c];
    out.tangent[c] =
        map.is_rational() ? (slope[c] - out.at[c] * slope[3]) / value[3] : std::move(slope[c]);
  }
  return out;
}

}  // namespace veritope
