// SPDX-License-Identifier: LGPL-3.0-or-later
// bench/bench_micro_flying_edges.cc: --cells N --cubic M --chord H --runs R --write FOLDER. Meshes
// of N^3 jacks with frusta as arms, and of M^3 jacks with cubic arms at a chord of H cells, in a
// straight cage, beside VTK's flying edges on a field of the same jacks, on a grid that gives the
// same number of facets within a twentieth. One thread, medians. What certify says of VTK's meshes:
// with points of the grid on the outer caps, and with the grid moved by 0.37 steps. With --write,
// VTK's meshes are left in this folder.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <utility>
#include <vector>

#include "bench/arguments.h"
#include "bench/bench_micro_jacks.h"
#include "bench/jack_field.h"
#include "bench/stopwatch.h"
#include "bench/surface_peers.h"
#include "io/mesh/write_mesh.h"
#include "io/read_model.h"
#include "robust/base/check.h"
#include "solids/micro/mesh/micro_mesh.h"
#include "solids/micro/micro_topology.h"
#include "verify/certify/certify.h"

namespace {

using namespace veritope;

constexpr int kMostSteps = 12;   // of a grid in a cell
constexpr int kMostParts = 420;  // of a grid of a few cells: 75 million points

struct Case {
  std::string name;
  std::uint64_t cells = 0;
  int degree = 1;
  double chord = 0;  ///< in units of the model
};

// Nothing is certified unless it is asked for: that takes longer.
struct Ours {
  double mesh = 0, written = 0, certified = 0, distance = 0;
  std::size_t facets = 0;
  std::int64_t euler = 0;
};

struct Peer {
  double field = 0, surface = 0;
  TriangleMesh mesh;
};

double median_of(std::vector<double> v) {
  std::sort(v.begin(), v.end());
  return v[v.size() / 2];
}

std::string ply_of(const TriangleMesh& mesh) {
  return mesh_to_bytes(mesh, default_write_options(MeshFormat::kPly)).value();
}
Certified certified_ply(const std::string& bytes) {
  ModelReadOptions reading;
  reading.format = MeshFormat::kPly;
  reading.jobs = 1;
  reading.limits.max_faces = std::uint64_t{1} << 31;
  reading.limits.max_bytes = std::uint64_t{1} << 40;
  const auto* const begin = reinterpret_cast<const unsigned char*>(bytes.data());
  return certify(ModelFile(read_mesh_bytes({begin, bytes.size()}, "bench.ply", reading).value()))
      .value();
}
const MeshCounts& counts_of(const Certified& c) {
  return std::get<MeshFacts>(c.facts).decision.counts;
}

Ours ours_of(const Case& what, const Microstructure& micro, bool with_certificate) {
  const VModel cage = make_v_model(micro.cage, VOrientation::kAuto).value();
  const std::vector<AnalysedTile> tiles = {
      std::get<AnalysedTile>(analyse_tile(micro.tiles.front()))};
  MicroMeshOptions options;
  options.chord = what.chord;
  Ours out;
  bench::Stopwatch watch;
  const MicroMesh mesh = mesh_of(micro, cage, tiles, options).value();
  out.mesh = watch.ns() * 1e-9;
  out.facets = mesh.mesh.faces.size();
  out.distance = mesh.distance;
  out.euler = static_cast<std::int64_t>(mesh.mesh.positions.size()) -
              static_cast<std::int64_t>(out.facets) / 2;
  if (!with_certificate) return out;
  const std::string bytes = ply_of(mesh.mesh);
  out.written = watch.ns() * 1e-9;
  const Certified certified = certified_ply(bytes);
  out.certified = watch.ns() * 1e-9;
  const auto expected = std::get<MicroCounts>(topology_of(micro, cage, tiles));
  VT_CHECK(certified.verdict == Verdict::kValid && !certified.certificate.empty() &&
               counts_of(certified).genus == expected.genus &&
               counts_of(certified).euler == out.euler,
           "the written mesh is certified, with the structure's genus");
  return out;
}

Peer peer_of(const bench::JackField& field, int parts, double shift) {
  Peer out;
  const bench::Stopwatch watch;
  bench::FieldGrid grid = field.sample(parts, shift);
  out.field = watch.ns() * 1e-9;
  bench::PeerSurface surface = bench::flying_edges(grid);
  out.surface = surface.ns * 1e-9;
  out.mesh = std::move(surface.mesh);
  return out;
}

// The number of facets grows with the square of the number of parts, but for features that a coarse
// grid loses.
int parts_for(const bench::JackField& field, std::size_t facets, std::uint64_t cells) {
  const auto wanted = static_cast<double>(facets);
  double parts = 3 * static_cast<double>(cells), best = parts, best_error = 1e9;
  for (int tries = 0; tries < 8; ++tries) {
    const auto made =
        static_cast<double>(peer_of(field, static_cast<int>(parts), 0).mesh.faces.size());
    const double error = std::abs(made / wanted - 1);
    if (error < best_error) best = parts, best_error = error;
    if (error < 0.05) break;
    parts = std::round(parts * std::sqrt(wanted / made));
  }
  VT_CHECK(best_error < 0.2, "the numbers of facets are within a fifth");
  return static_cast<int>(best);
}

// The greatest value of the field at the middles of the facets: not more than the distance from the
// surface.
double gap_of(const bench::JackField& field, const TriangleMesh& mesh, double n) {
  double out = 0;
  for (const auto& f : mesh.faces) {
    const Vec3d &a = mesh.positions[f[0]], &b = mesh.positions[f[1]], &c = mesh.positions[f[2]];
    const Vec3d p{(a.x + b.x + c.x) / 3, (a.y + b.y + c.y) / 3, (a.z + b.z + c.z) / 3};
    out = std::max(out, std::abs(field.at(p)));
  }
  return out / n;
}

void ratio_row(const std::string& name, double ours, double peer, const std::string& more) {
  std::printf("{\"row\":\"%s\",\"ours\":%.6g,\"peer\":%.6g,\"unit\":\"s\"%s}\n", name.c_str(), ours,
              peer, more.c_str());
  std::fflush(stdout);
}

// A grid of whole steps in a cell, the coarsest on which VTK's mesh has the Euler characteristic of
// the structure. Meshes of vtkFlyingEdges3D are closed here: three edges for two facets.
void same_numbers_row(const Case& what, const bench::JackField& field, const Ours& ours,
                      double seconds) {
  for (int steps = 2; steps <= kMostSteps; ++steps) {
    const int parts = steps * static_cast<int>(what.cells);
    const Peer peer = peer_of(field, parts, 0.37);
    const auto facets = static_cast<std::int64_t>(peer.mesh.faces.size());
    if (static_cast<std::int64_t>(peer.mesh.positions.size()) - facets / 2 != ours.euler) continue;
    char more[200];
    std::snprintf(more, sizeof more,
                  ",\"facets\":%zu,\"peer_facets\":%zu,\"peer_grid\":%d,\"peer_field\":%.4g,"
                  "\"peer_surface\":%.4g,\"peer_distance_at_least\":%.3g",
                  ours.facets, peer.mesh.faces.size(), parts, peer.field, peer.surface,
                  gap_of(field, peer.mesh, static_cast<double>(what.cells)));
    return ratio_row("mesh_vs_flyingedges_" + what.name + "_same_euler", seconds,
                     peer.field + peer.surface, more);
  }
  std::fprintf(stderr, "%s: no grid of %d steps a cell gives the structure's numbers\n",
               what.name.c_str(), kMostSteps);
}

// The coarsest grid of the same jacks on which no middle of a facet is farther off than our chord,
// within a tenth.
void same_distance_row(const Case& what) {
  const Microstructure micro = bench::graded_jacks(bench::straight_cage(), what.cells, what.degree);
  const bench::JackField field(micro.grids.front(), what.degree);
  const auto n = static_cast<double>(what.cells);
  const Ours ours = ours_of(what, micro, false);
  for (int parts = 10 * static_cast<int>(what.cells); parts <= kMostParts; parts += parts / 10) {
    const Peer peer = peer_of(field, parts, 0.37);
    const double gap = gap_of(field, peer.mesh, n);
    if (gap > what.chord && parts + parts / 10 <= kMostParts) continue;
    char more[300];
    std::snprintf(more, sizeof more,
                  ",\"cells\":%.0f,\"facets\":%zu,\"peer_facets\":%zu,\"peer_grid\":%d,"
                  "\"peer_field\":%.4g,\"peer_surface\":%.4g,\"distance\":%.3g,"
                  "\"peer_distance_at_least\":%.3g",
                  n * n * n, ours.facets, peer.mesh.faces.size(), parts, peer.field, peer.surface,
                  ours.distance, gap);
    return ratio_row("mesh_vs_flyingedges_" + what.name + "_same_distance", ours.mesh,
                     peer.field + peer.surface, more);
  }
}

void verdict_row(const Case& what, const std::string& grid, const TriangleMesh& mesh,
                 const std::string& folder) {
  const std::string bytes = ply_of(mesh);
  if (!folder.empty())
    VT_CHECK(write_mesh_file(folder + "/" + what.name + "_" + grid + ".ply", mesh,
                             default_write_options(MeshFormat::kPly))
                 .has_value(),
             "the mesh is written");
  const bench::Stopwatch watch;
  const Certified c = certified_ply(bytes);
  const MeshCounts& n = counts_of(c);
  const auto number = [](std::uint64_t x) { return static_cast<unsigned long long>(x); };
  std::printf(
      "{\"row\":\"certify_of_flyingedges_%s_%s\",\"ours\":%.6g,\"peer\":null,\"unit\":\"s\","
      "\"verdict\":\"%s\",\"facets\":%llu,\"degenerate\":%llu,\"duplicate\":%llu,\"boundary_"
      "edges\":"
      "%llu,\"nonmanifold_edges\":%llu,\"misoriented_edges\":%llu,\"nonmanifold_vertices\":%llu,"
      "\"selfint_pairs\":%llu,\"shells\":%llu,\"euler\":%lld,\"genus\":%s}\n",
      what.name.c_str(), grid.c_str(), watch.ns() * 1e-9, verdict_name(c.verdict), number(n.faces),
      number(std::get<MeshFacts>(c.facts).decision.rule_counts[0]), number(n.duplicate_faces),
      number(n.boundary_edges), number(n.nonmanifold_edges), number(n.misoriented_edges),
      number(n.nonmanifold_vertices), number(n.selfint_pairs), number(n.shells),
      static_cast<long long>(n.euler), n.genus ? std::to_string(*n.genus).c_str() : "null");
  std::fflush(stdout);
}

void measure(const Case& what, int runs, const std::string& folder) {
  const Microstructure micro = bench::graded_jacks(bench::straight_cage(), what.cells, what.degree);
  const bench::JackField field(micro.grids.front(), what.degree);
  const Ours ours = ours_of(what, micro, true);
  const int parts = parts_for(field, ours.facets, what.cells);
  Peer peer;
  std::vector<double> mesh, fields, surfaces, sums;
  for (int run = 0; run < runs; ++run) {
    mesh.push_back(ours_of(what, micro, false).mesh);
    peer = peer_of(field, parts, 0);
    fields.push_back(peer.field);
    surfaces.push_back(peer.surface);
    sums.push_back(peer.field + peer.surface);
  }
  const double n = static_cast<double>(what.cells);
  char more[400];
  std::snprintf(more, sizeof more,
                ",\"cells\":%.0f,\"facets\":%zu,\"peer_facets\":%zu,\"peer_grid\":%d,"
                "\"peer_field\":%.4g,\"peer_surface\":%.4g,\"distance\":%.3g,"
                "\"peer_distance_at_least\":%.3g",
                n * n * n, ours.facets, peer.mesh.faces.size(), parts, median_of(fields),
                median_of(surfaces), ours.distance, gap_of(field, peer.mesh, n));
  ratio_row("mesh_vs_flyingedges_" + what.name, median_of(mesh), median_of(sums), more);
  ratio_row("mesh_certified_vs_flyingedges_" + what.name, ours.certified, median_of(sums),
            ",\"until_written\":" + std::to_string(ours.written));
  same_numbers_row(what, field, ours, median_of(mesh));
  verdict_row(what, "aligned", peer.mesh, folder);
  verdict_row(what, "moved", peer_of(field, parts, 0.37).mesh, folder);
}

}  // namespace

int main(int argc, char** argv) {
  std::uint64_t cells = 47, cubic = 20;
  double chord = 0.005;
  int runs = 3;
  std::string folder;
  bench::read_arguments(argc, argv,
                        {{"--cells", &cells},
                         {"--cubic", &cubic},
                         {"--chord", &chord},
                         {"--runs", &runs},
                         {"--write", &folder}});
  const auto fine = [&](std::uint64_t n) { return chord / static_cast<double>(n); };
  if (!bench::kHasFlyingEdges) return std::fprintf(stderr, "VTK was not found: no rows\n"), 0;
  if (cells > 0) measure({"frusta", cells, 1, fine(cells)}, runs, folder);
  if (cubic > 0) measure({"cubic", cubic, 3, fine(cubic)}, runs, folder);
  if (cubic > 0) same_distance_row({"cubic", 4, 3, fine(4)});
}
