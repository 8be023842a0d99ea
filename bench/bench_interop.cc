// SPDX-License-Identifier: LGPL-3.0-or-later
// bench/bench_interop.cc: CGAL's algorithms on our predicates (interop/cgal.h) and on CGAL's own kernel EPICK, seconds
// a run, in alternating runs, least of five. grid: integer points, all cubes degenerate.
#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Delaunay_triangulation_3.h>

#include <algorithm>
#include <cstdio>
#include <vector>

#include "bench/stopwatch.h"
#include "interop/cgal.h"
#include "robust/base/random.h"

namespace {

using namespace veritope;
using Epick = CGAL::Exact_predicates_inexact_constructions_kernel;

struct Timed {
  double seconds = 1e300;
  std::size_t cells = 0;
  template <typename Triangulation, typename Points>
  void run(const Points& points) {
    const bench::Stopwatch watch;
    const Triangulation t(points.begin(), points.end());
    seconds = std::min(seconds, 1e-9 * watch.ns());
    if constexpr (requires { t.number_of_cells(); }) {
      cells = t.number_of_cells();
    } else {
      cells = t.number_of_faces();
    }
  }
};

template <typename Ours, typename Peer, typename Points>
void row(const char* name, const Points& points) {
  Timed ours, peer;
  for (int r = 0; r < 5; ++r) ours.run<Ours>(points), peer.run<Peer>(points);
  std::printf(
      "{\"row\":\"%s_vs_epick\",\"ours\":%.4f,\"peer\":%.4f,\"unit\":\"s\",\"points\":%zu,"
      "\"same_number_of_cells\":%s}\n",
      name, ours.seconds, peer.seconds, points.size(), ours.cells == peer.cells ? "true" : "false");
}

}  // namespace

int main() {
  Random random(42);
  std::vector<Epick::Point_3> space, grid;
  std::vector<Epick::Point_2> plane;
  for (int i = 0; i < 100000; ++i) {
    space.emplace_back(random.unit(), random.unit(), random.unit());
    plane.emplace_back(random.unit(), random.unit());
  }
  for (int i = 0; i < 27000; ++i) grid.emplace_back(i % 30, i / 30 % 30, i / 900);
  row<CGAL::Delaunay_triangulation_3<CgalTraits>, CGAL::Delaunay_triangulation_3<Epick>>(
      "interop_delaunay3", space);
  row<CGAL::Delaunay_triangulation_3<CgalTraits>, CGAL::Delaunay_triangulation_3<Epick>>(
      "interop_delaunay3_grid", grid);
  row<CGAL::Delaunay_triangulation_2<CgalTraits>, CGAL::Delaunay_triangulation_2<Epick>>(
      "interop_delaunay2", plane);
}
