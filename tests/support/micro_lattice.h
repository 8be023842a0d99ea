// SPDX-License-Identifier: LGPL-3.0-or-later
// tests/support/micro_lattice.h: jacks in a cage around a block, those whose cells lie in the block.
#pragma once
#include <string>
#include <variant>

#include "solids/micro/bridge/build_bridges.h"
#include "solids/micro/bridge/build_sweeps.h"
#include "solids/micro/bridge/sweep_proof.h"
#include "splines/de_boor.h"
#include "splines/knot_insertion.h"
#include "tests/support/micro_cells.h"

namespace veritope::micro_lattice {

inline Rational tenths(int n) { return Rational(n) / Rational(10); }

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

  Lattice(std::uint64_t n, const VVolume& volume, const Rational& lo, const Rational& hi)
      : solid(block(nearest_double(lo), nearest_double(hi))),
        micro(micro_cells::full({volume}, {n, n, n}, jack_tile({}).value())),
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
  // The condition of the first sweep that is not proved, and why; or nothing.
  std::string defect_of_sweeps() const {
    const auto proof = prove_sweeps(micro, cage, tiles, 1).value();
    const auto* const defect = std::get_if<BridgeDefect>(&proof);
    return defect == nullptr
               ? ""
               : std::string(defect->condition) + " of " + std::to_string(defect->bridge);
  }
};

}  // namespace veritope::micro_lattice
