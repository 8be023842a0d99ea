// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/polyhedron/nesting.h"

#include <gtest/gtest.h>

#include <numeric>
#include <set>

#include "tests/predicates/test_scale.h"
#include "tests/support/brute_force.h"
#include "tests/support/exact_geometry.h"
#include "tests/support/shapes.h"
#include "topology/surface.h"

namespace veritope {
namespace {

using oracle::operator-;
using oracle::operator*;

Nesting nest(const TriangleMesh& mesh, unsigned jobs = 1) {
  const Incidence incidence = Incidence::build(mesh.faces, static_cast<std::uint32_t>(mesh.positions.size()), 1);
  const SurfaceTopology topology = analyse_surface(mesh.faces, incidence, 0, 1);
  std::vector<std::uint32_t> facets(mesh.faces.size());
  std::iota(facets.begin(), facets.end(), 0u);
  const UnitScale scale(bounding_box(mesh.positions, 1));
  const BoxGroups boxes(mesh, morton_order(mesh, facets, scale, 1), {std::vector<std::uint8_t>(mesh.positions.size()), {}}, scale, 1);
  return nest_shells(mesh, boxes, topology.shell_of_face, topology.shells.size(), jobs);
}

// By winding numbers along rational rays in random directions.
std::vector<std::uint32_t> brute_depths(const TriangleMesh& mesh, std::uint64_t seed) {
  Random random(seed);
  const auto shells = oracle::brute_topology(mesh.faces).shells;
  std::vector<std::uint32_t> out;
  for (std::size_t s = 0; s < shells.size(); ++s) {
    const oracle::RVec p = oracle::rational(mesh.positions[mesh.faces[shells[s][0]][0]]);
    std::uint32_t depth = 0;
    for (std::size_t r = 0; r < shells.size(); ++r) depth += r != s && oracle::winding_number(mesh, shells[r], p, random) != 0;
    out.push_back(depth);
  }
  return out;
}

TEST(Nesting, OfOneShellIsZero) {
  const Nesting n = nest(shapes::box({0, 0, 0}, {1, 1, 1}));
  EXPECT_EQ(n.depth, (std::vector<std::uint32_t>{0}));
}

// PROVES MESH-6
TEST(Nesting, CountsTheShellsAround) {
  for (int depth = 2; depth <= 8; ++depth) {
    std::vector<std::uint32_t> want(static_cast<std::size_t>(depth));
    std::iota(want.begin(), want.end(), 0u);
    EXPECT_EQ(nest(shapes::nested_boxes(depth)).depth, want);
  }
}

TEST(Nesting, SideBySideIsNotInside) {
  EXPECT_EQ(nest(shapes::box_grid(3, 0.5)).depth, std::vector<std::uint32_t>(27, 0));
}

// Octahedra around one centre: every ray from an extreme vertex along an axis runs through vertices of the others.
// PROVES MESH-7
TEST(Nesting, RaysThroughVerticesAndEdgesCountOnce) {
  std::vector<TriangleMesh> parts;
  for (double r : {16.0, 1.0, 4.0, 8.0, 2.0}) {
    TriangleMesh m = shapes::parse("v 1,0,0 -1,0,0 0,1,0 0,-1,0 0,0,1 0,0,-1 ; f 0,2,4 2,1,4 1,3,4 3,0,4 2,0,5 1,2,5 3,1,5 0,3,5");
    for (Vec3d& p : m.positions) p = {p.x * r + 0.0, p.y * r + 0.0, p.z * r + 0.0};
    parts.push_back(m);
  }
  const TriangleMesh mesh = shapes::joined(parts);
  EXPECT_EQ(nest(mesh).depth, (std::vector<std::uint32_t>{0, 4, 2, 1, 3}));
  EXPECT_EQ(nest(mesh).depth, brute_depths(mesh, 1));
}

TEST(Nesting, RaysInThePlanesOfFacetsAndAlongTheirEdgesAreRight) {
  // Corners, edges and facets of all boxes lie in few planes and lines.
  for (const char* text : {"box 0,0,0 4,4,4 ; box 1,1,1 2,2,2 ; box 1,2.5,1 2,3,2", "box 0,0,0 1,1,1 ; box 2,0,0 3,1,1 ; box 4,0,0 5,1,1 ; box 2,2,0 3,3,1",
                           "box 0,0,0 9,9,9 ; box 1,1,1 2,2,2 ; box 3,1,1 4,2,2 ; box 5,1,1 8,8,8 ; box 6,6,6 7,7,7",
                           "tet 0,0,0 8,0,0 0,8,0 0,0,8 ; tet 1,1,1 2,1,1 1,2,1 1,1,2 ; tet 9,0,0 10,0,0 9,1,0 9,0,1"}) {
    const TriangleMesh mesh = shapes::parse(text);
    EXPECT_EQ(nest(mesh).depth, brute_depths(mesh, 2)) << text;
  }
}

// PROVES MESH-7
TEST(Nesting, LooksAroundATorus) {
  // In the hole, in the tube, and beside it.
  const TriangleMesh mesh = shapes::joined(std::vector<TriangleMesh>{
      shapes::torus(24, 12, 8, 3), shapes::box({-1, -1, -1}, {1, 1, 1}), shapes::box({7.5, -0.5, -0.5}, {8.5, 0.5, 0.5}), shapes::box({20, 0, 0}, {21, 1, 1}),
      shapes::box({-0.5, 7.5, -0.5}, {0.5, 8.5, 0.5})});
  EXPECT_EQ(nest(mesh).depth, (std::vector<std::uint32_t>{0, 0, 1, 0, 1}));
}

// PROVES MESH-6, MESH-7
TEST(NestingLaw, AgreesWithWindingNumbersOnRandomScenesAndTheirImages) {
  std::uint32_t deepest = 0;
  for (std::uint64_t seed = 1; seed <= static_cast<std::uint64_t>(scaled(5)); ++seed) {
    Random random(seed);
    const TriangleMesh scene = shapes::nested_scene(random, 14);
    for (const TriangleMesh& mesh : {scene, shapes::mapped(scene, shapes::random_matrix(random, 4), {3, -5, 7}), shapes::relabelled(scene, random)}) {
      const Nesting one = nest(mesh);
      EXPECT_EQ(one.depth, brute_depths(mesh, seed)) << "seed " << seed << ": " << shapes::to_text(mesh);
      for (std::uint32_t d : one.depth) deepest = std::max(deepest, d);
      for (unsigned jobs : {2u, 3u}) {
        EXPECT_EQ(nest(mesh, jobs).depth, one.depth);
        EXPECT_EQ(nest(mesh, jobs).axis_code, one.axis_code);
      }
    }
    if (HasFailure()) return;
  }
  EXPECT_GE(deepest, 4u);
}

TEST(NestingLaw, DoesNotDependOnJobsWithManyShells) {
  Random random(5);
  const TriangleMesh mesh = shapes::nested_scene(random, 150);
  const Nesting one = nest(mesh);
  for (unsigned jobs : {2u, 4u}) {
    EXPECT_EQ(nest(mesh, jobs).depth, one.depth);
    EXPECT_EQ(nest(mesh, jobs).axis_code, one.axis_code);
  }
}

// A box in the middle of six rows of walls, one of them short: the ray goes there.
TEST(Nesting, TakesADirectionWithFewFacetsOnItsWay) {
  std::set<std::uint8_t> codes;
  for (int free_side = 0; free_side < 6; ++free_side) {
    std::vector<TriangleMesh> parts{shapes::box({-1, -1, -1}, {1, 1, 1})};
    for (int side = 0; side < 6; ++side)
      for (int i = 0; i < (side == free_side ? 1 : 20); ++i) {
        const double near = 4 + 2 * i, r = 2.5;
        std::array<double, 3> lo{-r, -r, -r}, hi{r, r, r};
        lo[static_cast<std::size_t>(side / 2)] = side % 2 == 0 ? near : -near - 1;
        hi[static_cast<std::size_t>(side / 2)] = side % 2 == 0 ? near + 1 : -near;
        parts.push_back(shapes::box({lo[0], lo[1], lo[2]}, {hi[0], hi[1], hi[2]}));
      }
    const Nesting n = nest(shapes::joined(parts));
    EXPECT_EQ(n.depth, std::vector<std::uint32_t>(parts.size(), 0));
    codes.insert(n.axis_code[0]);
  }
  EXPECT_EQ(codes, (std::set<std::uint8_t>{0, 1, 2, 3, 4, 5}));
}

// The stab rule against its meaning: the ray from the point moved by (e, e^2) across it, for an e smaller than anything here.
TEST(StabFacet, IsTheAnswerForAPointMovedByEpsilon) {
  const Rational e = Rational::power_of_two(-200), e2 = e * e;
  std::array<long, 3> seen{};
  for (std::uint64_t seed = 1; seed <= static_cast<std::uint64_t>(scaled(20000)); ++seed) {
    Random random(seed);
    const TriangleMesh mesh = shapes::grid_soup(random, 1, 4);
    if (mesh.positions.size() < 3) continue;
    const auto c = [&] { return static_cast<double>(random.below(4)); };
    const double x = c(), y = c(), z = c();
    const Vec3d from{x, y, z};
    const int axis = static_cast<int>(random.below(3));
    const bool positive = random.below(2) == 0;
    oracle::RVec p = oracle::rational(from), d{Rational(0), Rational(0), Rational(0)};
    const oracle::RTriangle t = oracle::rational_triangle(mesh, 0);
    const oracle::RVec n = oracle::normal_of(t);
    if (oracle::is_zero(n)) continue;
    const auto u = static_cast<std::size_t>(axis);
    d[u] = Rational(positive ? 1 : -1);
    const Rational here = oracle::dot(n, t[0] - p);  // zero: from is in the plane, the moved ray may meet it
    p[(u + 1) % 3] += e;
    p[(u + 2) % 3] += e2;
    Stab want = Stab::kMiss;
    const auto meets = [&](const oracle::RVec& dir) {  // nullopt: the moved point lies in the facet
      const auto c = oracle::crossings(mesh, {0}, p, dir);
      return !c || *c != 0;
    };
    if (oracle::sgn(n[u]) != 0 && (meets(d) || meets(Rational(-1) * d)))
      want = oracle::sgn(here) == 0 ? Stab::kTouch : (meets(d) ? Stab::kHit : Stab::kMiss);
    const Stab got = stab_facet(mesh, 0, from, axis, positive);
    ++seen[static_cast<std::size_t>(got)];
    ASSERT_EQ(got, want) << "seed " << seed << ", from " << x << "," << y << "," << z << " along " << (positive ? "+" : "-") << axis << " of "
                         << shapes::to_text(mesh);
  }
  for (long count : seen) EXPECT_GT(count, scaled(100));
}

}  // namespace
}  // namespace veritope
