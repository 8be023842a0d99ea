// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/micro/micro_validity.h"

#include <algorithm>
#include <string>
#include <utility>

namespace veritope {
namespace {

Status over_micro_limit(std::string message) {
  return Error{Code::kOverLimit, {}, std::move(message)};
}

std::string micro_part(const char* what, std::size_t number) {
  return what + (" " + std::to_string(number));
}

std::string micro_axis(std::size_t grid, std::size_t axis) {
  return micro_part("grid", grid) + ": axis " + std::to_string(axis) + ": ";
}

bool has_tile_bits(const Rational& x) {
  constexpr auto kMost = static_cast<std::size_t>(kMaxTileBits);
  return x.numerator().bit_length() <= kMost && x.denominator().bit_length() <= kMost;
}

Status check_tile_list(const TilePatch& patch, std::size_t power, const std::string& where) {
  const std::vector<TilePoint>& points = patch.points[power];
  if (points.size() != patch.num_points())
    return bad_argument(where + "list " + std::to_string(power) + " has " +
                        std::to_string(points.size()) + " points, and the degrees (" +
                        std::to_string(patch.degrees[0]) + ", " + std::to_string(patch.degrees[1]) +
                        ") need " + std::to_string(patch.num_points()));
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t c = 0; c < 3; ++c)
      if (!has_tile_bits(points[i][c]))
        return over_micro_limit(
            where + "coordinate " + std::to_string(c) + " of point " + std::to_string(i) +
            " of list " + std::to_string(power) +
            " has a numerator or denominator of more than 128 bits: " + points[i][c].to_string());
  return ok_status();
}

Status check_tile_patch(const TilePatch& patch, bool may_be_curve, const std::string& where) {
  if (patch.wall && (*patch.wall < 0 || *patch.wall > 5))
    return bad_argument(where + "the wall must be from 0 to 5, not " + std::to_string(*patch.wall));
  for (std::size_t a = 0; a < 2; ++a) {
    const int degree = patch.degrees[a];
    if (degree >= (may_be_curve && a == 1 ? 0 : 1) && degree <= kMaxTileDegree) continue;
    return Error{degree < 1 ? Code::kBadArgument : Code::kOverLimit,
                 {},
                 where + "a degree must be from 1 to 7, not " + std::to_string(degree)};
  }
  if (patch.points.empty()) return bad_argument(where + "it has 0 lists of points");
  if (patch.points.size() > kMaxTilePowers)
    return over_micro_limit(where + "it has " + std::to_string(patch.points.size()) +
                            " lists of points, more than " + std::to_string(kMaxTilePowers));
  if (!patch.wall && patch.points.size() != 1)
    return bad_argument(where + "it names no wall and has " + std::to_string(patch.points.size()) +
                        " lists of points, not 1");
  for (std::size_t k = 0; k < patch.points.size(); ++k)
    if (Status status = check_tile_list(patch, k, where); !status) return status;
  return ok_status();
}

Status check_axis_breaks(const std::vector<Rational>& breaks, const VVolume::Axis& axis,
                         const std::string& where) {
  if (breaks.size() < 2)
    return bad_argument(where + "at least 2 breaks are needed, and there are " +
                        std::to_string(breaks.size()));
  for (std::size_t i = 0; i + 1 < breaks.size(); ++i)
    if (!(breaks[i] < breaks[i + 1]))
      return bad_argument(where + "break " + std::to_string(i + 1) + ", " +
                          breaks[i + 1].to_string() + ", is not above the one before it, " +
                          breaks[i].to_string());
  for (std::size_t i = 0; i < breaks.size(); ++i)
    if (std::max(breaks[i].numerator().bit_length(), breaks[i].denominator().bit_length()) >
        kMaxBreakBits)
      return over_micro_limit(where + "break " + std::to_string(i) + " has more than " +
                              std::to_string(kMaxBreakBits) + " bits");
  for (const Rational* const end : {&breaks.front(), &breaks.back()})
    if (*end < axis.domain_begin() || *end > axis.domain_end())
      return bad_argument(where + "the break " + end->to_string() + " is not in the domain from " +
                          axis.domain_begin().to_string() + " to " + axis.domain_end().to_string());
  auto at = breaks.begin();
  for (const Rational& knot : axis.knots) {
    if (!(breaks.front() < knot && knot < breaks.back())) continue;
    while (*at < knot) ++at;
    if (*at != knot) return bad_argument(where + "the knot " + knot.to_string() + " is no break");
  }
  return ok_status();
}

// The ends of the boxes of the grids [first, last) along an axis, as numbers that are in the order of the ends.
std::vector<std::array<std::size_t, 2>> ranks_of(const Microstructure& micro, std::size_t first,
                                                 std::size_t last, std::size_t axis) {
  std::vector<std::pair<const Rational*, std::size_t>> ends;
  for (std::size_t g = first; g < last; ++g) {
    ends.emplace_back(&micro.grids[g].breaks[axis].front(), 2 * (g - first));
    ends.emplace_back(&micro.grids[g].breaks[axis].back(), 2 * (g - first) + 1);
  }
  std::sort(ends.begin(), ends.end(),
            [](const auto& a, const auto& b) { return *a.first < *b.first; });
  std::vector<std::array<std::size_t, 2>> ranks(last - first);
  std::size_t rank = 0;
  for (std::size_t i = 0; i < ends.size(); ++i) {
    if (i > 0 && *ends[i - 1].first < *ends[i].first) ++rank;
    ranks[ends[i].second / 2][ends[i].second % 2] = rank;
  }
  return ranks;
}

}  // namespace

bool is_sha256_text(std::string_view text) {
  return text.size() == 64 && std::all_of(text.begin(), text.end(), [](char c) {
           return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'f');
         });
}

Status check_cage_volume(const VVolume& volume, std::size_t number) {
  const std::string where = micro_part("volume", number) + " of the cage: ";
  if (volume.dimension() != 3)
    return bad_argument(where + "it has " + std::to_string(volume.dimension()) +
                        " coordinates, not 3");
  for (std::size_t a = 0; a < 3; ++a) {
    const VVolume::Axis& axis = volume.axis(a);
    if (axis.is_periodic || axis.knots.front() != axis.domain_begin() ||
        axis.knots.back() != axis.domain_end())
      return bad_argument(where + "axis " + std::to_string(a) + " is not clamped");
  }
  if (!volume.is_rational()) return ok_status();
  for (const Rational& weight : volume.component(volume.num_components() - 1))
    if (weight.sign() != Sign::kPositive)
      return bad_argument(where + "the weight " + weight.to_string() + " is not positive");
  return ok_status();
}

Status check_tile(const MicroTile& tile, std::size_t number) {
  const std::string where = micro_part("tile", number) + ": ";
  if (tile.patches.empty()) return bad_argument(where + "it has 0 patches");
  if (tile.patches.size() > kMaxTilePatches)
    return over_micro_limit(where + "it has " + std::to_string(tile.patches.size()) +
                            " patches, more than " + std::to_string(kMaxTilePatches));
  if (tile.range) {
    const auto [low, high] = *tile.range;
    if (low < 0 || low > high || high > kMaxWallNumber)
      return bad_argument(where + "the range from " + std::to_string(low) + " to " +
                          std::to_string(high) + " is no range between 0 and " +
                          std::to_string(kMaxWallNumber));
  }
  bool has_wall = false;
  for (std::size_t i = 0; i < tile.patches.size(); ++i) {
    Status status =
        check_tile_patch(tile.patches[i], tile.is_open, where + micro_part("patch", i) + ": ");
    if (!status) return status;
    has_wall = has_wall || tile.patches[i].wall.has_value();
  }
  if (has_wall != tile.range.has_value())
    return bad_argument(where + (has_wall ? "a patch names a wall, and there is no range"
                                          : "it has a range, and no patch names a wall"));
  return ok_status();
}

Status check_breaks(const Microstructure& micro, std::size_t grid, std::uint64_t& cells) {
  const MicroGrid& g = micro.grids[grid];
  const std::string where = micro_part("grid", grid) + ": ";
  if (g.volume >= micro.cage.size())
    return bad_argument(where + "volume " + std::to_string(g.volume) + " is not one of the " +
                        std::to_string(micro.cage.size()) + " volumes of the cage");
  if (grid > 0 && g.volume < micro.grids[grid - 1].volume)
    return bad_argument(where + "its volume, " + std::to_string(g.volume) +
                        ", is below that of the grid before it, " +
                        std::to_string(micro.grids[grid - 1].volume));
  for (std::size_t a = 0; a < 3; ++a) {
    Status status =
        check_axis_breaks(g.breaks[a], micro.cage[g.volume].axis(a), micro_axis(grid, a));
    if (!status) return status;
  }
  const auto more = g.shape().count_up_to(kMaxMicroCells);
  if (!more || *more > kMaxMicroCells - cells)
    return over_micro_limit(where + "the grids have more than " + std::to_string(kMaxMicroCells) +
                            " cells");
  cells += *more;
  return ok_status();
}

std::optional<std::size_t> crowding_grid(const Microstructure& micro) {
  const std::vector<MicroGrid>& grids = micro.grids;
  for (std::size_t g = kMaxGridsOfVolume; g < grids.size(); ++g)
    if (grids[g - kMaxGridsOfVolume].volume == grids[g].volume) return g;
  return std::nullopt;
}

Status crowding_error(const Microstructure& micro, std::size_t grid) {
  return over_micro_limit("volume " + std::to_string(micro.grids[grid].volume) + " has more than " +
                          std::to_string(kMaxGridsOfVolume) + " grids");
}

std::optional<std::array<std::size_t, 2>> overlapping_grids(const Microstructure& micro) {
  const std::vector<MicroGrid>& grids = micro.grids;
  for (std::size_t first = 0, last = 0; first < grids.size(); first = last) {
    while (last < grids.size() && grids[last].volume == grids[first].volume) ++last;
    if (last - first < 2) continue;
    std::array<std::vector<std::array<std::size_t, 2>>, 3> ranks;
    for (std::size_t a = 0; a < 3; ++a) ranks[a] = ranks_of(micro, first, last, a);
    for (std::size_t j = 1; j < last - first; ++j)
      for (std::size_t i = 0; i < j; ++i) {
        const bool is_apart = std::any_of(ranks.begin(), ranks.end(), [i, j](const auto& r) {
          return r[i][1] <= r[j][0] || r[j][1] <= r[i][0];
        });
        if (!is_apart) return std::array{first + i, first + j};
      }
  }
  return std::nullopt;
}

Status overlap_error(const Microstructure& micro, const std::array<std::size_t, 2>& grids) {
  return bad_argument("the boxes of the grids " + std::to_string(grids[0]) + " and " +
                      std::to_string(grids[1]) + " of volume " +
                      std::to_string(micro.grids[grids[0]].volume) +
                      " have inner points in common");
}

Status check_cells(const Microstructure& micro, std::size_t grid) {
  const MicroGrid& g = micro.grids[grid];
  const std::string where = micro_part("grid", grid) + ": ";
  const std::size_t count = g.shape().count();
  if (g.tiles.size() != count)
    return bad_argument(where + "it has " + std::to_string(count) + " cells, and the contents of " +
                        std::to_string(g.tiles.size()) + " are given");
  const auto most = static_cast<std::uint8_t>(micro.tiles.size());
  const auto bad =
      std::find_if(g.tiles.begin(), g.tiles.end(), [most](std::uint8_t t) { return t > most; });
  if (bad == g.tiles.end()) return ok_status();
  return bad_argument(where + "cell " + std::to_string(bad - g.tiles.begin()) + " holds tile " +
                      std::to_string(*bad - 1) + " of " + std::to_string(most));
}

Status check_walls(const Microstructure& micro, std::size_t grid, std::size_t axis) {
  const MicroGrid& g = micro.grids[grid];
  const std::vector<std::int32_t>& walls = g.walls[axis];
  const Grid<3> shape = g.shape(), wall_shape = g.wall_shape(axis);
  const std::size_t count = micro.has_walls() ? wall_shape.count() : 0;
  if (walls.size() != count)
    return bad_argument(micro_axis(grid, axis) + std::to_string(count) +
                        " numbers of walls are needed, and there are " +
                        std::to_string(walls.size()));
  if (walls.empty()) return ok_status();
  const std::size_t stride = shape.stride(axis), n = shape.size[axis];
  for (std::size_t w = 0; w < count; ++w) {
    if (walls[w] == 0) continue;
    if (walls[w] < 0 || walls[w] > kMaxWallNumber)
      return bad_argument(micro_axis(grid, axis) + "the number of wall " + std::to_string(w) +
                          " must be from 0 to " + std::to_string(kMaxWallNumber) + ", not " +
                          std::to_string(walls[w]));
    // The cells on both sides are one stride apart; in each block of cells there is one stride less than of walls.
    const std::size_t block = w / (stride * (n + 1)), inside = w % (stride * (n + 1));
    const std::size_t after = block * stride * n + inside, i = inside / stride;
    const bool has_tile = (i < n && g.tiles[after] != 0) || (i > 0 && g.tiles[after - stride] != 0);
    if (!has_tile)
      return bad_argument(micro_axis(grid, axis) + "wall " + std::to_string(w) +
                          " has the number " + std::to_string(walls[w]) +
                          ", and no neighbour holds a tile");
  }
  return ok_status();
}

Status validate(const Microstructure& micro) {
  if (micro.model && !is_sha256_text(micro.model->sha256))
    return bad_argument("the model's sha256 must be 64 lower-case hexadecimal digits, not " +
                        micro.model->sha256);
  if (micro.cage.empty()) return bad_argument("the cage has 0 volumes");
  if (micro.cage.size() > kMaxMicroGrids)
    return over_micro_limit("the cage has " + std::to_string(micro.cage.size()) +
                            " volumes, more than " + std::to_string(kMaxMicroGrids));
  if (micro.tiles.empty()) return bad_argument("there are 0 tiles");
  if (micro.tiles.size() > kMaxMicroTiles)
    return over_micro_limit("there are " + std::to_string(micro.tiles.size()) +
                            " tiles, more than " + std::to_string(kMaxMicroTiles));
  if (micro.grids.size() > kMaxMicroGrids)
    return over_micro_limit("there are " + std::to_string(micro.grids.size()) +
                            " grids, more than " + std::to_string(kMaxMicroGrids));
  for (std::size_t v = 0; v < micro.cage.size(); ++v)
    if (Status status = check_cage_volume(micro.cage[v], v); !status) return status;
  for (std::size_t k = 0; k < micro.tiles.size(); ++k) {
    if (micro.tiles[k].is_open)
      return bad_argument(micro_part("tile", k) +
                          ": it consists of curves and sheets, and no file of microstructures "
                          "holds them");
    if (Status status = check_tile(micro.tiles[k], k); !status) return status;
  }
  std::uint64_t cells = 0;
  for (std::size_t g = 0; g < micro.grids.size(); ++g)
    if (Status status = check_breaks(micro, g, cells); !status) return status;
  if (const auto grid = crowding_grid(micro)) return crowding_error(micro, *grid);
  if (const auto grids = overlapping_grids(micro)) return overlap_error(micro, *grids);
  for (std::size_t g = 0; g < micro.grids.size(); ++g) {
    if (Status status = check_cells(micro, g); !status) return status;
    for (std::size_t a = 0; a < 3; ++a)
      if (Status status = check_walls(micro, g, a); !status) return status;
  }
  for (std::size_t b = 0; b < micro.bridges.size(); ++b)
    if (Status status = check_bridge(micro, b); !status) return status;
  for (std::size_t s = 0; s < micro.sweeps.size(); ++s)
    if (Status status = check_sweep(micro, s); !status) return status;
  for (std::size_t m = 0; m < micro.materials.size(); ++m)
    if (Status status = check_material(micro, m); !status) return status;
  return ok_status();
}

}  // namespace veritope
