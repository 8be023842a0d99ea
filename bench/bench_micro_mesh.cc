// SPDX-License-Identifier: LGPL-3.0-or-later
// bench/bench_micro_mesh.cc: --cells N --chord H. Meshes of jacks with arms of different widths in N^3 cells, in a
// straight trilinear and a bent tricubic cage, on one thread, and what the decision of their validity takes.
#include <cmath>
#include <cstdio>
#include <string>
#include <utility>

#include "bench/arguments.h"
#include "bench/stopwatch.h"
#include "robust/base/check.h"
#include "solids/micro/jack.h"
#include "solids/micro/mesh/micro_mesh.h"
#include "solids/micro/micro_grid.h"
#include "solids/micro/micro_topology.h"
#include "solids/polyhedron/validity.h"
#include "tests/support/v_cells.h"

namespace {

using namespace veritope;

VVolume straight_cage() { return v_cells::cube(0, 0, 0); }
// The cube with control points moved by less than a tenth of their distance.
VVolume bent_cage() {
  return v_cells::polynomial({3, 3, 3}, [](std::size_t i, std::size_t j, std::size_t k) {
    const auto at = [](std::size_t n, std::size_t a, std::size_t b) {
      return Rational(10 * static_cast<std::int64_t>(n) +
                      static_cast<std::int64_t>((2 * a + 3 * b) % 3) - 1) /
             Rational(30);
    };
    return v_cells::Point{at(i, j, k), at(j, k, i), at(k, i, j)};
  });
}

Microstructure jacks(VVolume cage, std::uint64_t n, int degree) {
  Microstructure out;
  MicroGrid grid = make_micro_grid(cage, 0, {n, n, n}).value();
  for (std::uint8_t& t : grid.tiles) t = 1;
  JackShape shape;
  shape.degree = degree;
  shape.range = {{kMaxWallNumber / 12, kMaxWallNumber / 6}};
  out.tiles.push_back(jack_tile(shape).value());
  for (std::size_t a = 0; a < 3; ++a) {
    const Grid<3> walls = grid.wall_shape(a);
    for (std::size_t w = 0; w < walls.count(); ++w) {
      const auto at = walls.index_of(w);
      const double wave = std::sin(0.3 * static_cast<double>(at[0] + 2 * at[1]) +
                                   0.17 * static_cast<double>(at[2] + a));
      grid.walls[a].push_back(static_cast<std::int32_t>(kMaxWallNumber * (0.125 + 0.04 * wave)));
    }
  }
  out.grids.push_back(std::move(grid));
  out.cage.push_back(std::move(cage));
  return out;
}

void measure(const std::string& name, const Microstructure& micro, double chord) {
  const VModel cage = make_v_model(micro.cage, VOrientation::kAuto).value();
  const std::vector<AnalysedTile> tiles = {
      std::get<AnalysedTile>(analyse_tile(micro.tiles.front()))};
  MicroMeshOptions options;
  options.chord = chord;
  bench::Stopwatch watch;
  const auto mesh = mesh_of(micro, cage, tiles, options);
  const double seconds = watch.ns() * 1e-9;
  VT_CHECK(mesh.has_value(), "the structure has a mesh");
  const auto facets = static_cast<double>(mesh->mesh.faces.size());
  std::printf(
      "{\"row\":\"%s\",\"ours\":%.6g,\"peer\":null,\"unit\":\"s\",\"facets\":%.0f,"
      "\"facets_per_second\":%.4g,\"distance\":%.3g}\n",
      name.c_str(), seconds, facets, facets / seconds, mesh->distance);
  std::fflush(stdout);
  watch = bench::Stopwatch();
  const ValidityReport report = decide_validity(mesh->mesh, {});
  const auto counts = std::get<MicroCounts>(topology_of(micro, cage, tiles));
  VT_CHECK(report.is_valid && report.counts.genus == counts.genus,
           "the mesh is valid and has the structure's genus");
  std::printf("{\"row\":\"%s_validity\",\"ours\":%.6g,\"peer\":null,\"unit\":\"s\"}\n",
              name.c_str(), watch.ns() * 1e-9);
  std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
  std::uint64_t cells = 46;
  double chord = 1e-4;
  bench::read_arguments(argc, argv, {{"--cells", &cells}, {"--chord", &chord}});
  const std::string size = "_" + std::to_string(cells * cells * cells);
  measure("mesh_straight" + size, jacks(straight_cage(), cells, 1), chord);
  measure("mesh_tricubic" + size, jacks(bent_cage(), cells, 3), chord);
}
