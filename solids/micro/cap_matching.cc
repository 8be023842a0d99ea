// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/micro/cap_matching.h"

#include <algorithm>

#include "solids/micro/power_form_internal.h"

namespace veritope {
namespace {

using Flat = std::array<Rational, 2>;            // a point of the wall
using FlatNet = std::vector<std::vector<Flat>>;  // by powers of t; the second parameter fastest

// A patch in a wall, in the parameters of a face.
struct FlatPatch {
  std::array<int, 2> degrees;
  FlatNet net;
};
struct FlatBox {
  Flat lo, hi;
};
// A cap in the parameters of a face: the keys of its patches, sorted, and a box around it.
struct FlatCap {
  std::vector<std::string> keys;
  FlatBox box;
};

FlatPatch placed_patch(const TilePatch& patch, int wall, const WallPlacement* placement,
                       std::optional<std::int32_t> number) {
  const auto axes = v_face_axes(static_cast<std::size_t>(wall / 2));
  FlatPatch out{patch.degrees, {}};
  const std::vector<std::vector<TilePoint>> lists =
      number.has_value() ? std::vector<std::vector<TilePoint>>{points_at(patch, *number)}
                         : patch.points;
  for (std::size_t power = 0; power < lists.size(); ++power) {
    auto& to = out.net.emplace_back();
    for (const TilePoint& p : lists[power]) {
      Flat q = {p[axes[0]], p[axes[1]]};
      if (placement != nullptr) {
        if (placement->is_swapped) std::swap(q[0], q[1]);
        for (std::size_t k = 0; k < 2; ++k) {
          q[k] *= placement->scale[k];
          if (power == 0) q[k] += placement->offset[k];
        }
      }
      to.push_back(std::move(q));
    }
  }
  return out;
}

// The net with its parameters exchanged, then reversed.
FlatPatch turned_patch(const FlatPatch& patch, unsigned symmetry) {
  FlatPatch out = patch;
  if ((symmetry & 1) != 0) std::swap(out.degrees[0], out.degrees[1]);
  const auto m = static_cast<std::size_t>(out.degrees[0]),
             n = static_cast<std::size_t>(out.degrees[1]);
  const auto columns = static_cast<std::size_t>(patch.degrees[1]) + 1;
  for (std::size_t power = 0; power < out.net.size(); ++power)
    for (std::size_t i = 0; i <= m; ++i)
      for (std::size_t j = 0; j <= n; ++j) {
        std::size_t a = (symmetry & 2) != 0 ? m - i : i, b = (symmetry & 4) != 0 ? n - j : j;
        if ((symmetry & 1) != 0) std::swap(a, b);
        out.net[power][i * (n + 1) + j] = patch.net[power][a * columns + b];
      }
  return out;
}

// Replaces a line of Bernstein coefficients by those of 1, x, x^2, ...
void to_powers(std::vector<Rational>& values, std::size_t begin, std::size_t step, int degree) {
  std::vector<Rational> line;
  for (int i = 0; i <= degree; ++i)
    line.push_back(values[begin + static_cast<std::size_t>(i) * step]);
  line = internal::powers_of(line);
  for (std::size_t i = 0; i < line.size(); ++i) values[begin + i * step] = std::move(line[i]);
}

// The polynomial map as a text that does not depend on the degrees in which it is given.
std::string text_of(const FlatPatch& patch) {
  std::string text;
  const auto rows = static_cast<std::size_t>(patch.degrees[0]) + 1,
             columns = static_cast<std::size_t>(patch.degrees[1]) + 1;
  for (std::size_t power = 0; power < patch.net.size(); ++power)
    for (std::size_t k = 0; k < 2; ++k) {
      std::vector<Rational> values;
      for (const Flat& q : patch.net[power]) values.push_back(q[k]);
      for (std::size_t i = 0; i < rows; ++i) to_powers(values, i * columns, 1, patch.degrees[1]);
      for (std::size_t j = 0; j < columns; ++j) to_powers(values, j, columns, patch.degrees[0]);
      for (std::size_t i = 0; i < rows; ++i)
        for (std::size_t j = 0; j < columns; ++j)
          if (const Rational& x = values[i * columns + j]; x.sign() != Sign::kZero)
            text += std::to_string(power) + "xy"[k] + std::to_string(i) + "," + std::to_string(j) +
                    "=" + x.to_string() + ";";
    }
  return text;
}
// Equal iff one of the eight symmetries of the square makes the maps equal.
std::string key_of(const FlatPatch& patch) {
  std::string least = text_of(patch);
  for (unsigned s = 1; s < 8; ++s) least = std::min(least, text_of(turned_patch(patch, s)));
  return least;
}

// The key is equal for a side and the same side passed backwards.
RimSide rim_side(const FlatPatch& patch, std::size_t side) {
  const int degree = tile_side_degree(patch.degrees, side);
  std::array<FlatPatch, 2> curves;
  for (FlatPatch& c : curves) c = {{degree, 0}, {{}}};
  for (int i = 0; i <= degree; ++i) {
    const auto at = [&](int k) {
      return patch.net[0][tile_side_index(patch.degrees, side, static_cast<std::size_t>(k))];
    };
    curves[0].net[0].push_back(at(i));
    curves[1].net[0].push_back(at(degree - i));
  }
  std::string forward = text_of(curves[0]), backward = text_of(curves[1]);
  RimSide out;
  out.is_backwards = backward < forward;
  out.key = std::move(out.is_backwards ? backward : forward);
  return out;
}

void cover_point(const Flat& q, bool is_first, FlatBox& box) {
  for (std::size_t k = 0; k < 2; ++k) {
    if (is_first || q[k] < box.lo[k]) box.lo[k] = q[k];
    if (is_first || q[k] > box.hi[k]) box.hi[k] = q[k];
  }
}
bool are_apart(const FlatBox& a, const FlatBox& b) {
  for (std::size_t k = 0; k < 2; ++k)
    if (a.hi[k] < b.lo[k] || b.hi[k] < a.lo[k]) return true;
  return false;
}

// Null numbers: for all numbers of the wall, in the whole range of the tile.
FlatCap flat_cap(const AnalysedTile& tile, std::uint32_t cap, const WallPlacement* placement,
                 const WallNumbers* numbers) {
  FlatCap out;
  bool is_first = true;
  const int wall = tile.caps[cap].wall;
  for (const std::uint32_t p : tile.caps[cap].patches) {
    const TilePatch& patch = tile.tile.patches[p];
    std::optional<std::int32_t> number;
    if (numbers != nullptr) number = number_of(patch, *numbers);
    const FlatPatch flat = placed_patch(patch, wall, placement, number);
    out.keys.push_back(key_of(flat));
    if (numbers != nullptr) {
      for (const Flat& q : flat.net[0]) cover_point(q, is_first, out.box), is_first = false;
      continue;
    }
    const BezierVolume<Rational> family = family_of(patch, tile.tile.range);
    const auto axes = v_face_axes(static_cast<std::size_t>(wall / 2));
    const auto x = family.component(static_cast<int>(axes[0])),
               y = family.component(static_cast<int>(axes[1]));
    for (std::size_t i = 0; i < x.size(); ++i)
      cover_point({x[i], y[i]}, is_first, out.box), is_first = false;
  }
  std::sort(out.keys.begin(), out.keys.end());
  return out;
}

// Whether the caps in a wall depend on no number but that of the wall.
bool depend_on_own_number(const AnalysedTile& tile, int wall) {
  for (const std::uint32_t cap : tile.caps_of_wall[static_cast<std::size_t>(wall)])
    for (const std::uint32_t p : tile.caps[cap].patches)
      if (tile.tile.patches[p].wall.value_or(wall) != wall) return false;
  return true;
}

CapMatch match_of(const std::array<const AnalysedTile*, 2>& tiles, const std::array<int, 2>& walls,
                  const std::array<WallPlacement, 2>* placements,
                  const std::array<WallNumbers, 2>* numbers) {
  std::array<std::vector<FlatCap>, 2> flat;
  std::array<const std::vector<std::uint32_t>*, 2> caps;
  for (std::size_t side = 0; side < 2; ++side) {
    caps[side] = &tiles[side]->caps_of_wall[static_cast<std::size_t>(walls[side])];
    for (const std::uint32_t cap : *caps[side])
      flat[side].push_back(flat_cap(*tiles[side], cap,
                                    placements != nullptr ? &(*placements)[side] : nullptr,
                                    numbers != nullptr ? &(*numbers)[side] : nullptr));
  }
  CapMatch out;
  for (std::size_t i = 0; i < flat[0].size(); ++i)
    for (std::size_t j = 0; j < flat[1].size(); ++j) {
      const std::array<std::uint32_t, 2> pair = {(*caps[0])[i], (*caps[1])[j]};
      if (flat[0][i].keys == flat[1][j].keys)
        out.equal.push_back(pair);
      else if (!are_apart(flat[0][i].box, flat[1][j].box) && !out.clash.has_value())
        out.clash = pair;
    }
  return out;
}

}  // namespace

std::vector<RimSide> rim_of(const AnalysedTile& tile, std::uint32_t cap, const WallPair& pair,
                            std::size_t side, const WallNumbers& numbers) {
  std::vector<RimSide> out;
  const WallPlacement* const placement =
      pair.placements != nullptr ? &(*pair.placements)[side] : nullptr;
  for (const std::uint32_t p : tile.caps[cap].patches) {
    const TilePatch& patch = tile.tile.patches[p];
    const FlatPatch flat =
        placed_patch(patch, tile.caps[cap].wall, placement, number_of(patch, numbers));
    for (std::size_t s = 0; s < kTileSides; ++s) {
      if (tile.surface.is_collapsed(p, s)) continue;
      const auto outer =
          static_cast<std::uint32_t>(tile.surface.mates[kTileSides * p + s] / kTileSides);
      if (tile.cap_of_patch[outer] == cap) continue;
      RimSide& r = out.emplace_back(rim_side(flat, s));
      r.outer_patch = outer;
      r.side = static_cast<std::uint32_t>(kTileSides * p + s);
    }
  }
  return out;
}

CapMatcher::CapMatcher(const std::vector<AnalysedTile>& tiles) : tiles_(tiles) {}

CapMatch CapMatcher::match(const WallPair& pair, const std::array<std::uint32_t, 2>& tiles,
                           const std::array<WallNumbers, 2>& numbers) {
  return match_of({&tiles_[tiles[0]], &tiles_[tiles[1]]}, {pair.walls[0].wall, pair.walls[1].wall},
                  pair.placements, &numbers);
}

const CapMatch* CapMatcher::match_for_all(const WallPair& pair,
                                          const std::array<std::uint32_t, 2>& tiles) {
  const auto [at, is_new] = for_all_.try_emplace({tiles[0], tiles[1], pair.walls[0].wall});
  if (is_new) {
    const std::array<int, 2> walls = {pair.walls[0].wall, pair.walls[1].wall};
    const AnalysedTile &a = tiles_[tiles[0]], &b = tiles_[tiles[1]];
    if (depend_on_own_number(a, walls[0]) && depend_on_own_number(b, walls[1])) {
      CapMatch all = match_of({&a, &b}, walls, nullptr, nullptr);
      if (!all.clash.has_value()) at->second = std::move(all);
    }
  }
  return at->second.has_value() ? &*at->second : nullptr;
}

}  // namespace veritope
