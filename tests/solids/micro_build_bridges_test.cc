// SPDX-License-Identifier: LGPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "robust/base/random.h"
#include "solids/classify/mesh_classifier.h"
#include "solids/classify/mesh_projection.h"
#include "solids/micro/bridge/bridge_proof.h"
#include "solids/micro/bridge/build_bridges.h"
#include "solids/micro/fill_cage.h"
#include "solids/micro/mesh/micro_mesh.h"
#include "solids/micro/micro_topology.h"
#include "solids/polyhedron/validity.h"
#include "splines/de_boor.h"
#include "splines/de_casteljau.h"
#include "tests/support/approx_distance.h"
#include "tests/support/micro_lattice.h"

namespace veritope {
namespace {

using micro_lattice::cage_volume;
using micro_lattice::creased;
using micro_lattice::Lattice;

std::uint64_t sum_of(const BridgeReport& r) {
  std::uint64_t out = r.built;
  for (const std::uint64_t n : r.dropped) out += n;
  return out;
}

// Everything that is claimed of a bridge, at points of it, in fractions.
void expect_sound(const Lattice& lattice, const BridgeReport& report, double skin) {
  const MeshClassifier classifier = std::move(MeshClassifier::make(lattice.solid).value());
  const MeshProjection projection(lattice.solid);
  const Rational most = Rational::from_double(skin) * Rational::from_double(skin),
                 reach = Rational::from_double(report.reach.hi);
  const VVolume& volume = lattice.micro.cage[0];
  for (const MicroBridge& b : lattice.micro.bridges) {
    BezierVolume<Rational> map({b.degrees[0], b.degrees[1], 2}, 3, false);
    for (std::size_t i = 0; i < b.points.size(); ++i)
      for (std::size_t c = 0; c < 3; ++c) map.component(static_cast<int>(c))[i] = b.points[i][c];
    for (int n = 0; n < 27; ++n) {
      const auto t = [](int k) { return Rational(k) / Rational(2); };
      const auto p = evaluate<Rational, 3>(map, {t(n % 3), t(n / 3 % 3), t(n / 9)});
      const auto x = point(volume, {p[0], p[1], p[2]}).value();
      const PointAnswer answer = classifier.classify(ExactPoint{x[0], x[1], x[2]});
      EXPECT_EQ(answer.winding, 1);
      if (n / 9 != 2) continue;
      const Rational d = projection.project({x[0], x[1], x[2]}).squared_distance;
      EXPECT_LE(d, most);
      EXPECT_LE(d, reach * reach);
    }
  }
}

// The second list is the first one, moved along the axis across the wall: so the derivative along the third axis at the
// cap is one vector along that axis, and the bridge continues the tile with its tangent planes wherever the map of the
// volume has continuous ones.
void expect_smooth_starts(const Lattice& lattice) {
  for (const MicroBridge& b : lattice.micro.bridges) {
    const auto axis = static_cast<std::size_t>(b.cap.wall / 2);
    std::optional<Rational> mu;
    for (int i = 0; i <= b.degrees[0]; ++i)
      for (int j = 0; j <= b.degrees[1]; ++j)
        for (std::size_t c = 0; c < 3; ++c) {
          const Rational d = b.points[b.at(i, j, 1)][c] - b.points[b.at(i, j, 0)][c];
          if (c != axis) {
            EXPECT_EQ(d, Rational(0));
            continue;
          }
          if (!mu) mu = d;
          EXPECT_EQ(d, *mu);
        }
    EXPECT_EQ(mu->sign(), b.cap.wall % 2 == 1 ? Sign::kPositive : Sign::kNegative);
  }
}

Rational tenths(int n) { return Rational(n) / Rational(10); }

TEST(BuildBridges, CapsOfABlockInABlock) {
  Lattice lattice(6, cage_volume(0, false), tenths(1), tenths(9));
  const BridgeReport report = lattice.build();
  // 4 x 4 x 4 tiles are kept.
  EXPECT_EQ(report.caps, 96u);
  EXPECT_EQ(report.built, 96u);
  EXPECT_EQ(lattice.micro.bridges.size(), 96u);
  EXPECT_EQ(report.kink.hi, 0);
  EXPECT_GT(report.reach.lo, 0);
  EXPECT_LE(report.reach.hi, 0.02);
  EXPECT_TRUE(validate(lattice.micro).has_value());
  EXPECT_TRUE(std::holds_alternative<std::vector<BridgeWitness>>(
      prove_bridges(lattice.micro, lattice.cage, lattice.tiles)));
  expect_sound(lattice, report, 0.02);
  expect_smooth_starts(lattice);
}

TEST(BuildBridges, InABentCageAcrossAKnot) {
  Lattice lattice(7, cage_volume(1, true), tenths(2), tenths(8));
  const BridgeReport report = lattice.build();
  EXPECT_GT(report.caps, 40u);
  EXPECT_GE(report.built * 20, report.caps * 17);
  EXPECT_EQ(sum_of(report), report.caps);
  EXPECT_EQ(report.kink.hi, 0);
  EXPECT_TRUE(std::holds_alternative<std::vector<BridgeWitness>>(
      prove_bridges(lattice.micro, lattice.cage, lattice.tiles)));
  expect_sound(lattice, report, 0.02);
  expect_smooth_starts(lattice);
}

TEST(BuildBridges, IsTheSameForEveryNumberOfJobs) {
  std::vector<MicroBridge> first;
  for (const unsigned jobs : {1u, 2u, 5u}) {
    Lattice lattice(6, cage_volume(1, false), tenths(2), tenths(8));
    lattice.build(0.02, jobs);
    if (jobs == 1)
      first = lattice.micro.bridges;
    else
      EXPECT_EQ(lattice.micro.bridges, first) << jobs << " jobs";
  }
}

TEST(BuildBridges, ANeighbourNeedsNoBridge) {
  Lattice lattice(6, cage_volume(0, false), tenths(1), tenths(9));
  const BridgeReport report = lattice.build();
  const auto met = walls_with_neighbours(lattice.micro, lattice.cage).value();
  for (const MicroBridge& b : lattice.micro.bridges)
    EXPECT_EQ(met[0][b.cap.cell] >> b.cap.wall & 1, 0);
  EXPECT_EQ(report.without.size(), 0u);
}

TEST(BuildBridges, CapsThatNearlyTouchTheSurfaceAreFlat) {
  // The block ends 1/1000 of a cell beyond the walls of its tiles.
  const Rational beyond = Rational(1) / Rational(6000);
  Lattice lattice(6, cage_volume(0, false), Rational(1) / Rational(6) - beyond,
                  Rational(5) / Rational(6) + beyond);
  const BridgeReport report = lattice.build();
  EXPECT_EQ(report.caps, 96u);
  EXPECT_EQ(report.dropped[static_cast<std::size_t>(BridgeDrop::kFlat)], 96u);
  EXPECT_EQ(report.without.size(), 96u);
  EXPECT_TRUE(lattice.micro.bridges.empty());
}

TEST(BuildBridges, AKinkIsEnclosedAtACrease) {
  Lattice lattice = creased(5, 0.55);
  const BridgeReport report = lattice.build();
  EXPECT_GT(report.built, 0u);
  EXPECT_EQ(report.kink.lo, 0);
  EXPECT_LE(report.kink.hi, 26.6);
  EXPECT_GE(report.kink.hi, 26.56);
}

TEST(BuildBridges, MeshesAreAtTheProvedDistance) {
  Random random(5);
  for (const bool has_crease : {false, true}) {
    // With a crease, bridges along u pass it.
    Lattice lattice =
        has_crease ? creased(4, 0.57) : Lattice(6, cage_volume(1, true), tenths(2), tenths(8));
    ASSERT_GT(lattice.build().built, 20u);
    for (const double chord : {0.02, 0.004}) {
      MicroMeshOptions options;
      options.chord = chord;
      const MicroMesh mesh = mesh_of(lattice.micro, lattice.cage, lattice.tiles, options).value();
      EXPECT_LE(mesh.distance, chord);
      for (const MicroBridge& b : lattice.micro.bridges) {
        BezierVolume<Rational> map({b.degrees[0], b.degrees[1], 2}, 3, false);
        for (std::size_t i = 0; i < b.points.size(); ++i)
          for (std::size_t c = 0; c < 3; ++c)
            map.component(static_cast<int>(c))[i] = b.points[i][c];
        // A point of a side, or of the end face.
        std::array<Rational, 3> at;
        for (Rational& t : at) t = Rational(random.between(0, 97)) / Rational(97);
        const auto side = random.below(5);
        at[side / 2] = Rational(side == 4 ? 1 : side % 2);
        const auto p = evaluate<Rational, 3>(map, at);
        const auto x = point(lattice.micro.cage[0], {p[0], p[1], p[2]}).value();
        EXPECT_LE(
            approx::distance_to_mesh(
                {nearest_double(x[0]), nearest_double(x[1]), nearest_double(x[2])}, mesh.mesh),
            mesh.distance + 1e-12)
            << "seed 5, chord " << chord;
      }
    }
  }
}

TEST(BuildBridges, MeshesAreSolidsWithTheNumbersOfTheTiles) {
  for (const bool is_bent : {false, true}) {
    Lattice lattice(6, cage_volume(is_bent ? 1 : 0, is_bent), tenths(2), tenths(8));
    const BridgeReport report = lattice.build();
    ASSERT_GT(report.built, 0u);
    const auto counts =
        std::get<MicroCounts>(topology_of(lattice.micro, lattice.cage, lattice.tiles));
    for (const double chord : {0.05, 0.005}) {
      MicroMeshOptions options;
      options.chord = chord;
      const MicroMesh mesh = mesh_of(lattice.micro, lattice.cage, lattice.tiles, options).value();
      EXPECT_LE(mesh.distance, chord);
      const ValidityReport found = decide_validity(mesh.mesh, {});
      EXPECT_TRUE(found.is_valid) << chord;
      EXPECT_EQ(found.counts.shells, counts.shells);
      EXPECT_EQ(found.counts.genus, counts.genus);
      options.jobs = 3;
      EXPECT_EQ(mesh_of(lattice.micro, lattice.cage, lattice.tiles, options)->mesh.faces,
                mesh.mesh.faces);
    }
  }
}

TEST(BuildBridges, ComponentsThatNoBridgeHoldsAreRemoved) {
  Lattice lattice(6, cage_volume(0, false), tenths(1), tenths(9));
  lattice.build();
  const std::vector<MicroBridge> bridges = lattice.micro.bridges;
  lattice.micro.bridges = {bridges.front()};
  MicroGrid& grid = lattice.micro.grids[0];
  std::fill(grid.tiles.begin(), grid.tiles.end(), std::uint8_t{0});
  const std::size_t held = bridges.front().cap.cell;
  grid.tiles[held] = grid.tiles[held + 43 + 43] = 1;
  const auto floating =
      std::get<0>(keep_bridged_components(lattice.cage, lattice.tiles, lattice.micro));
  EXPECT_EQ(floating[0], std::vector<std::uint64_t>{held + 86});
  EXPECT_EQ(std::count(grid.tiles.begin(), grid.tiles.end(), 1), 1);
}

}  // namespace
}  // namespace veritope
