// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/micro/sweep_start.h"

#include <algorithm>
#include <utility>

#include "interval/upward.h"
#include "splines/bezier_domain.h"

namespace veritope {
namespace {

BezierPieces<Interval, 3> enclosed_pieces(const VVolume& volume) {
  const BezierPieces<Rational, 3> exact = bezier_pieces(volume);
  BezierPieces<Interval, 3> out;
  out.breaks = exact.breaks;
  for (const BezierVolume<Rational>& piece : exact.pieces) {
    std::vector<Interval> c;
    for (const Rational& x : piece.coefficients()) c.push_back(enclose(x));
    out.pieces.emplace_back(piece.degrees(), piece.num_components(), piece.is_rational(),
                            std::move(c));
  }
  return out;
}

}  // namespace

SweepStarts::SweepStarts(const Microstructure& micro, const std::vector<AnalysedTile>& tiles)
    : micro_(micro), tiles_(tiles), pieces_(micro.cage.size()) {
  const ScopedUpward upward;
  for (const MicroGrid& grid : micro.grids)
    if (pieces_[grid.volume].pieces.empty())
      pieces_[grid.volume] = enclosed_pieces(micro.cage[grid.volume]);
}

SweepStarts::Span SweepStarts::span(const CapPlace& place, std::size_t axis) const {
  const MicroGrid& grid = micro_.grids[place.grid];
  const std::size_t i = grid.shape().index_of(place.cell)[axis];
  return {grid.breaks[axis][i], grid.breaks[axis][i + 1]};
}

std::array<Rational, 3> SweepStarts::widths(const CapPlace& place) const {
  std::array<Rational, 3> out;
  for (std::size_t a = 0; a < 3; ++a) {
    const Span s = span(place, a);
    out[a] = s[1] - s[0];
  }
  return out;
}

const Rational& SweepStarts::position(const CapPlace& place) const {
  const MicroGrid& grid = micro_.grids[place.grid];
  const auto axis = static_cast<std::size_t>(place.wall / 2);
  return grid.breaks[axis][grid.shape().index_of(place.cell)[axis] +
                           static_cast<std::size_t>(place.wall % 2)];
}

std::optional<BezierSurface<Rational>> SweepStarts::cap(const CapPlace& place) const {
  const MicroGrid& grid = micro_.grids[place.grid];
  const AnalysedTile& tile = tiles_[grid.tiles[place.cell] - 1u];
  const auto& caps = tile.caps_of_wall[static_cast<std::size_t>(place.wall)];
  if (caps.size() != 1 || tile.caps[caps[0]].patches.size() != 1) return std::nullopt;
  const TilePatch& patch = tile.tile.patches[tile.caps[caps[0]].patches[0]];
  const auto numbers = grid.numbers_of(grid.shape().index_of(place.cell));
  const std::vector<TilePoint> points = points_at(patch, number_of(patch, numbers));
  const auto axis = static_cast<std::size_t>(place.wall / 2);
  BezierSurface<Rational> out(patch.degrees, 2, false);
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t c = 0; c < 2; ++c)
      out.component(static_cast<int>(c))[i] = points[i][c < axis ? c : c + 1];
  return out;
}

BezierSurface<Interval> SweepStarts::wall(const CapPlace& place) const {
  return boundary(slab(place, Rational(1)), static_cast<std::size_t>(place.wall / 2),
                  place.wall % 2);
}

BezierVolume<Interval> SweepStarts::slab(const CapPlace& place, const Rational& depth) const {
  const BezierPieces<Interval, 3>& pieces = pieces_[micro_.grids[place.grid].volume];
  const auto across = static_cast<std::size_t>(place.wall / 2);
  std::array<std::size_t, 3> piece{};
  std::array<Span, 3> parts;
  for (std::size_t a = 0; a < 3; ++a) {
    parts[a] = span(place, a);
    if (a == across) {
      const Rational width = depth * (parts[a][1] - parts[a][0]);
      if (place.wall % 2 == 0)
        parts[a][1] = parts[a][0] + width;
      else
        parts[a][0] = parts[a][1] - width;
    }
    const std::vector<Rational>& breaks = pieces.breaks[a];
    const auto next = std::upper_bound(breaks.begin() + 1, breaks.end() - 1, parts[a][0]);
    piece[a] = static_cast<std::size_t>(next - breaks.begin()) - 1;
    const Rational begin = *(next - 1), length = *next - begin;
    for (Rational& x : parts[a]) x = (x - begin) / length;
  }
  BezierVolume<Interval> out = pieces.at(piece);
  for (std::size_t a = 0; a < 3; ++a)
    if (parts[a][0].sign() != Sign::kZero || parts[a][1] != Rational(1))
      out = restricted(std::move(out), a, parts[a][0], parts[a][1]);
  return out;
}

}  // namespace veritope
