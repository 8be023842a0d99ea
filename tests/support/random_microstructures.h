// SPDX-License-Identifier: LGPL-3.0-or-later
// tests/support/random_microstructures.h: random microstructures in the cages of random_v_models.h.
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "predicates/vec.h"
#include "splines/de_boor.h"
#include "splines/de_casteljau.h"
#include "tests/support/micro_cells.h"
#include "tests/support/random_v_models.h"

namespace veritope::random_micro {

struct Structure {
  Microstructure micro;
  std::string description;
};

/// A square cap of half-width `cap` in wall 4, four triangles and an apex in the cube's middle.
inline MicroTile spike_tile(const Rational& cap) {
  const Rational half = Rational(1) / Rational(2);
  const auto corner = [&](int i, int j) {
    return TilePoint{half + cap * Rational(i), half + cap * Rational(j), Rational(0)};
  };
  const TilePoint apex = {half, half, Rational(3) / Rational(4)};
  const std::array<TilePoint, 4> ring = {corner(-1, -1), corner(1, -1), corner(1, 1),
                                         corner(-1, 1)};
  MicroTile out;
  out.name = "spike";
  out.patches.push_back(micro_cells::square(ring[0], ring[3], ring[2], ring[1]));
  for (std::size_t i = 0; i < 4; ++i)
    out.patches.push_back(micro_cells::square(ring[i], ring[(i + 1) % 4], apex, apex));
  return out;
}

class Maker {
 public:
  explicit Maker(Random& random) : random_(random) {}

  /// Jacks with some of their arms, and spikes; graded or not; in a cage whose volumes lie in any direction, have
  /// either hand and any description. Each volume has one grid, or two that abut.
  Structure make() {
    choose_cage();
    choose_tiles();
    const VModel cage = make_v_model(out_.micro.cage, VOrientation::kAuto).value();
    for (std::uint32_t v = 0; v < out_.micro.cage.size(); ++v) add_grids(v, cage);
    for (const auto& [arms, number] : jacks_) {
      JackShape shape = shape_;
      shape.arms = arms;
      out_.micro.tiles[number] = jack_tile(shape).value();
    }
    return std::move(out_);
  }

 private:
  void choose_cage() {
    random_v_models::Model model;
    switch (random_.below(5)) {
      case 0: model = random_v_models::grid(random_); break;
      case 1: model = random_v_models::polycube(random_); break;
      case 2: model = random_v_models::ring(random_); break;
      case 3: model = random_v_models::helix(random_); break;
      default: model = random_v_models::primitive(random_); break;
    }
    out_.description = model.description;
    if (random_.below(3) == 0)
      model.cells =
          random_v_models::affine_image(model.cells, random_v_models::random_affine_map(random_));
    std::set<Rational> places;
    for (VVolume& cell : model.cells) {
      cell = v_cells::turned(std::move(cell), static_cast<unsigned>(random_.below(48)));
      for (std::size_t a = 0; a < 3; ++a) {
        if (random_.below(6) == 0) cell = elevate(cell, a, 1);
        if (random_.below(4) == 0)
          cell = with_domain(cell, a, Rational(random_.between(-5, 5)) / Rational(3),
                             Rational(random_.between(2, 9)))
                     .value();
        const auto& axis = cell.axis(a);
        for (const Rational& knot : axis.knots) {
          const Rational at =
              (knot - axis.domain_begin()) / (axis.domain_end() - axis.domain_begin());
          places.insert(at);
          places.insert(Rational(1) - at);
        }
      }
      if (random_.below(4) == 0) cell = v_cells::with_factor(cell, Rational(3) / Rational(7));
    }
    // One list of breaks for all axes, symmetric: all walls that meet are equal.
    const auto parts = random_.between(1, places.size() > 2 || model.cells.size() > 4 ? 2 : 3);
    for (std::int64_t i = 1; i < parts; ++i) places.insert(Rational(i) / Rational(parts));
    places_.assign(places.begin(), places.end());
    out_.micro.cage = std::move(model.cells);
  }
  void choose_tiles() {
    shape_.degree = random_.below(2) == 0 ? 1 : 3;
    shape_.node = Rational(random_.between(10, 14)) / Rational(64);
    shape_.cap = Rational(random_.between(6, 12)) / Rational(64);
    const std::int32_t unit = kMaxWallNumber / 64;
    is_graded_ = random_.below(2) == 0;
    if (is_graded_) shape_.range = {{6 * unit, 12 * unit}};
    keep_ = random_.below(2) == 0 ? 100 : 70;
    all_arms_ = random_.below(2) == 0 ? 100 : 80;
    if (!is_graded_ && random_.below(2) == 0) {
      has_spikes_ = true;
      out_.micro.tiles.push_back(spike_tile(shape_.cap));
    }
    out_.description += ", jacks of degree " + std::to_string(shape_.degree) +
                        (is_graded_ ? ", graded" : "") + (has_spikes_ ? ", spikes" : "");
  }

  void add_grids(std::uint32_t v, const VModel& cage) {
    const std::size_t count = places_.size() - 1;
    if (count > 1 && random_.below(3) == 0) {
      const std::size_t axis = random_.below(3), at = 1 + random_.below(count - 1);
      add_grid(v, cage, axis, 0, at);
      add_grid(v, cage, axis, at, count);
      return;
    }
    add_grid(v, cage, 0, 0, count);
  }
  void add_grid(std::uint32_t v, const VModel& cage, std::size_t axis, std::size_t begin,
                std::size_t end) {
    MicroGrid grid;
    grid.volume = v;
    const VVolume& volume = out_.micro.cage[v];
    for (std::size_t a = 0; a < 3; ++a) {
      const auto& knots = volume.axis(a);
      for (std::size_t i = a == axis ? begin : 0; i <= (a == axis ? end : places_.size() - 1); ++i)
        grid.breaks[a].push_back(knots.domain_begin() +
                                 places_[i] * (knots.domain_end() - knots.domain_begin()));
    }
    const Grid<3> shape = grid.shape();
    for (std::size_t n = 0; n < shape.count(); ++n) {
      const auto at = shape.index_of(n);
      unsigned arms = 63;
      for (unsigned w = 0; w < 6; ++w) {
        const std::size_t a = w / 2;
        const bool is_outer =
            w % 2 == 0 ? at[a] == 0 && grid.breaks[a].front() == volume.axis(a).domain_begin()
                       : at[a] + 1 == shape.size[a] &&
                             grid.breaks[a].back() == volume.axis(a).domain_end();
        if (is_outer && cage.face(v, w).is_collapsed()) arms &= ~(1u << w);
      }
      grid.tiles.push_back(tile_for(arms));
    }
    if (is_graded_)
      for (std::size_t a = 0; a < 3; ++a) {
        const Grid<3> walls = grid.wall_shape(a);
        for (std::size_t n = 0; n < walls.count(); ++n)
          grid.walls[a].push_back(number_at(volume, grid, a, walls.index_of(n)));
      }
    out_.micro.grids.push_back(std::move(grid));
  }
  std::uint8_t tile_for(unsigned arms) {
    if (random_.below(100) >= keep_) return 0;
    if (has_spikes_ && (arms & 16) != 0 && random_.below(8) == 0) return 1;
    if (random_.below(100) >= all_arms_) arms &= static_cast<unsigned>(random_.below(64));
    if (arms == 0) return 0;
    const auto known = jacks_.find(arms);
    if (known != jacks_.end()) return static_cast<std::uint8_t>(known->second + 1);
    if (out_.micro.tiles.size() == kMaxMicroTiles) return 0;
    jacks_[arms] = out_.micro.tiles.size();
    out_.micro.tiles.emplace_back();
    return static_cast<std::uint8_t>(out_.micro.tiles.size());
  }
  // Equal for walls with one middle in space.
  std::int32_t number_at(const VVolume& volume, const MicroGrid& grid, std::size_t axis,
                         const std::array<std::size_t, 3>& wall) {
    std::array<Rational, 3> at;
    for (std::size_t a = 0; a < 3; ++a)
      at[a] = a == axis ? grid.breaks[a][wall[a]]
                        : (grid.breaks[a][wall[a]] + grid.breaks[a][wall[a] + 1]) / Rational(2);
    std::vector<Rational> image = evaluate(volume, at).value();
    std::string text;
    for (std::size_t c = 0; c < 3; ++c) {
      if (volume.is_rational()) image[c] /= image[3];
      text += image[c].to_string() + " ";
    }
    const auto [found, is_new] = numbers_.try_emplace(std::move(text));
    if (is_new)
      found->second =
          static_cast<std::int32_t>(random_.between((*shape_.range)[0], (*shape_.range)[1]));
    return found->second;
  }

  Random& random_;
  Structure out_;
  std::vector<Rational> places_;  // of the breaks, from 0 to 1
  JackShape shape_;
  bool is_graded_ = false, has_spikes_ = false;
  std::uint64_t keep_ = 100, all_arms_ = 100;
  std::map<unsigned, std::size_t> jacks_;
  std::map<std::string, std::int32_t> numbers_;
};

inline Structure any_structure(Random& random) { return Maker(random).make(); }

/// The point of the microstructure that a patch of a cell has at (u, v).
inline std::array<Rational, 3> exact_point(const Microstructure& micro, const MicroGrid& grid,
                                           std::size_t cell, const TilePatch& patch,
                                           const Rational& u, const Rational& v) {
  const auto at = grid.shape().index_of(cell);
  const auto net = points_at(patch, number_of(patch, grid.numbers_of(at)));
  BezierSurface<Rational> surface(patch.degrees, 3, false);
  for (std::size_t i = 0; i < net.size(); ++i)
    for (std::size_t c = 0; c < 3; ++c) surface.component(static_cast<int>(c))[i] = net[i][c];
  const auto local = evaluate<Rational, 2>(surface, {u, v});
  std::array<Rational, 3> parameters;
  for (std::size_t a = 0; a < 3; ++a) {
    const Rational &low = grid.breaks[a][at[a]], &high = grid.breaks[a][at[a] + 1];
    parameters[a] = low + local[a] * (high - low);
  }
  const VVolume& volume = micro.cage[grid.volume];
  const auto image = evaluate(volume, parameters).value();
  std::array<Rational, 3> out;
  for (std::size_t c = 0; c < 3; ++c)
    out[c] = volume.is_rational() ? image[c] / image[3] : image[c];
  return out;
}
inline Vec3d nearest_point(const std::array<Rational, 3>& p) {
  return {nearest_double(p[0]), nearest_double(p[1]), nearest_double(p[2])};
}

/// The longest side of the box around the control points.
inline double size_of(const Microstructure& micro) {
  double most = 0;
  for (int c = 0; c < 3; ++c) {
    double low = 1e300, high = -1e300;
    for (const VVolume& volume : micro.cage)
      for (std::size_t n = 0; n < volume.grid().count(); ++n) {
        const Rational w = volume.is_rational() ? volume.component(3)[n] : Rational(1);
        const double x = nearest_double(volume.component(c)[n] / w);
        low = std::min(low, x), high = std::max(high, x);
      }
    most = std::max(most, high - low);
  }
  return most;
}

/// The least distance between the middles of opposite walls, over cells that hold tiles, at most 100 of them.
inline double width_of(const Microstructure& micro) {
  double least = 1e300;
  std::size_t count = 0;
  for (const MicroGrid& grid : micro.grids) count += grid.tiles.size();
  const std::size_t step = 1 + count / 100;
  for (const MicroGrid& grid : micro.grids)
    for (std::size_t cell = 0; cell < grid.tiles.size(); cell += step) {
      if (grid.tiles[cell] == 0) continue;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        std::array<Vec3d, 2> ends;
        for (std::size_t end = 0; end < 2; ++end) {
          TilePoint middle;
          middle.fill(Rational(1) / Rational(2));
          middle[axis] = Rational(static_cast<std::int64_t>(end));
          ends[end] = nearest_point(exact_point(micro, grid, cell,
                                                micro_cells::square(middle, middle, middle, middle),
                                                Rational(0), Rational(0)));
        }
        least = std::min(
            least, std::hypot(ends[1].x - ends[0].x, ends[1].y - ends[0].y, ends[1].z - ends[0].z));
      }
    }
  return least;
}

}  // namespace veritope::random_micro
