// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/polyhedron/volume.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/predicates/test_scale.h"
#include "tests/support/brute_force.h"
#include "tests/support/exact_geometry.h"
#include "tests/support/shapes.h"

namespace veritope {
namespace {

std::vector<Rational> one_shell(const TriangleMesh& mesh, unsigned jobs = 1) {
  return shell_volumes(mesh, std::vector<std::uint32_t>(mesh.faces.size(), 0), 1, jobs);
}

std::string spelled(const Rational& r) { return r.to_string(); }

// Against det(a, b, c) / 6 summed in rationals, shell by shell.
void expect_exact(const TriangleMesh& mesh, unsigned jobs = 1) {
  const auto topology = oracle::brute_topology(mesh.faces);
  ASSERT_TRUE(topology.is_cycle);
  std::vector<std::uint32_t> shell_of_face(mesh.faces.size(), 0xffffffffu);
  for (std::size_t s = 0; s < topology.shells.size(); ++s)
    for (std::uint32_t f : topology.shells[s]) shell_of_face[f] = static_cast<std::uint32_t>(s);
  const auto got = shell_volumes(mesh, shell_of_face, topology.shells.size(), jobs);
  ASSERT_EQ(got.size(), topology.shells.size());
  for (std::size_t s = 0; s < got.size(); ++s)
    EXPECT_EQ(spelled(got[s]), spelled(oracle::signed_volume(mesh, topology.shells[s]))) << "shell " << s << " of " << shapes::to_text(mesh);
}

// PROVES MESH-8
TEST(Volume, OfBoxesAndTetrahedra) {
  EXPECT_EQ(spelled(one_shell(shapes::box({0, 0, 0}, {1, 1, 1}))[0]), "1");
  EXPECT_EQ(spelled(one_shell(shapes::reversed(shapes::box({0, 0, 0}, {2, 3, 4})))[0]), "-24");
  EXPECT_EQ(spelled(one_shell(shapes::parse("tet 0,0,0 1,0,0 0,1,0 0,0,1"))[0]), "1/6");
  EXPECT_EQ(spelled(one_shell(shapes::box({-0.5, -0.25, 100}, {0.5, 0.25, 100.125}, 3))[0]), "1/16");
}

TEST(Volume, OfAPillowIsZero) {
  EXPECT_EQ(spelled(one_shell(shapes::parse("v 0,0,0 3,1,2 1,5,7 ; f 0,1,2 0,2,1"))[0]), "0");
  TriangleMesh zero = shapes::parse("v 0,0,0 ; f 0,0,0");
  EXPECT_EQ(spelled(one_shell(zero)[0]), "0");
}

// The lattice of all coordinates: 62 bits are summed in 64-bit numbers, 120 in 128-bit numbers, more in GMP.
TEST(Volume, IsExactOnBothSidesOfEveryLatticeLimit) {
  for (int bits : {1, 30, 52, 53, 59, 60, 61, 62, 63, 64, 65, 80, 117, 118, 119, 120, 121, 122, 127, 128, 129, 300, 2000})
    for (int unit : {-1074, -1001, -1000, -999, -60, 0, 40, 900}) {
      if (unit + bits > 1023) continue;
      const double big = std::ldexp(1.0, unit + bits - 1), small = std::ldexp(1.0, unit), most = std::nextafter(2 * big, 0);
      if (!std::isfinite(most)) continue;
      SCOPED_TRACE("unit 2^" + std::to_string(unit) + ", " + std::to_string(bits) + " bits");
      TriangleMesh m = shapes::parse("v 0,0,0 1,0,0 0,1,0 0,0,1 ; f 0,2,1 0,1,3 1,2,3 2,0,3");
      m.positions = {{-big, -big, -big}, {big, -big + small, small}, {small, big, -small}, {-small, -big, most}};
      expect_exact(m);
      if (HasFailure()) return;
    }
}

TEST(Volume, LongEdgesOnALongLatticeAreExact) {
  // Differences of 2^62 and more leave the 128-bit path.
  for (int e : {60, 61, 62, 63, 64, 65, 70, 100, 118}) {
    const double s = std::ldexp(1.0, e);
    TriangleMesh m = shapes::parse("v 0,0,0 1,0,0 0,1,0 0,0,1 ; f 0,2,1 0,1,3 1,2,3 2,0,3");
    m.positions = {{-s, -s, 1}, {s, -s, 3}, {1, s, -5}, {7, 11, s}};
    expect_exact(m);
    m.positions = {{-s, s, s}, {s, s, -s}, {s, -s, s}, {-s + 1024, -s, -s}};
    expect_exact(m);
  }
}

TEST(Volume, ExtremeCoordinatesAreExact) {
  constexpr double kMax = 0x1.fffffffffffffp1023, kTiny = 5e-324;
  TriangleMesh m = shapes::parse("v 0,0,0 1,0,0 0,1,0 0,0,1 ; f 0,2,1 0,1,3 1,2,3 2,0,3");
  m.positions = {{-kMax, -kMax, -kMax}, {kMax, kTiny, 0}, {kTiny, kMax, 1}, {0.1, -kTiny, kMax}};
  expect_exact(m);
  m.positions = {{0, 0, 0}, {kTiny, 0, 0}, {0, kTiny, 0}, {0, 0, kTiny}};
  expect_exact(m);
  m.positions = {{0, 0, 0}, {3 * kTiny, kTiny, 0}, {0, 5 * kTiny, 7 * kTiny}, {0, -kTiny, 1e-300}};
  expect_exact(m);
}

// PROVES MESH-8
TEST(VolumeLaw, IsExactOnRandomCyclesForEveryNumberOfJobs) {
  for (std::uint64_t seed = 1; seed <= static_cast<std::uint64_t>(scaled(25)); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    expect_exact(shapes::star_polyhedron(random, 2));
    expect_exact(shapes::random_polycube(random, 4, 20), 2);
    expect_exact(shapes::nested_scene(random, 12), 3);
    expect_exact(shapes::needles(random, 10));
    TriangleMesh torn = shapes::star_polyhedron(random, 1);  // a cycle that crosses itself anyhow
    for (Vec3d& p : torn.positions) {
      const auto c = [&] { return std::ldexp(2 * random.unit() - 1, static_cast<int>(random.between(-60, 60))); };
      const double x = c(), y = c(), z = c();
      p = {x, y, z};
    }
    expect_exact(torn);
    if (HasFailure()) return;
  }
}

TEST(VolumeLaw, ScalesExactly) {
  const TriangleMesh mesh = shapes::torus(9, 7, 3, 1);
  const Rational volume = one_shell(mesh)[0];
  for (int e : {-1000, -900, -300, -20, 20, 300, 900, 1000})
    EXPECT_EQ(one_shell(shapes::scaled(mesh, e))[0] == volume * Rational::power_of_two(3 * e), true) << e;
}

TEST(VolumeLaw, SumsOverManyFacetsAndShellsWithoutOverflow) {
  const TriangleMesh mesh = shapes::moved(shapes::box_grid(14, 0.5), {0x1p40, -0x1p40, 0x1p40});  // 33,000 facets, 2744 shells
  std::vector<std::uint32_t> shell_of_face;
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) shell_of_face.push_back(static_cast<std::uint32_t>(f / 12));
  for (unsigned jobs : {1u, 2u, 5u}) {
    const auto volumes = shell_volumes(mesh, shell_of_face, 2744, jobs);
    for (const Rational& v : volumes) ASSERT_EQ(v == Rational(1), true);
    EXPECT_EQ(spelled(one_shell(mesh, jobs)[0]), "2744");
  }
}

TEST(Volume, FacetsWithoutAShellAreLeftOut) {
  TriangleMesh mesh = shapes::box({0, 0, 0}, {1, 1, 1});
  mesh.faces.push_back({0, 0, 1});
  std::vector<std::uint32_t> shell_of_face(12, 0);
  shell_of_face.push_back(0xffffffffu);
  EXPECT_EQ(spelled(shell_volumes(mesh, shell_of_face, 1, 1)[0]), "1");
}

}  // namespace
}  // namespace veritope
