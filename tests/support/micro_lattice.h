// SPDX-License-Identifier: LGPL-3.0-or-later
// tests/support/micro_lattice.h: jacks in a block, and the bridges and sweeps that lead from them to its surface.
#pragma once
#include <algorithm>
#include <array>
#include <cstdint>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "solids/micro/bridge/build_bridges.h"
#include "solids/micro/bridge/build_sweeps.h"
#include "solids/micro/bridge/sweep_proof.h"
#include "solids/micro/bridge_front.h"
#include "solids/polyhedron/triangle_mesh.h"
#include "splines/de_boor.h"
#include "tests/support/micro_cells.h"

namespace veritope::micro_lattice {

inline TriangleMesh block(double lo, double hi) {
  TriangleMesh out;
  for (int i = 0; i < 8; ++i)
    out.positions.push_back(
        {(i & 1) != 0 ? hi : lo, (i & 2) != 0 ? hi : lo, (i & 4) != 0 ? hi : lo});
  out.faces = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
               {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  return out;
}

// A cube around the block, of the degree (2, 2, 2), sheared and bent a bit if `bend` is not 0, with knots along u if it
// `has_knots`.
inline VVolume cage_volume(int bend, bool has_knots) {
  VVolume out = v_cells::polynomial({2, 2, 2}, [&](std::size_t i, std::size_t j, std::size_t k) {
    const auto x = static_cast<std::int64_t>(i), y = static_cast<std::int64_t>(j),
               z = static_cast<std::int64_t>(k);
    const Rational off = Rational(bend * (y == 1 ? 1 : 0)) / Rational(8);
    return v_cells::Point{Rational(x) / Rational(2) + off, Rational(y) / Rational(2),
                          Rational(z) / Rational(2) + off};
  });
  return has_knots ? insert_knot(out, 0, Rational(1) / Rational(3)) : out;
}

// The tiles whose cells have all their corners deep inside of a block: enough to be kept.
struct Lattice {
  TriangleMesh solid;
  Microstructure micro;
  VModel cage;
  std::vector<AnalysedTile> tiles;

  Lattice(std::uint64_t n, const VVolume& volume, const Rational& lo, const Rational& hi,
          int degree = 3)
      : solid(block(nearest_double(lo), nearest_double(hi))),
        micro(micro_cells::full({volume}, {n, n, n}, jack_of(degree))),
        cage(make_v_model(micro.cage, VOrientation::kAuto).value()) {
    tiles.push_back(std::get<AnalysedTile>(analyse_tile(micro.tiles[0])));
    MicroGrid& grid = micro.grids[0];
    const Grid<3> shape = grid.shape();
    for (std::size_t c = 0; c < shape.count(); ++c)
      for (unsigned corner = 0; corner < 8; ++corner) {
        std::array<Rational, 3> at;
        for (std::size_t a = 0; a < 3; ++a)
          at[a] = grid.breaks[a][shape.index_of(c)[a] + (corner >> a & 1)];
        const std::vector<Rational> image = point(volume, at).value();
        for (const Rational& x : image)
          if (x <= lo || hi <= x) grid.tiles[c] = 0;
      }
  }
  static MicroTile jack_of(int degree) {
    JackShape shape;
    shape.degree = degree;
    return jack_tile(shape).value();
  }
  BridgeReport build(double skin = 0.02, unsigned jobs = 1) {
    BridgeOptions options;
    options.skin = skin;
    options.jobs = jobs;
    return build_bridges(solid, cage, tiles, options, micro).value();
  }
  BridgeReport sweep(double skin = 0.02, unsigned jobs = 1) {
    BridgeOptions options;
    options.skin = skin;
    options.jobs = jobs;
    return build_sweeps(solid, cage, tiles, options, micro).value();
  }
  // The condition of the first sweep that is not proved, and its number; or nothing.
  std::string defect_of_sweeps() const {
    const auto proof = prove_sweeps(micro, cage, tiles, 1).value();
    const auto* const defect = std::get_if<BridgeDefect>(&proof);
    return defect == nullptr
               ? ""
               : std::string(defect->condition) + " of " + std::to_string(defect->bridge);
  }
};

// Two spans of degree 1: beyond u = 1/2, the line along u rises with the slope 1/2: 26.565 degrees. The first `kept`
// of ten cells along u may have tiles, and the solid ends at x = `end`.
inline Lattice creased(std::size_t kept, double end) {
  VVolume bent = v_cells::polynomial({1, 1, 1}, [&](std::size_t i, std::size_t j, std::size_t k) {
    return v_cells::Point{Rational(i), Rational(j), Rational(k)};
  });
  bent = insert_knot(bent, 0, Rational(1) / Rational(2));
  for (std::size_t j = 0; j < 2; ++j)
    for (std::size_t k = 0; k < 2; ++k)
      bent.component(2)[bent.grid().at({2, j, k})] += Rational(1) / Rational(4);
  Lattice out(10, bent, Rational(1) / Rational(10), Rational(9) / Rational(10));
  MicroGrid& grid = out.micro.grids[0];
  for (std::size_t c = 0; c < grid.tiles.size(); ++c)
    if (grid.shape().index_of(c)[0] >= kept) grid.tiles[c] = 0;
  for (Vec3d& p : out.solid.positions) p.x = std::min(p.x, end);
  return out;
}

// Adds a bridge at a wall, straight on along the axis by `length` in parameters, moved by `aside` at its end.
inline MicroBridge& add_bridge(Microstructure& micro, const VModel& cage,
                               const std::vector<AnalysedTile>& tiles, const CapPlace& place,
                               const Rational& length, const TilePoint& aside = {}) {
  const BridgeFront front = front_of(micro, cage, place).value();
  const auto cap = turned_beyond(cap_on_front(micro, cage, tiles, place, front).value(), front);
  MicroBridge out;
  out.cap = place;
  out.volume = front.volume;
  out.degrees = cap.degrees();
  for (std::size_t i = 0; i < cap.grid().count(); ++i)
    for (int k = 0; k <= 2; ++k) {
      TilePoint p;
      for (std::size_t c = 0; c < 3; ++c) {
        p[c] = cap.component(static_cast<int>(c))[i];
        if (k == 2) p[c] += aside[c];
      }
      const Rational step = length * Rational(k) / Rational(2);
      p[front.axis] += front.is_upward ? step : -step;
      out.points.push_back(p);
    }
  const auto at =
      std::upper_bound(micro.bridges.begin(), micro.bridges.end(), out,
                       [](const MicroBridge& a, const MicroBridge& b) { return a.cap < b.cap; });
  return *micro.bridges.insert(at, std::move(out));
}

}  // namespace veritope::micro_lattice
