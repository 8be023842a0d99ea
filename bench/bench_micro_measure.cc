// SPDX-License-Identifier: LGPL-3.0-or-later
// bench/bench_micro_measure.cc: --cells N --sample M. The volume of jacks with arms of different widths in N^3 cells
// of a straight and of a bent tricubic cage, enclosed, on one thread. The peer composes each patch of each tile in
// binary64, as splines/composition.h does, and integrates the flux of x through it; it is timed for M cells and scaled.
#include <cmath>
#include <cstdio>
#include <string>
#include <utility>

#include "bench/arguments.h"
#include "bench/bench_micro_jacks.h"
#include "bench/stopwatch.h"
#include "interval/numeric.h"
#include "robust/base/check.h"
#include "solids/micro/measure/micro_volume.h"
#include "splines/bezier_calculus.h"
#include "splines/bezier_product.h"
#include "splines/composition.h"
#include "splines/composition_span.h"

namespace {

using namespace veritope;

BezierVolume<double> nearest_piece(const VVolume& cage) {
  const BezierVolume<Rational> piece = bezier_pieces(cage).pieces.front();
  std::vector<double> numbers;
  for (const Rational& x : piece.coefficients()) numbers.push_back(nearest_double(x));
  return {piece.degrees(), 3, false, std::move(numbers)};
}

// Three times the volume of a composed tile.
double composed_flux(const BezierVolume<double>& cage, const Microstructure& micro,
                     const std::array<std::size_t, 3>& cell) {
  const MicroGrid& grid = micro.grids[0];
  const WallNumbers numbers = grid.numbers_of(cell);
  double sum = 0;
  for (const TilePatch& patch : micro.tiles[0].patches) {
    BezierSurface<double> inner(patch.degrees, 3, false);
    const double t = number_of(patch, numbers) * 0x1p-20;
    for (std::size_t n = 0; n < patch.num_points(); ++n)
      for (std::size_t a = 0; a < 3; ++a) {
        double x = 0;
        for (std::size_t power = patch.points.size(); power-- > 0;)
          x = x * t + nearest_double(patch.points[power][n][a]);
        const auto size = static_cast<double>(grid.shape().size[a]);
        inner.component(static_cast<int>(a))[n] = (static_cast<double>(cell[a]) + x) / size;
      }
    const BezierSurface<double> x = compose(cage, inner).value();
    sum += integral(dot(x, cross(derivative(x, 0), derivative(x, 1))))[0];
  }
  return sum;
}

void measure(const std::string& name, const Microstructure& micro, std::uint64_t sample) {
  const VModel cage = make_v_model(micro.cage, VOrientation::kAuto).value();
  bench::Stopwatch watch;
  const auto found = volume_of(micro, cage, 1);
  const double seconds = watch.ns() * 1e-9;
  VT_CHECK(found.has_value(), "the structure has a volume");
  const BezierVolume<double> piece = nearest_piece(micro.cage[0]);
  const Grid<3> shape = micro.grids[0].shape();
  const std::size_t step = std::max<std::size_t>(shape.count() / sample, 1);
  std::size_t composed = 0;
  double flux = 0;
  watch = bench::Stopwatch();
  for (std::size_t c = 0; c < shape.count(); c += step, ++composed)
    flux += composed_flux(piece, micro, shape.index_of(c));
  const double peer =
      watch.ns() * 1e-9 * static_cast<double>(shape.count()) / static_cast<double>(composed);
  const double about =
      flux / 3 * static_cast<double>(shape.count()) / static_cast<double>(composed);
  VT_CHECK(std::fabs(about / mid(found->tiles) - 1) < 0.05, "both find nearly one volume");
  std::printf(
      "{\"row\":\"%s\",\"ours\":%.6g,\"peer\":%.6g,\"unit\":\"s\",\"ratio\":%.4g,\"volume\":%.17g,"
      "\"relative_width\":%.2g}\n",
      name.c_str(), seconds, peer, seconds / peer, mid(found->tiles),
      wid(found->tiles) / mid(found->tiles));
  std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
  std::uint64_t cells = 46, sample = 500;
  bench::read_arguments(argc, argv, {{"--cells", &cells}, {"--sample", &sample}});
  const std::string size = "_" + std::to_string(cells * cells * cells);
  measure("measure_straight" + size, bench::graded_jacks(bench::straight_cage(), cells, 1), sample);
  measure("measure_tricubic" + size, bench::graded_jacks(bench::bent_cage(), cells, 3), sample);
}
