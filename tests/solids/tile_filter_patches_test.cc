// SPDX-License-Identifier: LGPL-3.0-or-later
// Tiles against solids of patches.
#include <gtest/gtest.h>

#include "models/patch_shapes.h"
#include "models/round_parts.h"
#include "solids/micro/filter/grid_filter.h"
#include "solids/micro/filter/tile_filter.h"
#include "splines/bspline_pieces.h"
#include "tests/solids/patch_support.h"
#include "tests/support/micro_tiles.h"

namespace veritope {
namespace {

using micro_tiles::Point;

Rational pq(std::int64_t p, std::int64_t d = 1) { return Rational(p) / Rational(d); }

BezierVolume<Rational> cube_cell(const Point& middle, const Rational& half) {
  return micro_tiles::cage({1, 1, 1}, [&](const Point& u) {
    Point p;
    for (std::size_t c = 0; c < 3; ++c) p[c] = middle[c] + (u[c] + u[c] - pq(1)) * half;
    return p;
  });
}
micro_tiles::Tile full_cube() {
  return micro_tiles::box({pq(0), pq(0), pq(0)}, {pq(1), pq(1), pq(1)});
}

CellFinding find_in(const Patches& patches, const BezierVolume<Rational>& map,
                    const micro_tiles::Tile& tile, const TileFilterLimits& limits = {}) {
  const PatchComplex complex = complex_of(patches);
  return TileFilter::make(complex).find({&map}, micro_tiles::shape_of(tile), limits);
}
CellStatus status_in(const Patches& patches, const BezierVolume<Rational>& map,
                     const micro_tiles::Tile& tile) {
  return find_in(patches, map, tile).status;
}

TEST(TileFilterPatches, JacksNearABallAreKeptCrossingOrOutside) {
  for (const Patches& ball : {patch_shapes::sphere(), patch_shapes::octant_sphere()})
    for (const int degree : {1, 3}) {
      const auto jack = micro_tiles::jack(degree);
      // The ends of arms are squares of half-side 1/4 of the cell's half.
      const auto at = [&](std::int64_t x, std::int64_t percent) {
        return status_in(ball, cube_cell({pq(x, 100), pq(0), pq(0)}, pq(percent, 100)), jack);
      };
      EXPECT_EQ(at(0, 90), CellStatus::kKept);
      EXPECT_EQ(at(0, 93), CellStatus::kKept);      // 93^2 (1 + 1/8) < 100^2
      EXPECT_EQ(at(0, 95), CellStatus::kCrossing);  // 95^2 (1 + 1/8) > 100^2
      EXPECT_EQ(at(50, 40), CellStatus::kKept);
      EXPECT_EQ(at(100, 20), CellStatus::kCrossing);
      EXPECT_EQ(at(121, 20), CellStatus::kOutside);
      EXPECT_EQ(at(300, 20), CellStatus::kOutside);
    }
}

TEST(TileFilterPatches, WitnessesLieWhereTheySay) {
  const CellFinding finding =
      find_in(patch_shapes::sphere(), cube_cell({pq(1), pq(0), pq(0)}, pq(1, 5)), full_cube());
  ASSERT_EQ(finding.status, CellStatus::kCrossing);
  ASSERT_TRUE(finding.inside && finding.off);
}

TEST(TileFilterPatches, ABubbleWithinATileIsFound) {
  const Patches hollow = patch_shapes::joined(
      {patch_shapes::placed(patch_shapes::sphere(), pq(4), {}),
       patch_shapes::reversed(patch_shapes::placed(patch_shapes::sphere(), pq(1, 8), {}))});
  const CellFinding finding = find_in(hollow, cube_cell({}, pq(1)), full_cube());
  EXPECT_EQ(finding.status, CellStatus::kCrossing);
  EXPECT_TRUE(finding.vertex.has_value());
  // The node of a jack as wide as the bubble.
  EXPECT_EQ(status_in(hollow, cube_cell({}, pq(1)), micro_tiles::jack(3)), CellStatus::kCrossing);
  EXPECT_EQ(status_in(hollow, cube_cell({pq(2), pq(0), pq(0)}, pq(1)), full_cube()),
            CellStatus::kKept);
  // All of a solid within a tile.
  EXPECT_EQ(status_in(patch_shapes::sphere(), cube_cell({}, pq(3)), full_cube()),
            CellStatus::kCrossing);
  // Within the bubble.
  EXPECT_EQ(status_in(hollow, cube_cell({}, pq(1, 20)), full_cube()), CellStatus::kOutside);
}

TEST(TileFilterPatches, ContactsAreUndecidedAndNeverKept) {
  const auto kept_or_more = [](const Patches& patches, const BezierVolume<Rational>& map) {
    return status_in(patches, map, full_cube());
  };
  // A face in a face, from inside and from outside; an edge in an edge; a corner on the sphere.
  EXPECT_EQ(kept_or_more(unit_box(), cube_cell({pq(1, 2), pq(1, 2), pq(1, 4)}, pq(1, 4))),
            CellStatus::kUndecided);
  EXPECT_EQ(kept_or_more(unit_box(), cube_cell({pq(1, 2), pq(1, 2), pq(-1, 4)}, pq(1, 4))),
            CellStatus::kUndecided);
  EXPECT_EQ(kept_or_more(unit_box(), cube_cell({pq(-1), pq(-1), pq(1, 2)}, pq(1))),
            CellStatus::kUndecided);
  EXPECT_EQ(kept_or_more(patch_shapes::sphere(), cube_cell({pq(2), pq(0), pq(0)}, pq(1))),
            CellStatus::kUndecided);
  // One that crosses elsewhere is crossing, with a face in a face.
  EXPECT_EQ(kept_or_more(unit_box(), cube_cell({pq(1), pq(1, 2), pq(1, 4)}, pq(1, 4))),
            CellStatus::kCrossing);
}

TEST(TileFilterPatches, LimitsEndInUndecided) {
  TileFilterLimits limits;
  limits.max_pieces = 6;
  // The face at u = 0 is the parabolic cylinder x = 1001/1000 + 198/500 (v - 1/2)^2.
  const auto bent = micro_tiles::cage({1, 2, 1}, [](const Point& u) {
    return Point{pq(1) + u[0] / pq(5) + (u[1] == pq(1, 2) ? pq(-98, 1000) : pq(1, 10)),
                 u[1] - pq(1, 2), u[2] - pq(1, 2)};
  });
  EXPECT_EQ(find_in(patch_shapes::sphere(), bent, full_cube(), limits).status,
            CellStatus::kUndecided);
  EXPECT_EQ(find_in(patch_shapes::sphere(), bent, full_cube()).status, CellStatus::kOutside);
}

TEST(TileFilterPatches, NearMissesOfEverySizeAreDecided) {
  for (int bits = 4; bits <= 24; bits += 4) {
    const Rational gap = Rational::power_of_two(-bits);
    EXPECT_EQ(status_in(patch_shapes::sphere(), cube_cell({pq(6, 5) + gap, pq(0), pq(0)}, pq(1, 5)),
                        full_cube()),
              CellStatus::kOutside)
        << bits;
    EXPECT_EQ(status_in(patch_shapes::sphere(), cube_cell({pq(6, 5) - gap, pq(0), pq(0)}, pq(1, 5)),
                        full_cube()),
              CellStatus::kCrossing)
        << bits;
  }
}

TEST(TileFilterPatches, TinyTilesNearALargeSolidAreDecided) {
  const auto jack = micro_tiles::jack(3);
  for (const int bits : {10, 20, 30, 36}) {
    const Rational size = Rational::power_of_two(-bits);
    const auto at = [&](std::int64_t steps) {
      return status_in(patch_shapes::sphere(),
                       cube_cell({pq(1) + pq(steps) * size, pq(0), pq(0)}, size), jack);
    };
    EXPECT_EQ(at(2), CellStatus::kOutside) << bits;
    EXPECT_EQ(at(0), CellStatus::kCrossing) << bits;
    EXPECT_EQ(at(-2), CellStatus::kKept) << bits;
  }
}

TEST(TileFilterPatches, TrianglesAndPolynomialPatchesAreSolidsToo) {
  const Patches pn = patch_shapes::pn_torus(12, 8);
  const auto jack = micro_tiles::jack(3);
  EXPECT_EQ(status_in(pn, cube_cell({pq(3), pq(0), pq(0)}, pq(1, 3)), jack), CellStatus::kKept);
  EXPECT_EQ(status_in(pn, cube_cell({}, pq(1, 2)), jack), CellStatus::kOutside);
  EXPECT_EQ(status_in(pn, cube_cell({pq(2), pq(0), pq(0)}, pq(1, 3)), jack), CellStatus::kCrossing);
  const Patches plate = patch_shapes::plate(1);
  EXPECT_EQ(status_in(plate, cube_cell({pq(100), pq(0), pq(0)}, pq(1, 3)), jack),
            CellStatus::kOutside);
}

TEST(TileFilterPatches, AGridHasTheStatusesOfItsCellsForAnyNumberOfJobs) {
  const PatchComplex complex = complex_of(patch_shapes::ball_with_neck());
  ASSERT_TRUE(complex.is_closed_oriented_surface());
  const TileFilter filter = TileFilter::make(complex);
  const auto map = cube_cell({pq(0), pq(0), pq(3, 2)}, pq(7));
  const auto jack = std::make_shared<const TileShape>(micro_tiles::shape_of(micro_tiles::jack(3)));
  const auto tile = [&](const auto&) { return jack; };
  std::array<std::vector<Rational>, 3> lines;
  for (auto& along : lines)
    for (int i = 0; i <= 10; ++i) along.push_back(pq(i, 10));
  const GridStatus one = filter_grid(filter, to_bspline(map), lines, tile, 1).value();
  EXPECT_EQ(filter_grid(filter, to_bspline(map), lines, tile, 3).value().status, one.status);
  for (std::size_t n = 0; n < one.status.size(); ++n) {
    const auto at = one.cells.index_of(n);
    CellMap cell{&map};
    for (std::size_t a = 0; a < 3; ++a)
      cell.lo[a] = lines[a][at[a]], cell.hi[a] = lines[a][at[a] + 1];
    ASSERT_EQ(filter.status(cell, *jack), one.status[n]) << n;
  }
  EXPECT_GT(one.counts[0], 0u);
  EXPECT_GT(one.counts[1], 0u);
  EXPECT_GT(one.counts[3], 0u);
  EXPECT_EQ(one.counts[4], 0u);
}

}  // namespace
}  // namespace veritope
