// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/micro/filter/tile_filter.h"

#include <gtest/gtest.h>

#include "solids/micro/filter/tile_shape.h"
#include "tests/support/micro_tiles.h"
#include "tests/support/shapes.h"

namespace veritope {
namespace {

using micro_tiles::Point;

Rational q(std::int64_t p, std::int64_t d = 1) { return Rational(p) / Rational(d); }

TileFilter filter_of(const TriangleMesh& mesh) { return std::move(TileFilter::make(mesh).value()); }

BezierVolume<Rational> box_cell(const Point& lo, const Point& hi) {
  return micro_tiles::cage({1, 1, 1}, [&](const Point& u) {
    Point p;
    for (std::size_t c = 0; c < 3; ++c) p[c] = lo[c] + (hi[c] - lo[c]) * u[c];
    return p;
  });
}
BezierVolume<Rational> unit_cell(std::int64_t x = 0, std::int64_t y = 0, std::int64_t z = 0) {
  return box_cell({q(x), q(y), q(z)}, {q(x + 1), q(y + 1), q(z + 1)});
}

CellFinding find(const std::string& solid, const BezierVolume<Rational>& map,
                 const micro_tiles::Tile& tile) {
  const TriangleMesh mesh = shapes::parse(solid);
  return filter_of(mesh).find({&map}, micro_tiles::shape_of(tile));
}
CellStatus status(const std::string& solid, const BezierVolume<Rational>& map,
                  const micro_tiles::Tile& tile) {
  return find(solid, map, tile).status;
}

TEST(TileShape, KeepsEachCornerOnce) {
  const TileShape jack = micro_tiles::shape_of(micro_tiles::jack(1));
  EXPECT_EQ(jack.patches().size(), 30u);
  EXPECT_EQ(jack.corners().size(), 8u + 6 * 4);
  EXPECT_EQ(micro_tiles::shape_of(micro_tiles::jack(3)).corners().size(), 32u);
}

TEST(TileShape, RefusesWhatIsNoTileAndNamesThePatch) {
  EXPECT_EQ(TileShape::make({}).error().code, Code::kBadArgument);
  auto patches = micro_tiles::jack(1).patches;
  patches[7].component(1)[2] = q(9, 8);
  const Error outside = TileShape::make(patches).error();
  EXPECT_EQ(outside.code, Code::kBadArgument);
  EXPECT_NE(outside.message.find("patch 7 of the tile"), std::string::npos) << outside.message;
  EXPECT_NE(outside.message.find("9/8"), std::string::npos) << outside.message;
  patches = micro_tiles::jack(1).patches;
  patches[3] = micro_tiles::Surface({1, 1}, 4, true, std::vector<Rational>(16, q(1)));
  EXPECT_NE(TileShape::make(patches).error().message.find("rational"), std::string::npos);
  patches[3] = micro_tiles::Surface({1, 1}, 2, false, std::vector<Rational>(8, q(1)));
  EXPECT_NE(TileShape::make(patches).error().message.find("2 coordinates"), std::string::npos);
  patches[3] = micro_tiles::Surface({1, 16}, 3, false, std::vector<Rational>(3 * 34, q(1)));
  EXPECT_NE(TileShape::make(patches).error().message.find("degree 16"), std::string::npos);
}

TEST(TileFilter, RefusesAnOpenMesh) {
  const TriangleMesh open = shapes::parse("tri 0,0,0 1,0,0 0,1,0");
  EXPECT_EQ(TileFilter::make(open).error().code, Code::kBadArgument);
}

TEST(TileFilter, KeepsWhatIsInsideAndLeavesWhatIsOutside) {
  const auto jack = micro_tiles::jack(1);
  EXPECT_EQ(status("box -1,-1,-1 2,2,2", unit_cell(), jack), CellStatus::kKept);
  EXPECT_EQ(status("box 2,-1,-1 3,2,2", unit_cell(), jack), CellStatus::kOutside);
  EXPECT_EQ(status("box 1/2,-1,-1 3,2,2", unit_cell(), jack), CellStatus::kCrossing);
  // The solid is in the cell, and between the arms of the tile.
  EXPECT_EQ(status("box 3/4,3/4,3/4 7/8,7/8,7/8", unit_cell(), jack), CellStatus::kOutside);
}

TEST(TileFilter, ExhibitsAPointInsideAndAPointOff) {
  const TriangleMesh mesh = shapes::parse("box 1/2,-1,-1 3,2,2");
  const TileFilter filter = filter_of(mesh);
  const TileShape jack = micro_tiles::shape_of(micro_tiles::jack(1));
  const auto map = unit_cell();
  const CellFinding found = filter.find({&map}, jack);
  ASSERT_EQ(found.status, CellStatus::kCrossing);
  ASSERT_TRUE(found.inside && found.off);
  EXPECT_GT(CellMap{&map}.image(jack, *found.inside)[0], q(1, 2));
  EXPECT_LT(CellMap{&map}.image(jack, *found.off)[0], q(1, 2));
}

// All corners of the tile are inside, and so are the middles of its patches.
TEST(TileFilter, ANeedleThroughAFaceIsSeen) {
  const auto tile = micro_tiles::box({q(0), q(0), q(0)}, {q(1), q(1), q(1)});
  // A box with a needle-shaped void, closed, whose tip enters the tile by 2^-20.
  const std::string outer = "box -4,-4,-4 4,4,4; ";
  const std::string needle =
      "tet 0.3,0.7,0.99999904632568359375 0.29,0.7,2 0.31,0.69,2 0.31,0.71,2; flip";
  EXPECT_EQ(status(outer + needle, unit_cell(), tile), CellStatus::kCrossing);
  const std::string shorter =
      "tet 0.3,0.7,1.00000095367431640625 0.29,0.7,2 0.31,0.69,2 0.31,0.71,2; flip";
  EXPECT_EQ(status(outer + shorter, unit_cell(), tile), CellStatus::kKept);
}

// An edge of the solid cuts a face of the tile in a strip of width 2^-9, away from corners.
TEST(TileFilter, AShallowEdgeIsSeen) {
  const auto tile = micro_tiles::box({q(1, 8), q(1, 8), q(1, 8)}, {q(7, 8), q(7, 8), q(7, 8)});
  const std::string roof =
      "v -1,0.49,0.873046875 2,0.49,0.873046875 -1,-1,2 2,-1,2 -1,2,2 2,2,2; "
      "f 0,2,1 1,2,3 0,1,4 1,5,4 2,4,3 3,4,5 0,4,2 1,3,5";
  const CellFinding found = find(roof, unit_cell(), tile);
  EXPECT_EQ(found.status, CellStatus::kCrossing);
  EXPECT_TRUE(found.inside && found.off);
}

// One point of the tile inside and disjoint boundaries do not suffice.
TEST(TileFilter, ABubbleInANodeIsSeen) {
  const std::string solid = "box -1,-1,-1 2,2,2; box 7/16,7/16,7/16 9/16,9/16,9/16; flip";
  const CellFinding found = find(solid, unit_cell(), micro_tiles::jack(1));
  EXPECT_EQ(found.status, CellStatus::kCrossing);
  EXPECT_TRUE(found.inside.has_value());
  ASSERT_TRUE(found.vertex.has_value());
  EXPECT_GE(*found.vertex, 8u);
  EXPECT_EQ(find(solid, unit_cell(), micro_tiles::jack(3)).status, CellStatus::kCrossing);
  // Beside the arms it does no harm.
  EXPECT_EQ(status("box -1,-1,-1 2,2,2; box 3/4,3/4,3/4 7/8,7/8,7/8; flip", unit_cell(),
                   micro_tiles::jack(1)),
            CellStatus::kKept);
}

TEST(TileFilter, ASolidInANodeIsSeen) {
  const CellFinding found =
      find("box 7/16,7/16,7/16 9/16,9/16,9/16", unit_cell(), micro_tiles::jack(1));
  EXPECT_EQ(found.status, CellStatus::kCrossing);
  EXPECT_TRUE(found.off && found.vertex);
}

// A second body of the tile in a void of the solid: every piece needs a point of its own.
TEST(TileFilter, ATileOfTwoPiecesNeedsAPointOfEach) {
  micro_tiles::Tile tile =
      micro_tiles::box({q(1, 8), q(1, 8), q(1, 8)}, {q(1, 4), q(1, 4), q(1, 4)});
  for (auto& face :
       micro_tiles::box({q(5, 8), q(5, 8), q(5, 8)}, {q(6, 8), q(6, 8), q(6, 8)}).patches)
    tile.patches.push_back(face);
  EXPECT_EQ(status("box -1,-1,-1 2,2,2; box 1/2,1/2,1/2 7/8,7/8,7/8; flip", unit_cell(), tile),
            CellStatus::kCrossing);
  EXPECT_EQ(status("box -1,-1,-1 2,2,2", unit_cell(), tile), CellStatus::kKept);
}

TEST(TileFilter, ACornerOnAFacetTouches) {
  const auto tile = micro_tiles::box({q(0), q(0), q(0)}, {q(1), q(1), q(1)});
  // The facet x + y + z = 3, with the tile on its inner side; and the tile's corner on it from outside.
  const CellFinding inner = find("tet -3,0,0 9,-3,-3 -3,9,-3 -3,-3,9", unit_cell(), tile);
  EXPECT_EQ(inner.status, CellStatus::kTouching);
  EXPECT_EQ(*inner.contact, (ExactPoint{q(1), q(1), q(1)}));
  EXPECT_EQ(status("tet 5,5,5 3,0,0 0,3,0 0,0,3", unit_cell(), tile), CellStatus::kTouching);
  const auto nearer =
      box_cell({q(0), q(0), q(0)}, {q(1), q(1), q(1) + Rational::power_of_two(-40)});
  EXPECT_EQ(status("tet 5,5,5 3,0,0 0,3,0 0,0,3", nearer, tile), CellStatus::kCrossing);
  const auto farther =
      box_cell({q(0), q(0), q(0)}, {q(1), q(1), q(1) - Rational::power_of_two(-40)});
  EXPECT_EQ(status("tet 5,5,5 3,0,0 0,3,0 0,0,3", farther, tile), CellStatus::kOutside);
}

// The cap of a jack lies in a wall of the box, from inside, from outside, and beyond the box's edge.
TEST(TileFilter, ACapInAWallTouches) {
  for (const int degree : {1, 3}) {
    const auto jack = micro_tiles::jack(degree);
    EXPECT_EQ(status("box 0,-1,-1 2,2,2", unit_cell(), jack), CellStatus::kTouching);
    EXPECT_EQ(status("box 1,-1,-1 2,2,2", unit_cell(), jack), CellStatus::kTouching);
    EXPECT_EQ(status("box 1,1/2,-1 2,2,2", unit_cell(), jack), CellStatus::kTouching);
    EXPECT_EQ(status("box 0,0,0 1,1,1", unit_cell(), jack), CellStatus::kTouching);
  }
}

TEST(TileFilter, AnEdgeInANotchTouches) {
  const auto tile = micro_tiles::box({q(0), q(0), q(0)}, {q(1), q(1), q(1)});
  const TriangleMesh blocks = shapes::polycube({{1, 0, 0}, {0, 1, 0}, {1, 1, 0}});
  const auto map = unit_cell();
  EXPECT_EQ(filter_of(blocks).status({&map}, micro_tiles::shape_of(tile)), CellStatus::kTouching);
}

// The tile's face lies partly in a facet, and partly over the interior.
TEST(TileFilter, ASolidWithinATileThatTouchesIsNeverKept) {
  const auto tile = micro_tiles::box({q(0), q(0), q(0)}, {q(1), q(1), q(1)});
  const CellStatus half = status("box 0,0,0 1/2,1,1", unit_cell(), tile);
  EXPECT_TRUE(half == CellStatus::kCrossing || half == CellStatus::kUndecided);
  const CellStatus all = status("box 0,0,0 1,1,1", unit_cell(), tile);
  EXPECT_TRUE(all == CellStatus::kTouching || all == CellStatus::kUndecided);
}

TEST(TileFilter, CurvedAndRationalCellsAreMappedExactly) {
  const auto jack = micro_tiles::jack(3);
  // The wall at the cell's end is bent outward by 1/2 in the middle.
  const auto bent = micro_tiles::cage({2, 2, 2}, [](const Point& u) {
    Point p = u;
    if (u[0] == q(1) && u[1] == q(1, 2) && u[2] == q(1, 2)) p[0] = q(3);
    return p;
  });
  EXPECT_EQ(status("box -1,-1,-1 5/4,2,2", bent, jack), CellStatus::kCrossing);
  EXPECT_EQ(status("box -1,-1,-1 7/4,2,2", bent, jack), CellStatus::kKept);
  // u -> u / (2 - u), from 0 to 1: the node is moved to the left.
  BezierVolume<Rational> projective({1, 1, 1}, 4, true);
  for (std::size_t n = 0; n < 8; ++n) {
    const auto at = projective.grid().index_of(n);
    const Rational w(at[0] == 0 ? 2 : 1);
    projective.component(0)[n] = Rational(at[0]);
    projective.component(1)[n] = Rational(at[1]) * w;
    projective.component(2)[n] = Rational(at[2]) * w;
    projective.component(3)[n] = w;
  }
  EXPECT_EQ(status("box -1,-1,-1 2,2,2", projective, jack), CellStatus::kKept);
  EXPECT_EQ(status("box 0.52,-1,-1 3/4,0.2,2", projective, micro_tiles::jack(1)),
            CellStatus::kOutside);
  EXPECT_EQ(status("box 1/4,-1,-1 3/8,0.32,2", projective, micro_tiles::jack(1)),
            CellStatus::kCrossing);
}

TEST(TileFilter, AWeightThatMayVanishIsUndecided) {
  BezierVolume<Rational> map({1, 1, 1}, 4, true);
  for (std::size_t n = 0; n < 8; ++n) {
    const auto at = map.grid().index_of(n);
    for (std::size_t c = 0; c < 3; ++c) map.component(static_cast<int>(c))[n] = Rational(at[c]);
    map.component(3)[n] = q(n == 7 ? 0 : 1);
  }
  EXPECT_EQ(status("box 1/4,1/4,1/4 3/8,3/8,3/8", map,
                   micro_tiles::box({q(0), q(0), q(0)}, {q(1), q(1), q(1)})),
            CellStatus::kUndecided);
}

TEST(TileFilter, PartsOfAMapAreCells) {
  const TriangleMesh mesh = shapes::parse("box -1,-1,-1 1/2,2,2");
  const TileFilter filter = filter_of(mesh);
  const TileShape jack = micro_tiles::shape_of(micro_tiles::jack(1));
  const auto map = unit_cell();
  EXPECT_EQ(filter.status({&map, {q(0), q(0), q(0)}, {q(1, 3), q(1, 3), q(1)}}, jack),
            CellStatus::kKept);
  EXPECT_EQ(filter.status({&map, {q(1, 3), q(0), q(0)}, {q(2, 3), q(1, 3), q(1)}}, jack),
            CellStatus::kCrossing);
  EXPECT_EQ(filter.status({&map, {q(2, 3), q(0), q(0)}, {q(1), q(1, 3), q(1)}}, jack),
            CellStatus::kOutside);
}

TEST(TileFilter, LimitsEndInUndecided) {
  const TriangleMesh mesh = shapes::parse("tet 5,5,5 3,0,0 0,3,0 0,0,3");
  const TileFilter filter = filter_of(mesh);
  const TileShape tile =
      micro_tiles::shape_of(micro_tiles::box({q(0), q(0), q(0)}, {q(1), q(1), q(1)}));
  const auto map = unit_cell();
  TileFilterLimits limits;
  limits.max_exact_points = 0;
  limits.max_pieces = 200;
  EXPECT_EQ(filter.find({&map}, tile, limits).status, CellStatus::kUndecided);
}

TEST(TileFilter, FarAndHugeModelsAreDecided) {
  const auto jack = micro_tiles::jack(1);
  const auto far = box_cell({q(1000000), q(0), q(0)}, {q(1000001), q(1), q(1)});
  EXPECT_EQ(status("box 999999,-1,-1 1000002,2,2", far, jack), CellStatus::kKept);
  EXPECT_EQ(status("box 1000000,-1,-1 1000002,2,2", far, jack), CellStatus::kTouching);
  const Rational huge = Rational::power_of_two(900);
  EXPECT_EQ(status("box -0x1p901,-0x1p901,-0x1p901 0x1p901,0x1p901,0x1p901",
                   box_cell({q(0), q(0), q(0)}, {huge, huge, huge}), jack),
            CellStatus::kKept);
}

TEST(CellStatus, HasNames) {
  EXPECT_STREQ(cell_status_name(CellStatus::kKept), "kept");
  EXPECT_STREQ(cell_status_name(CellStatus::kCrossing), "crossing");
  EXPECT_STREQ(cell_status_name(CellStatus::kTouching), "touching");
  EXPECT_STREQ(cell_status_name(CellStatus::kOutside), "outside");
  EXPECT_STREQ(cell_status_name(CellStatus::kUndecided), "undecided");
}

}  // namespace
}  // namespace veritope
