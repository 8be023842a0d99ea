// SPDX-License-Identifier: LGPL-3.0-or-later
// Bridges in volumes, and in composed surfaces.
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <string>

#include "interval/numeric.h"
#include "interval/relations.h"
#include "solids/micro/bridge/bridge_proof.h"
#include "solids/micro/bridge_faces.h"
#include "solids/micro/compose/composed_surface.h"
#include "solids/micro/measure/micro_volume.h"
#include "solids/micro/mesh/micro_mesh.h"
#include "solids/polyhedron/validity.h"
#include "splines/bezier_calculus.h"
#include "splines/bezier_product.h"
#include "splines/de_casteljau.h"
#include "tests/support/micro_lattice.h"

namespace veritope {
namespace {

using micro_cells::box_tile;
using micro_cells::full;
using micro_lattice::add_bridge;
using micro_lattice::cage_volume;
using micro_lattice::Lattice;
using v_cells::cube;

Rational quotient(std::int64_t p, std::int64_t q) { return Rational(p) / Rational(q); }

// Posts along u with caps [1/4, 3/4]^2 of their cells, in some of the cells, and bridges made by hand.
struct Posts {
  Microstructure micro;
  VModel cage;
  std::vector<AnalysedTile> tiles;

  Posts(const VVolume& volume, const std::array<std::uint64_t, 3>& counts,
        const std::vector<std::size_t>& cells)
      : micro(full({volume}, counts, box_tile({0, 16, 16}, {64, 48, 48}))),
        cage(make_v_model(micro.cage, VOrientation::kAuto).value()) {
    tiles.push_back(std::get<AnalysedTile>(analyse_tile(micro.tiles[0])));
    std::vector<std::uint8_t>& all = micro.grids[0].tiles;
    std::fill(all.begin(), all.end(), std::uint8_t{0});
    for (const std::size_t c : cells) all[c] = 1;
  }
  MicroBridge& add(const CapPlace& place, const Rational& length, const TilePoint& aside = {}) {
    return add_bridge(micro, cage, tiles, place, length, aside);
  }
  MicroVolume volume(unsigned jobs = 1) const {
    EXPECT_TRUE(
        std::holds_alternative<std::vector<BridgeWitness>>(prove_bridges(micro, cage, tiles)));
    return volume_of(micro, cage, jobs).value();
  }
};

double relative_width_of(const Interval& x) { return wid(x) / mag(x); }

// Each side of a patch belongs to two patches, which pass it in opposite directions; sides are known by three points.
using SpacePoint = std::array<Rational, 3>;
void expect_watertight(const ComposedSurface& surface) {
  std::map<std::array<SpacePoint, 3>, int> sides;
  std::uint64_t patches = 0, points = 0;
  const Rational zero, one(1), half = quotient(1, 2);
  const std::array<std::array<Rational, 2>, 4> corner = {
      {{zero, zero}, {one, zero}, {one, one}, {zero, one}}};
  for (const auto& of_cell : surface.compose(0, surface.cells().size()))
    for (const ComposedPatch& p : of_cell) {
      ++patches;
      points += p.surface.grid().count();
      const auto at = [&](const Rational& u, const Rational& v) {
        const auto x = evaluate<Rational, 2>(p.surface, {u, v});
        return SpacePoint{x[0], x[1], x[2]};
      };
      for (std::size_t s = 0; s < 4; ++s) {
        const auto &from = corner[s], &to = corner[(s + 1) % 4];
        SpacePoint a = at(from[0], from[1]), b = at(to[0], to[1]);
        const SpacePoint m = at(half * (from[0] + to[0]), half * (from[1] + to[1]));
        const bool is_forward = a < b;
        if (!is_forward) std::swap(a, b);
        sides[{a, m, b}] += is_forward ? 1 : 1000;
      }
    }
  EXPECT_EQ(patches, surface.num_patches());
  EXPECT_EQ(points, surface.num_points());
  for (const auto& [side, count] : sides) EXPECT_EQ(count, 1001);
}
// The volume that it bounds: the flux of x / 3.
Rational flux_through(const ComposedSurface& surface) {
  Rational sum;
  for (const auto& of_cell : surface.compose(0, surface.cells().size()))
    for (const ComposedPatch& p : of_cell)
      sum += integral(dot(p.surface, cross(derivative(p.surface, 0), derivative(p.surface, 1))))[0];
  return sum / Rational(3);
}

TEST(BridgeFaces, TurnOutOfTheUnitCube) {
  MicroBridge identity;
  for (int i = 0; i < 2; ++i)
    for (int j = 0; j < 2; ++j)
      for (int k = 0; k < 3; ++k)
        identity.points.push_back({Rational(i), Rational(j), quotient(k, 2)});
  const auto faces = free_faces(identity);
  std::vector<BezierSurface<Rational>> all(faces.begin(), faces.end());
  all.push_back(covering_face(identity));
  const std::array<std::array<int, 2>, 6> outside = {
      {{0, -1}, {0, 1}, {1, -1}, {1, 1}, {2, 1}, {2, -1}}};
  for (std::size_t f = 0; f < 6; ++f) {
    const auto normal = evaluate<Rational, 2>(cross(derivative(all[f], 0), derivative(all[f], 1)),
                                              {quotient(1, 3), quotient(1, 5)});
    for (std::size_t a = 0; a < 3; ++a)
      EXPECT_EQ(normal[a],
                Rational(a == static_cast<std::size_t>(outside[f][0]) ? outside[f][1] : 0))
          << "face " << f;
  }
}

TEST(BridgeVolume, InABoxItIsExactInFractions) {
  for (const bool is_left : {false, true})
    for (const TilePoint& aside :
         {TilePoint{}, TilePoint{quotient(1, 16), quotient(1, 8), quotient(-1, 32)}}) {
      const VVolume box = v_cells::box({Rational(0), Rational(0), Rational(0)},
                                       {Rational(2), Rational(3), quotient(1, 3)});
      Posts posts(is_left ? reversed(box, 1) : box, {4, 1, 1}, {0});
      const MicroBridge& bridge = posts.add({0, 0, 1}, quotient(5, 8), aside);
      // The box has the determinant 2. By the rule of the divergence the bridge in the parameters has this volume.
      const auto map = bridge_map(bridge);
      const Rational truth =
          Rational(2) *
          integral(dot(derivative(map, 0), cross(derivative(map, 1), derivative(map, 2))))[0];
      const MicroVolume v = posts.volume();
      EXPECT_TRUE(contains(v.bridges, truth)) << to_string(v.bridges);
      EXPECT_LE(relative_width_of(v.bridges), 1e-12);
      EXPECT_TRUE(contains(v.tiles, quotient(1, 8)));
      EXPECT_TRUE(contains(v.solid, quotient(1, 8) + truth));
      EXPECT_TRUE(contains(v.density, (quotient(1, 8) + truth) / Rational(2)));
    }
}

// The map (x(u), y(v), z), with these control points along u and v.
VVolume stretched(int degree, const std::vector<Rational>& knots,
                  const std::vector<Rational>& along, std::size_t axis) {
  VVolume cell =
      v_cells::polynomial({degree, degree, 1}, [&](std::size_t i, std::size_t j, std::size_t k) {
        return v_cells::Point{quotient(static_cast<std::int64_t>(i), degree),
                              quotient(static_cast<std::int64_t>(j), degree), Rational(k)};
      });
  for (const Rational& t : knots) cell = insert_knot(cell, axis, t);
  const Grid<3> grid = cell.grid();
  for (std::size_t n = 0; n < grid.count(); ++n)
    cell.component(static_cast<int>(axis))[n] = along[grid.index_of(n)[axis]];
  return cell;
}

TEST(BridgeVolume, AcrossAKnotOfASmoothMapItIsAsNear) {
  // x(u) is a quadratic spline with a continuous derivative: x(u) = u^2 up to 1/2, then 1/4 + t + 2 t^2, t = u - 1/2.
  const VVolume volume =
      stretched(2, {quotient(1, 2)},
                {Rational(0), Rational(0), quotient(1, 2), Rational(1) + quotient(1, 4)}, 0);
  Posts posts(volume, {8, 1, 1}, {2});
  posts.add({0, 2, 1}, quotient(3, 8));
  const Rational end = quotient(1, 4), t = quotient(1, 4);
  const Rational x = end + t + Rational(2) * t * t, begin = quotient(9, 64);
  const MicroVolume v = posts.volume();
  EXPECT_TRUE(contains(v.bridges, (x - begin) / Rational(4))) << to_string(v.bridges);
  EXPECT_LE(relative_width_of(v.bridges), 1e-9);
}

TEST(BridgeVolume, CountsBeyondTheCellsToo) {
  // A grid of one cell of four, which holds a post; its bridge leads out of the grid.
  Posts posts(cube(0, 0, 0), {4, 1, 1}, {0});
  MicroGrid& grid = posts.micro.grids[0];
  grid.breaks[0].resize(2);
  grid.tiles.resize(1);
  posts.add({0, 0, 1}, quotient(5, 8));
  const MicroVolume v = posts.volume();
  EXPECT_TRUE(contains(v.density, quotient(1, 4) + quotient(5, 8)));
  EXPECT_LE(relative_width_of(v.density), 1e-12);
}

TEST(BridgeVolume, ACreaseLeavesWiderBounds) {
  const VVolume volume =
      stretched(1, {quotient(1, 2)}, {Rational(0), quotient(1, 2), quotient(3, 2)}, 0);
  Posts posts(volume, {8, 1, 1}, {2});
  posts.add({0, 2, 1}, quotient(3, 8));
  const MicroVolume v = posts.volume();
  EXPECT_TRUE(contains(v.bridges, (Rational(1) - quotient(3, 8)) / Rational(4)))
      << to_string(v.bridges);
  EXPECT_LE(relative_width_of(v.bridges), 1e-6);
}

TEST(BridgeVolume, AcrossAKnotBesideItsAxis) {
  const VVolume volume =
      stretched(1, {quotient(1, 2)}, {Rational(0), quotient(1, 2), quotient(3, 2)}, 1);
  Posts posts(volume, {4, 2, 1}, {0});
  posts.add({0, 0, 1}, quotient(1, 2), {Rational(0), quotient(1, 4), Rational(0)});
  // At w the bridge has the width 1/4 + max(0, w^2 / 4 - 1/8) along y, and 1/2 along z.
  const double truth = 0.25 * (0.25 - 1.0 / 24 + std::sqrt(0.5) / 12);
  const MicroVolume v = posts.volume();
  EXPECT_LE(v.bridges.lo(), truth * (1 + 1e-15));
  EXPECT_GE(v.bridges.hi(), truth * (1 - 1e-15));
  EXPECT_LE(relative_width_of(v.bridges), 1e-5);
}

TEST(BridgeVolume, AgreesWithTheComposedSurfaceInFractions) {
  for (const bool is_bent : {false, true}) {
    Lattice lattice(is_bent ? 5 : 4, cage_volume(is_bent, is_bent), quotient(1, 5), quotient(4, 5),
                    1);
    ASSERT_GT(lattice.build(0.03).built, 6u);
    const ComposedSurface surface =
        ComposedSurface::make(lattice.micro, lattice.cage, lattice.tiles).value();
    // The knots are inserted ones, which the map does not need.
    EXPECT_TRUE(surface.bridges_left_out().empty());
    expect_watertight(surface);
    const Rational truth = flux_through(surface);
    const MicroVolume v = volume_of(lattice.micro, lattice.cage, 1).value();
    EXPECT_TRUE(contains(v.solid, truth))
        << is_bent << ": " << to_string(v.solid) << " " << nearest_double(truth);
    EXPECT_LE(relative_width_of(v.solid), 1e-9);
  }
}

TEST(ComposedBridges, AreLeftOutWhereTheyCrossAKnotThatCounts) {
  Lattice lattice = micro_lattice::creased(4, 0.57);
  ASSERT_GT(lattice.build().built, 20u);
  const ComposedSurface surface =
      ComposedSurface::make(lattice.micro, lattice.cage, lattice.tiles).value();
  std::vector<std::uint32_t> crossing;
  for (std::uint32_t b = 0; b < lattice.micro.bridges.size(); ++b) {
    bool before = false, beyond = false;
    for (const TilePoint& p : lattice.micro.bridges[b].points) {
      before = before || p[0] < quotient(1, 2);
      beyond = beyond || p[0] > quotient(1, 2);
    }
    if (before && beyond) crossing.push_back(b);
  }
  ASSERT_FALSE(crossing.empty());
  EXPECT_LT(crossing.size(), lattice.micro.bridges.size());
  EXPECT_EQ(surface.bridges_left_out(), crossing);
  expect_watertight(surface);
  for (const ComposedCell& cell : surface.cells())
    for (const std::uint32_t b : cell.bridges)
      EXPECT_EQ(std::count(crossing.begin(), crossing.end(), b), 0);
}

TEST(ComposedBridges, FacesAreTheMapAfterTheBridge) {
  for (const bool is_left : {false, true}) {
    const VVolume bent = v_cells::mapped(cube(0, 0, 0), [](const v_cells::Point& p) {
      return v_cells::Point{p[0] + p[1] * p[2] / Rational(4), p[1], p[2] - p[0] / Rational(3)};
    });
    Posts posts(is_left ? reversed(bent, 2) : bent, {4, 1, 1}, {3});
    posts.add({0, 3, 0}, quotient(1, 2), {Rational(0), quotient(1, 8), Rational(0)});
    const ComposedSurface surface =
        ComposedSurface::make(posts.micro, posts.cage, posts.tiles).value();
    ASSERT_EQ(surface.num_patches(), 5u + 5u);
    expect_watertight(surface);
    EXPECT_EQ(flux_through(surface).sign(), Sign::kPositive);
    const auto faces = free_faces(posts.micro.bridges[0]);
    std::size_t found = 0;
    const auto patches = surface.compose(0, 1).front();
    for (const ComposedPatch& p : patches) {
      if (!p.bridge) continue;
      EXPECT_EQ(*p.bridge, 0u);
      EXPECT_EQ(p.patch, found++);
      const Rational u = quotient(2, 7), v = quotient(3, 5);
      const auto at = evaluate<Rational, 2>(faces[p.patch], {is_left ? Rational(1) - u : u, v});
      const auto truth = point(posts.micro.cage[0], std::array<Rational, 3>{at[0], at[1], at[2]});
      EXPECT_EQ((evaluate<Rational, 2>(p.surface, {u, v})), truth.value());
    }
    EXPECT_EQ(found, kFreeBridgeFaces);
  }
}

TEST(BridgeVolume, MeshesHaveNearlyThisVolume) {
  // A rational volume, the same volume far away, and one with a crease.
  const VVolume round = v_cells::rational(
      {2, 1, 1},
      [](std::size_t i, std::size_t j, std::size_t k) {
        return v_cells::Point{quotient(static_cast<std::int64_t>(i), 2),
                              quotient(static_cast<std::int64_t>(4 * j + (i == 1)), 4),
                              Rational(k)};
      },
      [](std::size_t i, std::size_t, std::size_t) {
        return i == 1 ? quotient(4, 5) : Rational(1);
      });
  for (const bool has_crease : {false, true}) {
    Lattice lattice = has_crease ? micro_lattice::creased(4, 0.57)
                                 : Lattice(6, round, quotient(3, 10), quotient(7, 10));
    ASSERT_GT(lattice.build().built, 4u) << has_crease;
    MicroMeshOptions options;
    options.chord = 0.002;
    const MicroMesh mesh = mesh_of(lattice.micro, lattice.cage, lattice.tiles, options).value();
    const ValidityReport report = decide_validity(mesh.mesh, {});
    ASSERT_TRUE(report.is_valid);
    double area = 0;
    for (const auto& t : mesh.mesh.faces) {
      const auto side = [&](std::size_t i) {
        const Vec3d &p = mesh.mesh.positions[t[0]], &q = mesh.mesh.positions[t[i]];
        return Vec3d{q.x - p.x, q.y - p.y, q.z - p.z};
      };
      const Vec3d a = side(1), b = side(2);
      area += std::hypot(a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x) / 2;
    }
    const MicroVolume v = volume_of(lattice.micro, lattice.cage, 1).value();
    EXPECT_NEAR(mid(v.solid), nearest_double(*report.volume), 2 * area * mesh.distance);
    EXPECT_LE(relative_width_of(v.solid), 1e-7);
  }
}

TEST(BridgeVolume, IsTheSameForEveryNumberOfJobs) {
  Lattice lattice(6, cage_volume(1, true), quotient(1, 5), quotient(4, 5));
  ASSERT_GT(lattice.build().built, 32u);
  const MicroVolume one = volume_of(lattice.micro, lattice.cage, 1).value();
  for (const unsigned jobs : {2u, 5u}) {
    const MicroVolume other = volume_of(lattice.micro, lattice.cage, jobs).value();
    EXPECT_EQ(other.bridges, one.bridges);
    EXPECT_EQ(other.solid, one.solid);
    EXPECT_EQ(other.density, one.density);
  }
}

}  // namespace
}  // namespace veritope
