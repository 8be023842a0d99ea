// SPDX-License-Identifier: LGPL-3.0-or-later
// bench/bench_micro_filter_patches.cc: filtering of all tiles of a grid around a ball with a neck, 17 rational patches
// of revolution, least of the rounds: jacks of degree 1 in a box, and of degree 3 in a tricubic cage. Beside Open
// CASCADE's BRepExtrema_DistShapeShape of the tile's faces and the shell, and its classifier, every `stride`-th tile,
// each by itself: jacks of degree 1 in both cages.
#include <algorithm>
#include <array>
#include <cstdio>
#include <string>
#include <vector>

#include "bench/arguments.h"
#include "bench/stopwatch.h"
#ifdef VERITOPE_BENCH_OCCT
#include "bench/patch_tile_peers.h"
#endif
#include "models/round_parts.h"
#include "robust/base/check.h"
#include "solids/micro/filter/grid_filter.h"
#include "solids/patches/patch_complex.h"
#include "splines/bspline_pieces.h"
#include "splines/composition.h"
#include "splines/de_casteljau.h"
#include "tests/support/micro_tiles.h"

namespace {

using namespace veritope;
using namespace veritope::bench;
using micro_tiles::Point;

// A box that is a little larger than the solid, bent if the degree is 3.
BezierVolume<Rational> cage_of(int degree) {
  const Point lo{Rational(-11) / 2, Rational(-11) / 2, Rational(-11) / 2}, size{11, 11, 14};
  return micro_tiles::cage({degree, degree, degree}, [&](const Point& u) {
    Point p;
    for (std::size_t c = 0; c < 3; ++c) {
      p[c] = lo[c] + size[c] * u[c];
      const Rational& v = u[(c + 1) % 3];
      if (degree > 1) p[c] += size[c] / Rational(15) * v * (Rational(1) - v);
    }
    return p;
  });
}

struct Question {
  BezierVolume<Rational> map;
  std::shared_ptr<const TileShape> shape;
  int n;
};

GridStatus filtered(const TileFilter& filter, const Question& q) {
  std::array<std::vector<Rational>, 3> lines;
  for (auto& along : lines)
    for (int i = 0; i <= q.n; ++i) along.push_back(Rational(i) / Rational(q.n));
  return std::move(filter_grid(
                       filter, to_bspline(q.map), lines, [&](const auto&) { return q.shape; }, 1)
                       .value());
}

// Our statuses of the chosen cells alone, each by itself, in seconds; then the peer's.
struct Sample {
  double ours = 0, peer = 0;
  std::uint64_t cells = 0, kept = 0, peer_kept = 0;
};

#ifdef VERITOPE_BENCH_OCCT
Sample sampled(const TileFilter& filter, const OcctTiles& peer, const Question& q, int stride) {
  Sample out;
  int number = 0;
  for (int i = 0; i < q.n; ++i)
    for (int j = 0; j < q.n; ++j)
      for (int k = 0; k < q.n; ++k) {
        if (number++ % stride != 0) continue;
        CellMap cell{&q.map};
        for (std::size_t a = 0; a < 3; ++a) {
          const int at = a == 0 ? i : a == 1 ? j : k;
          cell.lo[a] = Rational(at) / Rational(q.n);
          cell.hi[a] = Rational(at + 1) / Rational(q.n);
        }
        ++out.cells;
        const Stopwatch watch;
        out.kept += filter.status(cell, *q.shape) == CellStatus::kKept ? 1 : 0;
        out.ours += watch.ns() * 1e-9;
        // The peer's patches are composed beforehand: that is not counted.
        BezierVolume<Rational> part = q.map;
        for (std::size_t a = 0; a < 3; ++a) part = restricted(part, a, cell.lo[a], cell.hi[a]);
        std::vector<BezierSurface<Rational>> placed;
        for (const TileShape::Side& side : q.shape->patches())
          placed.push_back(compose(part, side.exact).value());
        const OcctTiles::Tile tile(placed);
        const Stopwatch peer_watch;
        out.peer_kept += peer.is_inside(tile) ? 1 : 0;
        out.peer += peer_watch.ns() * 1e-9;
      }
  return out;
}

void print_sample(const char* name, const Sample& s) {
  std::printf(
      "{\"row\":\"%s\",\"ours\":%.6g,\"peer\":%.6g,\"unit\":\"s\",\"cells\":%llu,"
      "\"kept\":%llu,\"peer_kept\":%llu}\n",
      name, s.ours, s.peer, static_cast<unsigned long long>(s.cells),
      static_cast<unsigned long long>(s.kept), static_cast<unsigned long long>(s.peer_kept));
  std::fflush(stdout);
}
#endif

void measure(const std::string& name, const TileFilter& filter, const Question& q, int rounds) {
  double least = 1e300;
  GridStatus result;
  for (int round = 0; round < rounds; ++round) {
    const Stopwatch watch;
    result = filtered(filter, q);
    least = std::min(least, watch.ns() * 1e-9);
  }
  std::printf("{\"row\":\"%s\",\"ours\":%.6g,\"peer\":null,\"unit\":\"s\"", name.c_str(), least);
  for (std::size_t s = 0; s < result.counts.size(); ++s)
    std::printf(",\"%s\":%llu", cell_status_name(static_cast<CellStatus>(s)),
                static_cast<unsigned long long>(result.counts[s]));
  std::printf("}\n");
  std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
  int cells = 20, rounds = 3, stride = 97;
  read_arguments(argc, argv, {{"--cells", &cells}, {"--rounds", &rounds}, {"--stride", &stride}});
  const patch_shapes::Patches patches = patch_shapes::ball_with_neck();
  const PatchComplex complex = make_patch_complex(patches).value();
  VT_CHECK(complex.is_closed_oriented_surface(), "the model is not closed");
  const Stopwatch watch;
  const TileFilter filter = TileFilter::make(complex);
  std::printf("{\"row\":\"filter_spline_building\",\"ours\":%.6g,\"peer\":null,\"unit\":\"s\"}\n",
              watch.ns() * 1e-9);
#ifdef VERITOPE_BENCH_OCCT
  const OcctTiles peer(patches);
#endif
  const auto question = [&](int cage, int tile) {
    return Question{
        cage_of(cage),
        std::make_shared<const TileShape>(micro_tiles::shape_of(micro_tiles::jack(tile))), cells};
  };
  measure("filter_spline", filter, question(1, 1), rounds);
  measure("filter_spline_curved", filter, question(3, 3), rounds);
#ifdef VERITOPE_BENCH_OCCT
  // Open CASCADE has no patches of degree 27, those of cubic arms in a tricubic cage.
  print_sample("filter_spline_vs_occt", sampled(filter, peer, question(1, 1), stride));
  print_sample("filter_spline_curved_vs_occt", sampled(filter, peer, question(3, 1), stride));
#endif
}
