// SPDX-License-Identifier: LGPL-3.0-or-later
// bench/soak_micro_mesh.cc: --rounds N --seed S. Meshes of random
// microstructures, those of tests/support/random_microstructures.h, at chords from 1/6 of the narrowest cell down
// to 1/96, each half of the one before. Wrong: an error; a distance over the chord; a mesh that is not closed, or
// that has not the structure's shells and Euler characteristic; at 1/96, a mesh that is not VALID; a point of the
// surface farther from the mesh than the proved distance. Meshes that cross themselves at coarser chords are
// counted apart. One JSON line; seeds of what is wrong go to standard error.
#include <algorithm>
#include <cstdio>
#include <exception>
#include <string>
#include <utility>

#include "bench/arguments.h"
#include "solids/micro/mesh/micro_mesh.h"
#include "solids/micro/micro_topology.h"
#include "solids/polyhedron/validity.h"
#include "tests/support/approx_distance.h"
#include "tests/support/random_microstructures.h"

namespace {

using namespace veritope;

constexpr int kFinest = 96;

struct Totals {
  std::uint64_t structures = 0, meshes = 0, facets = 0, wrong = 0, refused = 0, coarse_invalid = 0,
                points = 0;
};

std::string fault_of(const MicroCounts& counts, const MicroMesh& mesh, double chord, bool is_finest,
                     Totals& totals) {
  if (!(mesh.distance <= chord)) return "the distance is over the chord";
  const ValidityReport report = decide_validity(mesh.mesh, {});
  const MeshCounts& c = report.counts;
  if (c.boundary_edges + c.nonmanifold_edges + c.misoriented_edges + c.nonmanifold_vertices +
          c.duplicate_faces !=
      0)
    return "the mesh is no closed surface";
  const std::int64_t euler = 2 * (static_cast<std::int64_t>(counts.shells) - counts.genus);
  if (c.shells != counts.shells || c.euler != euler) return "the mesh has other numbers";
  if (report.is_valid) return c.bodies == counts.components ? "" : "the mesh has other bodies";
  if (is_finest) return "the finest mesh is not VALID";
  ++totals.coarse_invalid;
  return "";
}

std::string fault_of_points(const Microstructure& micro, const std::vector<AnalysedTile>& tiles,
                            const MicroMesh& mesh, Random& random, Totals& totals) {
  const double size = random_micro::size_of(micro);
  for (int sample = 0; sample < 20; ++sample) {
    const MicroGrid& grid = micro.grids[random.below(micro.grids.size())];
    const std::size_t cell = random.below(grid.tiles.size());
    if (grid.tiles[cell] == 0) continue;
    const AnalysedTile& tile = tiles[grid.tiles[cell] - 1u];
    const std::size_t p = random.below(tile.tile.patches.size());
    if (tile.cap_of_patch[p] != AnalysedTile::kNoCap) continue;
    const auto number = [&] { return Rational(random.between(0, 1000)) / Rational(1000); };
    const Rational u = number(), v = number();
    const Vec3d at = random_micro::nearest_point(
        random_micro::exact_point(micro, grid, cell, tile.tile.patches[p], u, v));
    ++totals.points;
    if (approx::distance_to_mesh(at, mesh.mesh) > mesh.distance + 1e-13 * size)
      return "a point of the surface is too far from the mesh";
  }
  return "";
}

std::string fault_of_round(Random& random, std::string& description, Totals& totals) {
  const random_micro::Structure s = random_micro::any_structure(random);
  description = s.description;
  const VModel cage = make_v_model(s.micro.cage, VOrientation::kAuto).value();
  std::vector<AnalysedTile> tiles;
  for (const MicroTile& t : s.micro.tiles) {
    auto analysed = analyse_tile(t);
    if (std::holds_alternative<TileDefect>(analysed)) return "a tile is refused";
    tiles.push_back(std::get<AnalysedTile>(std::move(analysed)));
  }
  const auto found = topology_of(s.micro, cage, tiles);
  if (const auto* defect = std::get_if<MicroDefect>(&found))
    return std::string("the structure is refused: ") + defect->message;
  const auto& counts = std::get<MicroCounts>(found);
  if (counts.tiles == 0) return "";
  ++totals.structures;
  const double width = random_micro::width_of(s.micro);
  for (const int part : {6, 12, 24, 48, kFinest}) {
    MicroMeshOptions options;
    options.chord = width / part;
    options.max_facets = 4000000;
    const auto mesh = mesh_of(s.micro, cage, tiles, options);
    if (!mesh && mesh.error().code == Code::kOverLimit) return ++totals.refused, "";
    if (!mesh) return mesh.error().message;
    ++totals.meshes;
    totals.facets += mesh->mesh.faces.size();
    std::string fault = fault_of(counts, *mesh, options.chord, part == kFinest, totals);
    if (fault.empty() && part <= 24 && mesh->mesh.faces.size() < 200000)
      fault = fault_of_points(s.micro, tiles, *mesh, random, totals);
    if (!fault.empty()) return fault + ", chord 1/" + std::to_string(part);
  }
  return "";
}

}  // namespace

int main(int argc, char** argv) {
  int rounds = 1000;
  std::uint64_t seed = 1;
  bench::read_arguments(argc, argv, {{"--rounds", &rounds}, {"--seed", &seed}});
  Totals totals;
  for (int n = 0; n < rounds; ++n) {
    Random random(seed * 1000003 + static_cast<std::uint64_t>(n));
    std::string description;
    const std::string fault = fault_of_round(random, description, totals);
    if (fault.empty()) continue;
    ++totals.wrong;
    std::fprintf(stderr, "wrong: %s, seed %llu, round %d: %s\n", fault.c_str(),
                 static_cast<unsigned long long>(seed), n, description.c_str());
  }
  std::printf(
      "{\"name\":\"micro_mesh\",\"value\":%llu,\"goal\":\"0\",\"structures\":%llu,\"meshes\":%llu,"
      "\"facets\":%llu,\"points\":%llu,\"coarse_invalid\":%llu,\"over_limit\":%llu}\n",
      static_cast<unsigned long long>(totals.wrong),
      static_cast<unsigned long long>(totals.structures),
      static_cast<unsigned long long>(totals.meshes),
      static_cast<unsigned long long>(totals.facets),
      static_cast<unsigned long long>(totals.points),
      static_cast<unsigned long long>(totals.coarse_invalid),
      static_cast<unsigned long long>(totals.refused));
  return totals.wrong == 0 ? 0 : 1;
}
