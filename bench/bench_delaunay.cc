// SPDX-License-Identifier: LGPL-3.0-or-later
// bench/bench_delaunay.cc: Delaunay tetrahedralizations beside CGAL's Delaunay_triangulation_3 (its kernel EPICK, its
// spatial sort), alternating runs, least of each. grid: integer points, all cubes degenerate.
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <span>
#include <vector>

#include "bench/arguments.h"
#include "bench/stopwatch.h"
#include "robust/base/random.h"
#include "solids/tetrahedra/delaunay.h"

namespace {

using namespace veritope;
using Epick = CGAL::Exact_predicates_inexact_constructions_kernel;

void row(const char* name, const std::vector<Vec3d>& points, int runs) {
  std::vector<Epick::Point_3> peers;
  for (const Vec3d& p : points) peers.emplace_back(p.x, p.y, p.z);
  double ours = 1e300, peer = 1e300;
  std::size_t cells = 0, peer_cells = 0;
  for (int r = 0; r < runs; ++r) {
    {
      const bench::Stopwatch watch;
      cells = delaunay_tetrahedra(std::span<const Vec3d>(points)).value().tetrahedra.size();
      ours = std::min(ours, 1e-9 * watch.ns());
    }
    {
      const bench::Stopwatch watch;
      const CGAL::Delaunay_triangulation_3<Epick> t(peers.begin(), peers.end());
      peer = std::min(peer, 1e-9 * watch.ns());
      peer_cells = t.number_of_finite_cells();
    }
  }
  std::printf(
      "{\"row\":\"%s\",\"ours\":%.4f,\"peer\":%.4f,\"unit\":\"s\",\"points\":%zu,\"tetrahedra\":%"
      "zu,"
      "\"same_number\":%s}\n",
      name, ours, peer, points.size(), cells, cells == peer_cells ? "true" : "false");
  std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
  std::uint64_t count = 100000;
  int runs = 5;
  bench::read_arguments(argc, argv, {{"--points", &count}, {"--runs", &runs}});
  Random random(42);
  std::vector<Vec3d> space, grid, sphere;
  for (std::uint64_t i = 0; i < count; ++i)
    space.push_back({random.unit(), random.unit(), random.unit()});
  for (int i = 0; i < 27000; ++i) grid.push_back({i % 30 + 0.0, i / 30 % 30 + 0.0, i / 900 + 0.0});
  for (int i = 0; i < 20000; ++i) {
    const double x = random.unit() - .5, y = random.unit() - .5, z = random.unit() - .5;
    const double r = std::sqrt(x * x + y * y + z * z) + 1e-9;
    sphere.push_back({x / r, y / r, z / r});
  }
  row("delaunay_vs_cgal", space, runs);
  row("delaunay_vs_cgal_grid", grid, runs);
  row("delaunay_vs_cgal_sphere", sphere, runs);
}
