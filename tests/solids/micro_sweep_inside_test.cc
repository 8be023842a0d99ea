// SPDX-License-Identifier: LGPL-3.0-or-later
// Sweeps inside of solids, in meshes and in composed surfaces.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "interval/upward.h"
#include "solids/micro/compose/composed_surface.h"
#include "solids/micro/measure/micro_volume.h"
#include "solids/micro/mesh/micro_mesh.h"
#include "solids/micro/sweep_nodes.h"
#include "solids/micro/sweep_start.h"
#include "solids/polyhedron/validity.h"
#include "splines/de_boor.h"
#include "splines/de_casteljau.h"
#include "tests/support/approx_distance.h"
#include "tests/support/micro_inside.h"
#include "tests/support/micro_lattice.h"
#include "tests/support/shapes.h"

namespace veritope {
namespace {

using micro_cells::box_tile;
using micro_cells::full;
using micro_inside::answer;
using micro_inside::condition_of;
using v_cells::cube;

Rational part(std::int64_t p, std::int64_t q) { return Rational(p) / Rational(q); }

// A post in the first of two cells of the unit cube, with a cap [1/4, 3/4]^2 at u = 1/2, and a sweep from it to u = 7/8.
Microstructure swept(const Rational& aside = {}) {
  Microstructure micro = full({cube(0, 0, 0)}, {2, 1, 1}, box_tile({16, 16, 16}, {64, 48, 48}));
  micro.grids[0].tiles[1] = 0;
  micro.sweeps.push_back(
      {{0, 0, 1},
       {TilePoint{part(3, 16), Rational(0), Rational(0)}, {part(3, 8), aside, Rational(0)}}});
  return micro;
}

// The volume with weights that vary by a third.
VVolume with_weights(const VVolume& volume) {
  const Grid<3> grid = volume.grid();
  std::vector<Rational> c;
  const auto weight = [&](std::size_t i) {
    const auto at = grid.index_of(i);
    return part(6 + static_cast<std::int64_t>((at[0] + 2 * at[1] + at[2]) % 3), 8);
  };
  for (int k = 0; k < 3; ++k)
    for (std::size_t i = 0; i < grid.count(); ++i) c.push_back(weight(i) * volume.component(k)[i]);
  for (std::size_t i = 0; i < grid.count(); ++i) c.push_back(weight(i));
  return VVolume({volume.axis(0), volume.axis(1), volume.axis(2)}, 4, true, std::move(c));
}

// PROVES MICRO-2.I1
TEST(SweepsInside, MissTheSurface) {
  const Microstructure micro = swept();
  EXPECT_EQ(condition_of(answer(micro, shapes::box({-1, -1, -1}, {0.876, 2, 2}))), "");
  EXPECT_EQ(condition_of(answer(micro, shapes::box({-1, -1, -1}, {0.875, 2, 2}))), "I1");
  EXPECT_EQ(condition_of(answer(micro, shapes::box({-1, -1, -1}, {0.86, 2, 2}))), "I1");
  // A void that the sweep contains.
  TriangleMesh bubble = shapes::box({-1, -1, -1}, {2, 2, 2});
  TriangleMesh inner = shapes::box({0.6, 0.4, 0.4}, {0.7, 0.6, 0.6});
  const auto first = static_cast<std::uint32_t>(bubble.positions.size());
  for (const Vec3d& p : inner.positions) bubble.positions.push_back(p);
  for (auto t : inner.faces) bubble.faces.push_back({t[0] + first, t[2] + first, t[1] + first});
  EXPECT_EQ(condition_of(answer(micro, bubble)), "I1");
}

// PROVES MICRO-2.I3
TEST(SweepsInside, PointsOfVoidsLieInNoSweep) {
  // The sweep bends aside; the box around its points holds a part of the void, which lies beyond the bend.
  const Microstructure micro = swept(part(1, 2));
  TriangleMesh solid = shapes::box({-1, -1, -1}, {2, 2, 2});
  const TriangleMesh inner = shapes::box({0.75, 0.3, 0.3}, {0.95, 0.4, 0.7});
  const auto first = static_cast<std::uint32_t>(solid.positions.size());
  for (const Vec3d& p : inner.positions) solid.positions.push_back(p);
  for (auto t : inner.faces) solid.faces.push_back({t[0] + first, t[2] + first, t[1] + first});
  const auto got = answer(micro, solid);
  ASSERT_EQ(condition_of(got), "");
  const auto& voids = std::get<InsideProof>(got).voids;
  ASSERT_EQ(voids.size(), 1u);
  EXPECT_GT(voids[0].x[0], part(7, 8));  // of the unit cube, which is its own image
}

// PROVES MICRO-2.I4
TEST(SweepsInside, TheSkinIsNearlyTheGreatestDistanceOfAnEnd) {
  for (const double gap : {0x1p-30, 0.01, 0.125, 0.75}) {
    const auto got = answer(swept(), shapes::box({-4, -4, -4}, {0.875 + gap, 12, 4}));
    ASSERT_EQ(condition_of(got), "") << gap;
    const Rational skin = *std::get<InsideProof>(got).skin, truth = Rational::from_double(gap);
    EXPECT_GT(skin, truth) << gap;
    EXPECT_LT(skin, truth * part(65, 64)) << gap;
  }
}

TEST(SweepsInside, WhatIsBuiltIsInside) {
  micro_lattice::Lattice lattice(6, micro_lattice::cage_volume(1, false), part(2, 10), part(8, 10));
  ASSERT_GT(lattice.sweep().built, 10u);
  const auto got = answer(lattice.micro, lattice.solid);
  ASSERT_EQ(condition_of(got), "");
  EXPECT_LE(*std::get<InsideProof>(got).skin, part(21, 1000));
}

TEST(SweepMeshes, AreSolidsAtTheProvedDistance) {
  for (const bool is_bent : {false, true}) {
    micro_lattice::Lattice lattice(6, micro_lattice::cage_volume(is_bent ? 1 : 0, is_bent),
                                   part(2, 10), part(8, 10));
    ASSERT_GT(lattice.sweep().built, 10u);
    const auto counts =
        std::get<MicroCounts>(topology_of(lattice.micro, lattice.cage, lattice.tiles));
    EXPECT_EQ(counts.bridges, lattice.micro.sweeps.size());
    const SweepStarts starts(lattice.micro, lattice.tiles);
    for (const double chord : {0.02, 0.004}) {
      MicroMeshOptions options;
      options.chord = chord;
      const MicroMesh mesh = mesh_of(lattice.micro, lattice.cage, lattice.tiles, options).value();
      EXPECT_LE(mesh.distance, chord);
      const ValidityReport found = decide_validity(mesh.mesh, {});
      EXPECT_TRUE(found.is_valid) << chord;
      EXPECT_EQ(found.counts.shells, counts.shells);
      EXPECT_EQ(found.counts.genus, counts.genus);
      const ScopedUpward upward;
      for (const MicroSweep& s : lattice.micro.sweeps) {
        // A point of a side.
        const auto cap = starts.cap(s.cap).value();
        const auto p = evaluate<Rational, 2>(cap, {Rational(0), part(1, 3)});
        const auto image =
            evaluate<Interval, 2>(starts.wall(s.cap), {enclose(p[0]), enclose(p[1])});
        std::array<double, 3> x;
        for (std::size_t c = 0; c < 3; ++c)
          x[c] = mid(image[c]) + nearest_double(part(12, 25) * s.axis[0][c] +
                                                part(4, 25) * s.axis[1][c]);  // w = 2/5
        EXPECT_LE(approx::distance_to_mesh({x[0], x[1], x[2]}, mesh.mesh), mesh.distance + 1e-12);
      }
    }
  }
}

// A cap of a quarter is moved by 3/8 along its normal, whatever the curve is; other volumes are those of meshes.
TEST(SweepVolumes, AreEnclosed) {
  for (const Rational& aside : {Rational(0), part(1, 2)}) {
    const Microstructure micro = swept(aside);
    const VModel cage = make_v_model(micro.cage, VOrientation::kAuto).value();
    const MicroVolume v = volume_of(micro, cage, 2).value();
    EXPECT_LE(v.bridges.lo(), 3.0 / 32);
    EXPECT_GE(v.bridges.hi(), 3.0 / 32);
    EXPECT_LE(v.bridges.hi() - v.bridges.lo(), 1e-14);
  }
  for (const bool is_rational : {false, true}) {
    VVolume volume = micro_lattice::cage_volume(1, true);
    if (is_rational) volume = with_weights(volume);
    micro_lattice::Lattice lattice(6, volume, part(2, 10), part(8, 10));
    Microstructure alone = lattice.micro;
    ASSERT_GT(lattice.sweep().built, 10u);
    MicroMeshOptions options;
    options.chord = 0.004;
    const auto size = [&](const Microstructure& micro) {
      double sum = 0;
      const MicroMesh mesh = mesh_of(micro, lattice.cage, lattice.tiles, options).value();
      for (const auto& t : mesh.mesh.faces) {
        const Vec3d &a = mesh.mesh.positions[t[0]], &b = mesh.mesh.positions[t[1]],
                    &c = mesh.mesh.positions[t[2]];
        sum += a.x * (b.y * c.z - b.z * c.y) - a.y * (b.x * c.z - b.z * c.x) +
               a.z * (b.x * c.y - b.y * c.x);
      }
      return sum / 6;
    };
    const double truth = size(lattice.micro) - size(alone);
    const MicroVolume v = volume_of(lattice.micro, lattice.cage, 1).value();
    EXPECT_LE(v.bridges.hi() - v.bridges.lo(), 1e-9 * truth);
    EXPECT_NEAR(v.bridges.lo(), truth, 0.01 * truth) << is_rational;
    EXPECT_EQ(volume_of(lattice.micro, lattice.cage, 3)->bridges, v.bridges);
    EXPECT_EQ(volume_of(alone, lattice.cage, 1)->tiles, v.tiles);
  }
}

// The faces of a sweep are those of the map, exactly, and turn outward.
TEST(SweepsComposed, FacesAreExact) {
  const Microstructure micro = swept(part(1, 4));
  const VModel cage = make_v_model(micro.cage, VOrientation::kAuto).value();
  std::vector<AnalysedTile> tiles = {std::get<AnalysedTile>(analyse_tile(micro.tiles[0]))};
  const ComposedSurface surface = ComposedSurface::make(micro, cage, tiles).value();
  EXPECT_EQ(surface.num_patches(), 5u + 5u);
  const auto all = surface.compose(0, 1)[0];
  ASSERT_EQ(all.size(), 10u);
  std::uint64_t points = 0;
  for (const ComposedPatch& p : all) points += p.surface.grid().count();
  EXPECT_EQ(points, surface.num_points());
  std::size_t faces = 0;
  for (const ComposedPatch& p : all) {
    if (!p.bridge) continue;
    ++faces;
    const auto at = [&](const Rational& u, const Rational& v) {
      return evaluate<Rational, 2>(p.surface, {u, v});
    };
    const auto middle = at(part(1, 2), part(1, 2));
    if (p.patch == 4) {
      EXPECT_EQ(middle, (std::vector<Rational>{part(7, 8), part(3, 4), part(1, 2)}));
    } else {
      // Halfway along the curve: the middle of the cap plus e / 2 + f / 4.
      EXPECT_EQ(middle[0], part(1, 2) + part(3, 32) + part(3, 32));
    }
    // The normal at the middle leads away from the curve.
    const Rational step = part(1, 1024);
    const auto pu = at(part(1, 2) + step, part(1, 2)), pv = at(part(1, 2), part(1, 2) + step);
    std::array<Rational, 3> n, a, b;
    for (std::size_t c = 0; c < 3; ++c) {
      a[c] = pu[c] - middle[c];
      b[c] = pv[c] - middle[c];
    }
    for (std::size_t c = 0; c < 3; ++c)
      n[c] = a[(c + 1) % 3] * b[(c + 2) % 3] - a[(c + 2) % 3] * b[(c + 1) % 3];
    const Rational w = p.patch == 4 ? Rational(1) : part(1, 2);
    const std::array<Rational, 3> core = {part(1, 2) + part(3, 8) * w,
                                          part(1, 2) + part(1, 4) * w * w, part(1, 2)};
    Rational out;
    for (std::size_t c = 0; c < 3; ++c) out += n[c] * (middle[c] - core[c]);
    if (p.patch == 4)
      EXPECT_EQ(n[0].sign(), Sign::kPositive);
    else
      EXPECT_EQ(out.sign(), Sign::kPositive) << p.patch;
  }
  EXPECT_EQ(faces, 5u);
}

}  // namespace
}  // namespace veritope
