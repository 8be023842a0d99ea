// SPDX-License-Identifier: LGPL-3.0-or-later
// bench/bench_micro_filter.cc: filtering of all tiles of a grid around the bunny (69,664 facets), least of the rounds:
// jacks of degree 1 in a box, and of degree 3 in a tricubic cage, beside CGAL's AABB_tree and Side_of_triangle_mesh on
// the same tiles, triangulated; 100 x 100 x 100 cells on one and on two threads; building the look-up.
#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <ctime>
#include <string>
#include <vector>

#include "bench/arguments.h"
#include "bench/models.h"
#include "bench/stopwatch.h"
#include "bench/tile_peers.h"
#include "robust/base/check.h"
#include "solids/micro/filter/grid_filter.h"
#include "splines/bspline_pieces.h"
#include "splines/de_casteljau.h"
#include "tests/support/micro_tiles.h"

namespace {

using namespace veritope;
using namespace veritope::bench;
using micro_tiles::Point;

struct Setting {
  BezierVolume<Rational> map{{1, 1, 1}, 3, false};
  std::shared_ptr<const TileShape> shape;
  int parts = 1;  ///< each patch of the peer's tiles is cut into parts x parts squares
};

// The box of the mesh, greater by a twentieth on all sides, bent if the degree is 3.
Setting setting(const TriangleMesh& mesh, int degree) {
  Box3d box = empty_box();
  for (const Vec3d& p : mesh.positions) add(to_point(p), &box);
  Setting out;
  out.map = micro_tiles::cage({degree, degree, degree}, [&](const Point& u) {
    Point p;
    for (std::size_t c = 0; c < 3; ++c) {
      const Rational lo = Rational::from_double(box.lo[c]),
                     size = Rational::from_double(box.hi[c]) - lo, margin = size / Rational(20);
      p[c] = lo - margin + (size + margin + margin) * u[c];
      const Rational& v = u[(c + 1) % 3];
      if (degree > 1) p[c] += size / Rational(15) * v * (Rational(1) - v);
    }
    return p;
  });
  out.shape = std::make_shared<const TileShape>(micro_tiles::shape_of(micro_tiles::jack(degree)));
  out.parts = degree == 1 ? 1 : 4;
  return out;
}

BezierVolume<double> rounded(const BezierVolume<Rational>& map) {
  std::vector<double> c;
  for (const Rational& x : map.coefficients()) c.push_back(nearest_double(x));
  return {map.degrees(), 3, false, std::move(c)};
}

std::array<std::vector<Rational>, 3> lines_of(int n) {
  std::array<std::vector<Rational>, 3> out;
  for (auto& lines : out)
    for (int i = 0; i <= n; ++i) lines.push_back(Rational(i) / Rational(n));
  return out;
}

GridStatus filtered(const TileFilter& filter, const Setting& s, int n, unsigned jobs) {
  return std::move(
      filter_grid(
          filter, to_bspline(s.map), lines_of(n), [&](const auto&) { return s.shape; }, jobs)
          .value());
}

// The tile's triangles in the unit cube.
std::vector<std::array<Point3d, 3>> triangles_of(const Setting& s) {
  std::vector<std::array<Point3d, 3>> out;
  for (const TileShape::Side& side : s.shape->patches()) {
    const auto at = [&](int i, int j) {
      const auto x = evaluate<Rational, 2>(
          side.exact, {Rational(i) / Rational(s.parts), Rational(j) / Rational(s.parts)});
      return Point3d{nearest_double(x[0]), nearest_double(x[1]), nearest_double(x[2])};
    };
    for (int i = 0; i < s.parts; ++i)
      for (int j = 0; j < s.parts; ++j) {
        out.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
        out.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
      }
  }
  return out;
}

// Filters the same tiles as people do; returns how many are inside.
std::uint64_t peer_filtered(const CgalTiles& peer, const Setting& s, int n) {
  const BezierVolume<double> map = rounded(s.map);
  const auto triangles = triangles_of(s);
  std::vector<std::array<Vec3d, 3>> placed(triangles.size());
  std::uint64_t inside = 0;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j)
      for (int k = 0; k < n; ++k) {
        for (std::size_t t = 0; t < triangles.size(); ++t)
          for (std::size_t c = 0; c < 3; ++c) {
            const Point3d& p = triangles[t][c];
            const auto x =
                evaluate<double, 3>(map, {(i + p[0]) / n, (j + p[1]) / n, (k + p[2]) / n});
            placed[t][c] = {x[0], x[1], x[2]};
          }
        inside += peer(placed) == PeerStatus::kInside ? 1 : 0;
      }
  return inside;
}

void print_row(const std::string& row, double ours, double peer, const std::string& more) {
  const std::string peer_text = peer > 0 ? std::to_string(peer) : "null";
  std::printf("{\"row\":\"%s\",\"ours\":%.6g,\"peer\":%s,\"unit\":\"s\"%s}\n", row.c_str(), ours,
              peer_text.c_str(), more.c_str());
  std::fflush(stdout);
}

std::string counts_text(const GridStatus& g) {
  std::string out;
  for (std::size_t s = 0; s < g.counts.size(); ++s)
    out += std::string(",\"") + cell_status_name(static_cast<CellStatus>(s)) +
           "\":" + std::to_string(g.counts[s]);
  return out;
}

void measure_beside_cgal(const std::string& name, const TileFilter& filter, const CgalTiles& peer,
                         const Setting& s, int n, int rounds) {
  double ours = 1e300;
  GridStatus result;
  for (int round = 0; round < rounds; ++round) {
    const Stopwatch watch;
    result = filtered(filter, s, n, 1);
    ours = std::min(ours, watch.ns());
  }
  const Stopwatch watch;
  const std::uint64_t inside = peer_filtered(peer, s, n);
  print_row(name, ours * 1e-9, watch.ns() * 1e-9,
            counts_text(result) + ",\"peer_kept\":" + std::to_string(inside));
}

// By the wall clock; the processor time of all threads is beside it, since a busy machine may give both threads no more
// than one.
void measure_threads(const std::string& name, const TileFilter& filter, const Setting& s, int n,
                     int rounds) {
  std::array<double, 2> least{1e300, 1e300}, work = least;
  GridStatus first;
  for (int round = 0; round < rounds; ++round)
    for (unsigned jobs = 1; jobs <= 2; ++jobs) {
      const auto begin = std::chrono::steady_clock::now();
      const std::clock_t processor = std::clock();
      GridStatus result = filtered(filter, s, n, jobs);
      const std::chrono::duration<double> t = std::chrono::steady_clock::now() - begin;
      least[jobs - 1] = std::min(least[jobs - 1], t.count());
      work[jobs - 1] =
          std::min(work[jobs - 1], static_cast<double>(std::clock() - processor) / CLOCKS_PER_SEC);
      if (round == 0 && jobs == 1)
        first = std::move(result);
      else
        VT_CHECK(result.status == first.status, "the result depends on the threads");
    }
  print_row(name, least[0], 0,
            counts_text(first) + ",\"two_threads\":" + std::to_string(least[1]) + ",\"speedup\":" +
                std::to_string(least[0] / least[1]) + ",\"processor\":" + std::to_string(work[0]) +
                ",\"two_threads_processor\":" + std::to_string(work[1]));
}

}  // namespace

int main(int argc, char** argv) {
  int cells = 40, large = 100, rounds = 3;
  read_arguments(argc, argv, {{"--cells", &cells}, {"--large", &large}, {"--rounds", &rounds}});
  const TriangleMesh mesh = named_model("bunny70k");
  Stopwatch watch;
  const TileFilter filter = std::move(TileFilter::make(mesh).value());
  const double building = watch.ns();
  watch = Stopwatch();
  const CgalTiles peer(mesh);
  print_row("filter_building", building * 1e-9, watch.ns() * 1e-9, "");
  const Setting straight = setting(mesh, 1), curved = setting(mesh, 3);
  measure_beside_cgal("filter_mesh_vs_cgal", filter, peer, straight, cells, rounds);
  measure_beside_cgal("filter_mesh_curved_vs_cgal", filter, peer, curved, cells / 2, rounds);
  measure_threads("filter_mesh_" + std::to_string(large), filter, straight, large, rounds);
  measure_threads("filter_mesh_curved_" + std::to_string(large), filter, curved, large, rounds);
}
