// SPDX-License-Identifier: LGPL-3.0-or-later
// Bridges that lead to the surface of a solid of patches.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "models/patch_shapes.h"
#include "models/round_parts.h"
#include "solids/classify/patch_classifier.h"
#include "solids/classify/patch_projection.h"
#include "solids/micro/bridge/bridge_proof.h"
#include "solids/micro/bridge/build_bridges.h"
#include "solids/micro/synthesis/filter_tiles.h"
#include "splines/de_boor.h"
#include "splines/de_casteljau.h"
#include "tests/solids/patch_support.h"
#include "tests/support/micro_cells.h"
#include "tests/support/micro_inside.h"
#include "tests/support/shapes.h"

namespace veritope {
namespace {

using v_cells::Point;

Rational part(std::int64_t p, std::int64_t q) { return Rational(p) / Rational(q); }

// A cube [lo, hi]^3 of degree 2 along each axis, whose inner control points are moved by `bend` eighths.
VVolume around(const Rational& lo, const Rational& hi, int bend) {
  return v_cells::polynomial({2, 2, 2}, [&](std::size_t i, std::size_t j, std::size_t k) {
    const auto at = [&](std::size_t n) { return lo + (hi - lo) * part(static_cast<int>(n), 2); };
    const Rational off = j == 1 ? part(bend, 8) : Rational(0);
    return Point{at(i) + off, at(j), at(k) + off};
  });
}

struct PatchLattice {
  PatchComplex solid;
  Microstructure micro;
  VModel cage;
  std::vector<AnalysedTile> tiles;

  PatchLattice(Patches patches, std::uint64_t n, const VVolume& volume)
      : solid(complex_of(std::move(patches))),
        micro(micro_cells::full({volume}, {n, n, n}, jack_tile({}).value())),
        cage(make_v_model(micro.cage, VOrientation::kAuto).value()) {
    tiles.push_back(std::get<AnalysedTile>(analyse_tile(micro.tiles[0])));
    const TileFilter filter = TileFilter::make(solid);
    EXPECT_TRUE(filter_tiles_to(filter, 1, micro).has_value());
  }
  BridgeReport build(double skin, unsigned jobs = 1) {
    BridgeOptions options;
    options.skin = skin;
    options.jobs = jobs;
    return build_bridges(solid, cage, tiles, options, micro).value();
  }
};

// Points of each bridge, in fractions: in the interior; those of the end within the skin.
void expect_points_inside(const PatchLattice& lattice, const BridgeReport& report, double skin) {
  const PatchClassifier classifier = PatchClassifier::of_valid_model(lattice.solid);
  const PatchProjection projection(lattice.solid);
  for (const MicroBridge& b : lattice.micro.bridges) {
    BezierVolume<Rational> map({b.degrees[0], b.degrees[1], 2}, 3, false);
    for (std::size_t i = 0; i < b.points.size(); ++i)
      for (std::size_t c = 0; c < 3; ++c) map.component(static_cast<int>(c))[i] = b.points[i][c];
    for (int n = 0; n < 27; n += 2) {
      const auto t = [](int k) { return part(k, 2); };
      const auto p = evaluate<Rational, 3>(map, {t(n % 3), t(n / 3 % 3), t(n / 9)});
      const auto x = point(lattice.micro.cage[0], {p[0], p[1], p[2]}).value();
      const PointAnswer answer = classifier.classify(ExactPoint{x[0], x[1], x[2]});
      EXPECT_TRUE(answer.is_decided);
      EXPECT_EQ(answer.winding, 1);
      if (n / 9 != 2) continue;
      const Interval d = projection.project({x[0], x[1], x[2]}).squared_distance;
      EXPECT_LE(d.lo(), skin * skin);
      EXPECT_LE(d.lo(), report.reach.hi * report.reach.hi);
    }
  }
}

// All that certificates ask for: the bridges by themselves, and the whole inside of the solid with at most that skin.
void expect_proved(const PatchLattice& lattice, double skin) {
  EXPECT_TRUE(validate(lattice.micro).has_value());
  EXPECT_TRUE(std::holds_alternative<std::vector<BridgeWitness>>(
      prove_bridges(lattice.micro, lattice.cage, lattice.tiles)));
  const auto inside = micro_inside::answer(lattice.micro, lattice.solid);
  ASSERT_EQ(micro_inside::condition_of(inside), "") << std::get<InsideDefect>(inside).message;
  ASSERT_TRUE(std::get<InsideProof>(inside).skin.has_value());
  EXPECT_LE(*std::get<InsideProof>(inside).skin, Rational::from_double(skin));
}

TEST(BuildBridgesToPatches, CapsInABallReachIt) {
  for (const auto& [ball, bend] :
       {std::pair{patch_shapes::sphere(), 0}, std::pair{patch_shapes::octant_sphere(), 1}}) {
    PatchLattice lattice(ball, 8, around(part(-5, 4), part(5, 4), bend));
    const BridgeReport report = lattice.build(0.03);
    EXPECT_GT(report.caps, 60u);
    EXPECT_GE(report.built * 20, report.caps * 17);
    EXPECT_EQ(report.built, lattice.micro.bridges.size());
    EXPECT_EQ(report.built + report.without.size(), report.caps);
    EXPECT_GT(report.reach.lo, 0);
    EXPECT_LE(report.reach.hi, 0.03);
    EXPECT_EQ(report.kink.hi, 0);
    expect_proved(lattice, 0.03);
    expect_points_inside(lattice, report, 0.03);
  }
}

TEST(BuildBridgesToPatches, AVoidIsASkin) {
  PatchLattice lattice(patch_shapes::thin_shell(part(1, 2)), 14,
                       around(part(-5, 4), part(5, 4), 0));
  const BridgeReport report = lattice.build(0.03);
  EXPECT_GE(report.built * 4, report.caps * 3);
  expect_proved(lattice, 0.03);
  // Some lead to the void: their ends are nearer to the middle than all tiles.
  const auto leads_inward = [&](const MicroBridge& b) {
    Rational sum;
    for (const Rational& u : b.points[b.at(0, 0, 2)]) {
      const Rational x = part(5, 2) * u - part(5, 4);
      sum += x * x;
    }
    return sum < part(9, 16);
  };
  EXPECT_TRUE(std::ranges::any_of(lattice.micro.bridges, leads_inward));
  EXPECT_FALSE(std::ranges::all_of(lattice.micro.bridges, leads_inward));
}

TEST(BuildBridgesToPatches, EdgesAndNecksAreNoHindrance) {
  for (const auto& [solid, half] : {std::pair{patch_shapes::disc_cylinder(Rational(2)), 3},
                                    std::pair{patch_shapes::ball_with_neck(), 9}}) {
    PatchLattice lattice(solid, 9, around(Rational(-half), Rational(half), 0));
    const double skin = default_skin(lattice.solid);
    const BridgeReport report = lattice.build(skin);
    EXPECT_GE(report.built * 20, report.caps * 17);
    EXPECT_GT(report.caps, 8u);
    expect_proved(lattice, skin);
    expect_points_inside(lattice, report, skin);
  }
}

// A block as a mesh has the caps and as many bridges as the block of patches.
TEST(BuildBridgesToPatches, ABlockOfPatchesIsAsGoodAsOneOfTriangles) {
  PatchLattice patches(patch_shapes::box({0, 0, 0}, {1, 1, 1}), 6,
                       around(part(-1, 5), part(6, 5), 0));
  PatchLattice mesh = patches;
  const BridgeReport by_patches = patches.build(0.02);
  BridgeOptions options;
  options.skin = 0.02;
  const TriangleMesh block = shapes::box({0, 0, 0}, {1, 1, 1});
  const BridgeReport by_mesh =
      build_bridges(block, mesh.cage, mesh.tiles, options, mesh.micro).value();
  EXPECT_GT(by_mesh.built, 0u);
  EXPECT_EQ(by_patches.caps, by_mesh.caps);
  EXPECT_EQ(by_patches.built, by_mesh.built);
  expect_proved(patches, 0.02);
}

TEST(BuildBridgesToPatches, IsTheSameForEveryNumberOfJobs) {
  std::vector<MicroBridge> first;
  for (const unsigned jobs : {1u, 2u, 5u}) {
    PatchLattice lattice(patch_shapes::octant_sphere(), 6, around(part(-5, 4), part(5, 4), 1));
    lattice.build(0.03, jobs);
    if (jobs == 1)
      first = lattice.micro.bridges;
    else
      EXPECT_EQ(lattice.micro.bridges, first) << jobs << " jobs";
  }
  EXPECT_FALSE(first.empty());
}

TEST(BuildBridgesToPatches, CapsThatNearlyTouchTheSurfaceAreFlat) {
  // The block ends 1/1000 of a cell beyond the walls of its tiles.
  const Rational lo = part(1, 6) - part(1, 6000), hi = part(5, 6) + part(1, 6000);
  PatchLattice lattice(patch_shapes::box({lo, lo, lo}, {hi, hi, hi}), 6, around(0, 1, 0));
  const BridgeReport report = lattice.build(0.02);
  EXPECT_EQ(report.caps, 96u);
  EXPECT_EQ(report.dropped[static_cast<std::size_t>(BridgeDrop::kFlat)], 96u);
  EXPECT_TRUE(lattice.micro.bridges.empty());
}

TEST(BuildBridgesToPatches, TheDefaultSkinIsAHundredthOfTheDiagonal) {
  const PatchComplex box = complex_of(patch_shapes::box({0, 0, 0}, {2, 3, 6}));
  EXPECT_NEAR(default_skin(box), 0.07, 1e-12);
  // A ball of radius 1, whose control points lie around it.
  EXPECT_NEAR(default_skin(complex_of(patch_shapes::octant_sphere())), 0.0346410, 1e-4);
}

}  // namespace
}  // namespace veritope
