// SPDX-License-Identifier: LGPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <string>

#include "solids/classify/mesh_classifier.h"
#include "solids/classify/mesh_projection.h"
#include "solids/micro/bridge/build_sweeps.h"
#include "solids/micro/bridge/sweep_proof.h"
#include "solids/micro/micro_topology.h"
#include "splines/de_boor.h"
#include "splines/de_casteljau.h"
#include "tests/support/micro_lattice.h"

namespace veritope {
namespace {

using micro_lattice::cage_volume;
using micro_lattice::Lattice;

Rational tenths(int n) { return Rational(n) / Rational(10); }

std::uint64_t sum_of(const BridgeReport& r) {
  std::uint64_t out = r.built;
  for (const std::uint64_t n : r.dropped) out += n;
  return out;
}

// The point (u, v, w) of a sweep, in fractions.
TilePoint point_of(const Lattice& lattice, const MicroSweep& sweep,
                   const std::array<Rational, 3>& at) {
  const MicroGrid& grid = lattice.micro.grids[sweep.cap.grid];
  const AnalysedTile& tile = lattice.tiles[0];
  const auto& caps = tile.caps_of_wall[static_cast<std::size_t>(sweep.cap.wall)];
  const TilePatch& patch = tile.tile.patches[tile.caps[caps[0]].patches[0]];
  BezierSurface<Rational> map(patch.degrees, 3, false);
  for (std::size_t i = 0; i < patch.points[0].size(); ++i)
    for (std::size_t c = 0; c < 3; ++c)
      map.component(static_cast<int>(c))[i] = patch.points[0][i][c];
  const auto p = evaluate<Rational, 2>(map, {at[0], at[1]});
  const auto cell = grid.shape().index_of(sweep.cap.cell);
  std::array<Rational, 3> x;
  for (std::size_t a = 0; a < 3; ++a) {
    const Rational& lo = grid.breaks[a][cell[a]];
    x[a] = lo + (grid.breaks[a][cell[a] + 1] - lo) * p[a];
  }
  const auto image = point(lattice.micro.cage[grid.volume], x).value();
  const Rational &w = at[2], two(2);
  TilePoint out;
  for (std::size_t c = 0; c < 3; ++c)
    out[c] = image[c] + two * w * (Rational(1) - w) * sweep.axis[0][c] + w * w * sweep.axis[1][c];
  return out;
}

// Everything that is claimed of a sweep, at points of it, in fractions.
void expect_sound(const Lattice& lattice, const BridgeReport& report, double skin) {
  const MeshClassifier classifier = std::move(MeshClassifier::make(lattice.solid).value());
  const MeshProjection projection(lattice.solid);
  const Rational most = Rational::from_double(skin) * Rational::from_double(skin),
                 reach = Rational::from_double(report.reach.hi);
  for (const MicroSweep& s : lattice.micro.sweeps)
    for (int n = 0; n < 27; ++n) {
      const auto t = [](int k) { return Rational(k) / Rational(2); };
      const TilePoint x = point_of(lattice, s, {t(n % 3), t(n / 3 % 3), t(n / 9)});
      EXPECT_EQ(classifier.classify(ExactPoint{x[0], x[1], x[2]}).winding, 1);
      if (n / 9 != 2) continue;
      const Rational d = projection.project({x[0], x[1], x[2]}).squared_distance;
      EXPECT_LE(d, most);
      EXPECT_LE(d, reach * reach);
    }
}

TEST(BuildSweeps, CapsOfABlockInABlock) {
  Lattice lattice(6, cage_volume(0, false), tenths(1), tenths(9));
  const BridgeReport report = lattice.sweep();
  // 4 x 4 x 4 tiles are kept.
  EXPECT_EQ(report.caps, 96u);
  EXPECT_EQ(report.built, 96u);
  EXPECT_EQ(lattice.micro.sweeps.size(), 96u);
  EXPECT_LE(report.kink.hi, 1e-4);
  EXPECT_GT(report.reach.lo, 0);
  EXPECT_LE(report.reach.hi, 0.02);
  EXPECT_TRUE(validate(lattice.micro).has_value());
  expect_sound(lattice, report, 0.02);
  EXPECT_EQ(lattice.defect_of_sweeps(), "");
}

TEST(BuildSweeps, InABentCageAcrossAKnot) {
  Lattice lattice(7, cage_volume(1, true), tenths(2), tenths(8));
  const BridgeReport report = lattice.sweep();
  EXPECT_GT(report.caps, 40u);
  EXPECT_GE(report.built * 20, report.caps * 17);
  EXPECT_EQ(sum_of(report), report.caps);
  EXPECT_EQ(lattice.defect_of_sweeps(), "");
  expect_sound(lattice, report, 0.02);
}

TEST(BuildSweeps, IsTheSameForEveryNumberOfJobs) {
  std::vector<MicroSweep> first;
  for (const unsigned jobs : {1u, 2u, 5u}) {
    Lattice lattice(6, cage_volume(1, false), tenths(2), tenths(8));
    lattice.sweep(0.02, jobs);
    if (jobs == 1)
      first = lattice.micro.sweeps;
    else
      EXPECT_EQ(lattice.micro.sweeps, first) << jobs << " jobs";
  }
}

TEST(BuildSweeps, CapsThatNearlyTouchTheSurfaceAreFlat) {
  // The block ends 1/1000 of a cell beyond the walls of its tiles.
  const Rational beyond = Rational(1) / Rational(6000);
  Lattice lattice(6, cage_volume(0, false), Rational(1) / Rational(6) - beyond,
                  Rational(5) / Rational(6) + beyond);
  const BridgeReport report = lattice.sweep();
  EXPECT_EQ(report.caps, 96u);
  EXPECT_EQ(report.dropped[static_cast<std::size_t>(BridgeDrop::kFlat)], 96u);
  EXPECT_EQ(report.without.size(), 96u);
  EXPECT_TRUE(lattice.micro.sweeps.empty());
}

// T = (u + w/2, v, w) on [-1, 1] x [0, 1] x [0, 1]: the cage's lines across the walls of u and w meet them at
// 90 - 26.565 degrees, and sweeps begin along the normal.
TEST(BuildSweeps, TheKinkOfAShearedCageIsEnclosed) {
  const VVolume sheared =
      v_cells::polynomial({1, 1, 1}, [](std::size_t i, std::size_t j, std::size_t k) {
        return v_cells::Point{Rational(3 * static_cast<int>(i) - 1) + Rational(k) / Rational(2),
                              Rational(j), Rational(k)};
      });
  Lattice lattice(8, sheared, tenths(1), tenths(9));
  const BridgeReport report = lattice.sweep();
  EXPECT_GT(report.built, 20u);
  const double angle = std::atan(0.5) * 180 / std::acos(-1.0);
  EXPECT_GE(report.kink.hi, angle - 1e-5);
  EXPECT_LE(report.kink.hi, angle + 1e-5);
  EXPECT_LE(report.kink.lo, 1e-4);  // at the walls of v
  EXPECT_EQ(lattice.defect_of_sweeps(), "");
}

}  // namespace
}  // namespace veritope
