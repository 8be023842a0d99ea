// SPDX-License-Identifier: LGPL-3.0-or-later
// bench/bench_vmodel.cc: V-models on one thread, least of the rounds. The certified signs of the determinant's
// coefficients on a distorted tricubic piece beside the same coefficients in plain double, and in integers; on 512 such
// cells beside Gmsh's bounds of the determinants of the same cells; gluing of distorted grids of trilinear and tricubic
// cells; the decision of their determinants.
#include <algorithm>
#include <cstdio>
#include <string>
#include <utility>
#include <vector>

#include "bench/gmsh_quality.h"
#include "bench/stopwatch.h"
#include "robust/base/check.h"
#include "robust/base/fp_guard.h"
#include "solids/vmodel/jacobian_net.h"
#include "solids/vmodel/jacobian_sign.h"
#include "solids/vmodel/piece_cutter.h"
#include "splines/bspline_pieces.h"
#include "splines/de_casteljau.h"
#include "splines/knot_insertion.h"
#include "tests/support/v_cells.h"

namespace {

using namespace veritope;
using namespace veritope::bench;

// A point of the grid moved by less than 1/8, the same way for all cells that share it.
v_cells::Point distorted(const v_cells::Point& p) {
  v_cells::Point out = p;
  for (std::size_t c = 0; c < 3; ++c) {
    std::uint64_t h = 0x9e3779b97f4a7c15u + c;
    for (const Rational& x : p) {
      h ^= static_cast<std::uint64_t>((x * Rational(6)).numerator().to_int64());
      h *= 0xbf58476d1ce4e5b9u;
      h ^= h >> 29;
    }
    // A double: 0.1 and the like have 53 bits.
    const double exact = nearest_double(p[c]) + 0.02 * static_cast<double>(h >> 11) * 0x1p-53;
    out[c] = Rational::from_double(exact);
  }
  return out;
}

template <typename Body>
double least_ns(int rounds, int repeats, Body body) {
  double least = 1e300;
  for (int round = 0; round < rounds; ++round) {
    const Stopwatch watch;
    for (int i = 0; i < repeats; ++i) body();
    least = std::min(least, watch.ns() / repeats);
  }
  return least;
}

void print_row(const std::string& row, double ours, double peer, const char* unit) {
  if (peer > 0) {
    std::printf("{\"row\":\"%s\",\"ours\":%.6g,\"peer\":%.6g,\"unit\":\"%s\"}\n", row.c_str(), ours,
                peer, unit);
  } else {
    std::printf("{\"row\":\"%s\",\"ours\":%.6g,\"peer\":null,\"unit\":\"%s\"}\n", row.c_str(), ours,
                unit);
  }
  std::fflush(stdout);
}

void measure_piece(const std::string& name, const VVolume& cell) {
  std::array<std::vector<Rational>, 3> breaks;
  for (std::size_t a = 0; a < 3; ++a) breaks[a] = internal::breaks_of(cell.axis(a));
  const PieceCutter cutter(cell, breaks);
  const ScopedDefaultFp nearest;
  bool is_positive = true;
  const double ours = least_ns(20, 50, [&] {
    is_positive = is_positive && rounded_jacobian(cutter.rounded({0, 0, 0})).is_positive(1);
  });
  VT_CHECK(is_positive, "the piece is not folded");
  const BezierVolume<double> map = cutter.rounded({0, 0, 0}).map;
  double sum = 0;
  const double plain = least_ns(20, 50, [&] { sum += internal::plain_jacobian(map).front(); });
  const double exact = least_ns(5, 3, [&] {
    sum += exact_jacobian(cutter.exact({0, 0, 0})).values.front().sign() > 0;
  });
  VT_CHECK(sum > 0, "plain numbers are positive, too");
  print_row(name + "_vs_plain", ours, plain, "ns");
  print_row(name + "_exact", exact, 0, "ns");
}

// Everything that a cell costs beside reading it.
void measure_beside_gmsh(const std::string& name, int n) {
  const auto cells = v_cells::grid(n, {3, 3, 3}, distorted);
  const ScopedDefaultFp nearest;
  bool is_positive = true;
  const double ours = least_ns(5, 1, [&] {
    for (const VVolume& cell : cells) {
      std::array<std::vector<Rational>, 3> breaks;
      for (std::size_t a = 0; a < 3; ++a) breaks[a] = internal::breaks_of(cell.axis(a));
      const PieceCutter cutter(cell, breaks);
      is_positive = is_positive && rounded_jacobian(cutter.rounded({0, 0, 0})).is_positive(1);
    }
  });
  VT_CHECK(is_positive, "no cell is folded");
  double peer = 0;
#ifdef VERITOPE_BENCH_GMSH
  std::vector<TricubicNodes> nodes(cells.size());
  for (std::size_t c = 0; c < cells.size(); ++c) {
    const BezierVolume<Rational> map = bezier_pieces(cells[c]).pieces.front();
    for (std::size_t i = 0; i < 64; ++i) {
      const auto at = evaluate<Rational, 3>(
          map, {Rational(i / 16) / Rational(3), Rational(i / 4 % 4) / Rational(3),
                Rational(i % 4) / Rational(3)});
      for (std::size_t k = 0; k < 3; ++k) nodes[c][i][k] = nearest_double(at[k]);
    }
  }
  peer = gmsh_quality_ns(nodes, 5);
#else
  std::fprintf(stderr, "%s: this program was built without Gmsh (libgmsh-dev)\n", name.c_str());
#endif
  print_row(name, ours / static_cast<double>(cells.size()), peer, "ns");
}

void measure_grid(const std::string& name, int n, int degree, int rounds) {
  const auto cells = v_cells::grid(n, {degree, degree, degree}, distorted);
  double gluing = 1e300, deciding = 1e300;
  for (int round = 0; round < rounds; ++round) {
    auto copy = cells;
    Stopwatch watch;
    const VModel model = make_v_model(std::move(copy), VOrientation::kKeep).value();
    gluing = std::min(gluing, watch.ns());
    const auto cube = static_cast<std::uint64_t>(n) * static_cast<std::uint64_t>(n);
    VT_CHECK(model.counts().internal == 3 * cube * static_cast<std::uint64_t>(n - 1),
             "all inner faces are glued");
    watch = Stopwatch();
    const VDeterminants d = decide_determinants(model);
    deciding = std::min(deciding, watch.ns());
    VT_CHECK(d.is_proved(), "no cell is folded");
  }
  const std::string cells_text = name + "_" + std::to_string(cells.size());
  print_row("gluing_" + cells_text, gluing * 1e-9, 0, "s");
  print_row("determinants_" + cells_text, deciding * 1e-9, 0, "s");
}

// One cell of n x n x n knot spans.
void measure_spans(const std::string& name, std::size_t n, int degree) {
  std::array<KnotAxis<Rational>, 3> axes;
  for (auto& axis : axes) {
    axis.degree = degree;
    axis.knots.assign(static_cast<std::size_t>(degree), Rational(0));
    for (std::size_t i = 0; i <= n; ++i) axis.knots.emplace_back(i);
    axis.knots.insert(axis.knots.end(), static_cast<std::size_t>(degree), Rational(n));
  }
  const std::size_t size = n + static_cast<std::size_t>(degree);
  const Grid<3> grid{{size, size, size}};
  std::vector<Rational> values(3 * grid.count());
  for (std::size_t i = 0; i < grid.count(); ++i) {
    const auto at = grid.index_of(i);
    const v_cells::Point p = distorted({Rational(at[0]), Rational(at[1]), Rational(at[2])});
    for (std::size_t c = 0; c < 3; ++c) values[c * grid.count() + i] = p[c];
  }
  const std::vector<VVolume> cells{VVolume(axes, 3, false, std::move(values))};
  Stopwatch watch;
  const VModel model = make_v_model(cells, VOrientation::kKeep).value();
  const double making = watch.ns();
  watch = Stopwatch();
  const VDeterminants d = decide_determinants(model);
  const double deciding = watch.ns();
  VT_CHECK(d.is_proved(), "the cell is not folded");
  const std::string text = name + "_of_" + std::to_string(model.num_pieces()) + "_pieces";
  print_row("making_" + text, making * 1e-9, 0, "s");
  print_row("determinants_" + text, deciding * 1e-9, 0, "s");
}

}  // namespace

int main() {
  const auto tricubic = v_cells::grid(1, {3, 3, 3}, distorted);
  measure_piece("jacobian_tricubic", tricubic[0]);
  measure_piece("jacobian_tricubic_rational", v_cells::with_factor(tricubic[0], Rational(3)));
  measure_piece("jacobian_trilinear", v_cells::grid(1, {1, 1, 1}, distorted)[0]);
  measure_beside_gmsh("jacobian_tricubic_vs_gmsh", 8);
  measure_grid("trilinear", 22, 1, 3);
  measure_grid("trilinear", 46, 1, 2);
  measure_grid("tricubic", 22, 3, 2);
  measure_spans("tricubic_cell", 22, 3);
}
