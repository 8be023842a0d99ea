// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/micro/inside/clearance.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "models/patch_shapes.h"
#include "robust/base/random.h"
#include "solids/classify/mesh_projection.h"
#include "tests/solids/patch_support.h"
#include "tests/support/micro_lattice.h"
#include "tests/support/random_microstructures.h"

namespace veritope {
namespace {

using micro_cells::box_tile;
using micro_cells::full;
using v_cells::cube;

constexpr double kWorth = 1.01;

Rational part_of(std::int64_t p, std::int64_t q) { return Rational(p) / Rational(q); }

Clearance found(const Result<std::optional<Clearance>>& answer) {
  EXPECT_TRUE(answer.has_value() && answer->has_value());
  return answer.has_value() && answer->has_value() ? **answer : Clearance{-1, -1};
}
void expect_bounds(const Clearance& c, const Rational& truth, const std::string& what) {
  EXPECT_LE(Rational::from_double(c.lo), truth) << what;
  EXPECT_GE(Rational::from_double(c.hi), truth) << what;
  EXPECT_LE(c.hi, kWorth * c.lo) << what;
}

// Boxes in some cells of a cube inside of a block: the least of the distances from the six faces.
TEST(Clearance, OfBoxesInABlockIsExact) {
  Random random(11);
  for (int trial = 0; trial < 200; ++trial) {
    std::array<int, 3> lo, hi;
    for (std::size_t a = 0; a < 3; ++a) {
      lo[a] = static_cast<int>(random.between(0, 30));
      hi[a] = static_cast<int>(random.between(34, 64));
    }
    const std::array<std::uint64_t, 3> counts = {1 + random.below(4), 1 + random.below(4),
                                                 1 + random.below(4)};
    Microstructure micro = full({cube(0, 0, 0)}, counts, box_tile(lo, hi));
    MicroGrid& grid = micro.grids[0];
    for (std::uint8_t& t : grid.tiles) t = random.below(3) == 0 ? 1 : 0;
    grid.tiles[random.below(grid.tiles.size())] = 1;
    // A block with corners in sixty-fourths, which is around all cells.
    const int low = static_cast<int>(random.between(-20, -1)),
              high = static_cast<int>(random.between(65, 90));
    const TriangleMesh mesh = micro_lattice::block(low / 64.0, high / 64.0);
    std::optional<Rational> truth;
    for (std::size_t c = 0; c < grid.tiles.size(); ++c) {
      if (grid.tiles[c] == 0) continue;
      const auto at = grid.shape().index_of(c);
      for (std::size_t a = 0; a < 3; ++a) {
        const auto n = static_cast<std::int64_t>(counts[a]), i = static_cast<std::int64_t>(at[a]);
        const Rational begin = (Rational(i) + part_of(lo[a], 64)) / Rational(n),
                       end = (Rational(i) + part_of(hi[a], 64)) / Rational(n);
        for (const Rational& d : {begin - part_of(low, 64), part_of(high, 64) - end})
          if (!truth || d < *truth) truth = d;
      }
    }
    expect_bounds(found(clearance_of(micro, mesh, 1)), *truth, "trial " + std::to_string(trial));
  }
}

TEST(Clearance, IsThatOfTheNearestFreeCapOfJacks) {
  for (const int degree : {1, 3}) {
    const micro_lattice::Lattice lattice(6, micro_lattice::cage_volume(0, false), part_of(1, 10),
                                         part_of(9, 10), degree);
    // The caps of cells 1 to 4 lie at 1/6 and 5/6; a block's corner is the double next to 1/10, or to 9/10.
    const Rational below = part_of(1, 6) - Rational::from_double(0.1),
                   above = Rational::from_double(0.9) - part_of(5, 6);
    expect_bounds(found(clearance_of(lattice.micro, lattice.solid, 1)), std::min(below, above),
                  "degree " + std::to_string(degree));
  }
}

TEST(Clearance, FromACornerAndFromAnEdgeItIsARoot) {
  // One box in [1/4, 3/4]^3; a tetrahedron with one oblique facet: x + y + z = 3, far from all else.
  const Microstructure micro =
      full({cube(0, 0, 0)}, {1, 1, 1}, box_tile({16, 16, 16}, {48, 48, 48}));
  TriangleMesh mesh;
  mesh.positions = {{-9, -9, -9}, {21, -9, -9}, {-9, 21, -9}, {-9, -9, 21}};
  mesh.faces = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
  const Clearance c = found(clearance_of(micro, mesh, 1));
  const double truth = 0.75 / std::sqrt(3.0);  // the corner (3/4, 3/4, 3/4)
  EXPECT_LE(c.lo, truth * (1 + 1e-15));
  EXPECT_GE(c.hi, truth * (1 - 1e-15));
  EXPECT_LE(c.hi, kWorth * c.lo);
  // A vertex that looks at the middle of a face: an open mesh has a distance, too.
  TriangleMesh peak;
  peak.positions = {{0.5, 0.5, 0.875}, {9, 0, 9}, {0, 9, 9}};
  peak.faces = {{0, 1, 2}};
  expect_bounds(found(clearance_of(micro, peak, 1)), part_of(1, 8), "a peak");
}

// No point of a tile is nearer than lo, in fractions, and none that is found is much nearer than hi.
TEST(Clearance, IsNoMoreThanTheDistanceOfAnyPoint) {
  int compared = 0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    Random random(seed);
    const random_micro::Structure s = random_micro::any_structure(random);
    std::size_t cells = 0;
    for (const MicroGrid& g : s.micro.grids)
      cells += static_cast<std::size_t>(
          std::count_if(g.tiles.begin(), g.tiles.end(), [](std::uint8_t t) { return t != 0; }));
    if (cells == 0 || cells > 12) continue;
    ++compared;
    // A facet somewhere beside the structure, not far away.
    const double size = random_micro::size_of(s.micro);
    TriangleMesh mesh;
    for (int i = 0; i < 3; ++i)
      mesh.positions.push_back({size * (1.2 + random.unit()), size * (2 * random.unit() - 1),
                                size * (2 * random.unit() - 1)});
    mesh.faces = {{0, 1, 2}};
    const MeshProjection projection(mesh);
    const Clearance c = found(clearance_of(s.micro, mesh, 1));
    EXPECT_GT(c.lo, 0);
    EXPECT_LE(c.hi, kWorth * c.lo) << "seed " << seed << ": " << s.description;
    const Rational least = Rational::from_double(c.lo) * Rational::from_double(c.lo);
    double nearest = HUGE_VAL;
    for (const MicroGrid& grid : s.micro.grids)
      for (std::size_t n = 0; n < grid.tiles.size(); ++n) {
        if (grid.tiles[n] == 0) continue;
        const auto at = grid.shape().index_of(n);
        const WallNumbers numbers = grid.numbers_of(at);
        for (const TilePatch& patch : s.micro.tiles[grid.tiles[n] - 1u].patches) {
          std::vector<TilePoint> points = points_at(patch, number_of(patch, numbers));
          for (const std::size_t corner : {std::size_t{0}, points.size() - 1}) {
            std::array<Rational, 3> x;
            for (std::size_t a = 0; a < 3; ++a)
              x[a] = grid.breaks[a][at[a]] +
                     points[corner][a] * (grid.breaks[a][at[a] + 1] - grid.breaks[a][at[a]]);
            const auto p = point(s.micro.cage[grid.volume], x).value();
            const Rational d = projection.project({p[0], p[1], p[2]}).squared_distance;
            EXPECT_GE(d, least) << "seed " << seed << ": " << s.description;
            nearest = std::min(nearest, std::sqrt(nearest_double(d)));
          }
        }
      }
    EXPECT_LE(c.hi, kWorth * nearest) << "seed " << seed << ": " << s.description;
  }
  EXPECT_GE(compared, 8);
}

TEST(Clearance, FromPatchesItIsThatOfTheSurface) {
  // A cube in the unit sphere: its corners are nearest.
  const Rational edge = part_of(1, 4);
  const VVolume cage = v_cells::box({-edge, -edge, -edge}, {edge, edge, edge});
  const Microstructure micro = full({cage}, {2, 2, 2}, box_tile({0, 0, 0}, {64, 64, 64}));
  const double truth = 1 - 0.25 * std::sqrt(3.0);
  for (const Patches& ball : {patch_shapes::sphere(), patch_shapes::octant_sphere()}) {
    const Clearance c = found(clearance_of(micro, complex_of(ball), 1));
    EXPECT_LE(c.lo, truth * (1 + 1e-15));
    EXPECT_GE(c.hi, truth * (1 - 1e-15));
    EXPECT_LE(c.hi, kWorth * c.lo);
  }
  const auto block = patch_shapes::box({Rational(-1), Rational(-1), Rational(-1)},
                                       {Rational(1), Rational(1), part_of(3, 8)});
  expect_bounds(found(clearance_of(micro, complex_of(block), 1)), part_of(1, 8),
                "a box of patches");
}

TEST(Clearance, TinyGapsAreBounded) {
  for (const int exponent : {-10, -20, -30}) {
    const double gap = std::ldexp(1.0, exponent);
    const Microstructure micro =
        full({cube(0, 0, 0)}, {3, 3, 3}, box_tile({0, 0, 0}, {64, 64, 64}));
    expect_bounds(found(clearance_of(micro, micro_lattice::block(-gap, 1 + 2 * gap), 1)),
                  Rational::from_double(gap), "2^" + std::to_string(exponent));
  }
}

TEST(Clearance, DoesNotDependOnJobs) {
  const micro_lattice::Lattice lattice(9, micro_lattice::cage_volume(1, true), part_of(1, 5),
                                       part_of(4, 5));
  const Clearance one = found(clearance_of(lattice.micro, lattice.solid, 1));
  for (const unsigned jobs : {2u, 7u}) {
    const Clearance other = found(clearance_of(lattice.micro, lattice.solid, jobs));
    EXPECT_EQ(other.lo, one.lo);
    EXPECT_EQ(other.hi, one.hi);
  }
}

TEST(Clearance, LimitsLeaveWiderBounds) {
  const micro_lattice::Lattice lattice(5, micro_lattice::cage_volume(1, true), part_of(1, 5),
                                       part_of(4, 5));
  const Clearance best = found(clearance_of(lattice.micro, lattice.solid, 1));
  for (const ClearanceLimits limits : {ClearanceLimits{1, 1}, ClearanceLimits{1, 20},
                                       ClearanceLimits{1000, 1}, ClearanceLimits{40, 40}}) {
    const Clearance c = found(clearance_of(lattice.micro, lattice.solid, 1, limits));
    EXPECT_LE(c.lo, best.hi);
    EXPECT_GE(c.hi, best.lo);
    EXPECT_GE(c.lo, 0);
  }
}

TEST(Clearance, NothingHasNone) {
  Microstructure micro = full({cube(0, 0, 0)}, {2, 2, 2}, box_tile({0, 0, 0}, {64, 64, 64}));
  EXPECT_FALSE(clearance_of(micro, TriangleMesh{}, 1)->has_value());
  for (std::uint8_t& t : micro.grids[0].tiles) t = 0;
  EXPECT_FALSE(clearance_of(micro, micro_lattice::block(-1, 2), 1)->has_value());
}

TEST(Clearance, NumbersBeyondBinary64AreRefused) {
  const VVolume huge = v_cells::mapped(cube(0, 0, 0), [](const v_cells::Point& p) {
    return v_cells::Point{p[0] * Rational::power_of_two(1030), p[1], p[2]};
  });
  const auto answer = clearance_of(full({huge}, {1, 1, 1}, box_tile({0, 0, 0}, {64, 64, 64})),
                                   micro_lattice::block(-1, 2), 1);
  ASSERT_FALSE(answer.has_value());
  EXPECT_EQ(answer.error().code, Code::kNotFinite);
}

}  // namespace
}  // namespace veritope
