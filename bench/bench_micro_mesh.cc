// SPDX-License-Identifier: LGPL-3.0-or-later
// bench/bench_micro_mesh.cc: --cells N --chord H. Meshes of jacks with arms of different widths in N^3 cells, in a
// straight trilinear and a bent tricubic cage, on one thread, and what the decision of their validity takes.
#include <cstdio>
#include <string>
#include <utility>

#include "bench/arguments.h"
#include "bench/bench_micro_jacks.h"
#include "bench/stopwatch.h"
#include "robust/base/check.h"
#include "solids/micro/mesh/micro_mesh.h"
#include "solids/micro/micro_topology.h"
#include "solids/polyhedron/validity.h"

namespace {

using namespace veritope;

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
  measure("mesh_straight" + size, bench::graded_jacks(bench::straight_cage(), cells, 1), chord);
  measure("mesh_tricubic" + size, bench::graded_jacks(bench::bent_cage(), cells, 3), chord);
}
