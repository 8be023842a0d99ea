// SPDX-License-Identifier: LGPL-3.0-or-later
// Tiles of curves and sheets: what they are, how they lie with respect to solids of known truth, and what is composed.
#include <gtest/gtest.h>

#include <algorithm>

#include "solids/micro/compose/composed_surface.h"
#include "solids/micro/fill_cage.h"
#include "solids/micro/open_tile.h"
#include "solids/micro/synthesis/filter_tiles.h"
#include "solids/patches/patch_complex.h"
#include "splines/bezier_degree.h"
#include "splines/bezier_domain.h"
#include "splines/bspline_pieces.h"
#include "splines/de_boor.h"
#include "tests/predicates/test_scale.h"
#include "tests/support/micro_cells.h"
#include "tests/support/micro_truth.h"
#include "tests/support/round_truth.h"

namespace veritope {
namespace {

using micro_tiles::Point;
using oracle::RVec;

constexpr std::uint64_t kCurveSeed = 20261127;

Rational cq(std::int64_t p, std::int64_t d = 1) { return Rational(p) / Rational(d); }

TileShape::Surface surface_of_patch(const TilePatch& patch) {
  TileShape::Surface out(patch.degrees, 3, false);
  for (std::size_t c = 0; c < 3; ++c)
    for (std::size_t n = 0; n < patch.num_points(); ++n)
      out.component(static_cast<int>(c))[n] = patch.points.front()[n][c];
  return out;
}
TileShape open_shape(const MicroTile& tile) {
  std::vector<TileShape::Surface> patches;
  for (const TilePatch& p : tile.patches) patches.push_back(surface_of_patch(p));
  return std::move(TileShape::make_open(std::move(patches)).value());
}
using Polyline = std::vector<Point>;
TileShape::Surface segment(const Point& a, const Point& b) {
  TilePatch patch;
  patch.degrees = {1, 0};
  patch.points.push_back(std::vector<TilePoint>{a, b});
  return surface_of_patch(patch);
}
TilePatch point_of_degree(int degree) {
  TilePatch patch;
  patch.degrees = {degree, 0};
  const TilePoint middle{cq(1, 2), cq(1, 2), cq(1, 2)};
  patch.points.push_back(std::vector<TilePoint>(static_cast<std::size_t>(degree) + 1, middle));
  return patch;
}
TileShape shape_of_polylines(const std::vector<Polyline>& lines) {
  std::vector<TileShape::Surface> patches;
  for (const Polyline& line : lines)
    for (std::size_t i = 0; i + 1 < line.size(); ++i)
      patches.push_back(segment(line[i], line[i + 1]));
  return std::move(TileShape::make_open(std::move(patches)).value());
}
BezierVolume<Rational> identity_cell() {
  return micro_tiles::cage({1, 1, 1}, [](const Point& u) { return u; });
}
CellFinding find_lines(const TriangleMesh& mesh, const std::vector<Polyline>& lines) {
  const auto map = identity_cell();
  return TileFilter::make(mesh).value().find({&map}, shape_of_polylines(lines));
}

// ---- the tiles

TEST(Curves3, HasThreeCoilsInSeparateBoxes) {
  const MicroTile tile = curves3_tile({}).value();
  ASSERT_EQ(tile.patches.size(), 12u);
  EXPECT_TRUE(tile.is_open && check_open_tile(tile).has_value());
  for (std::size_t i = 0; i < 12; ++i) {
    EXPECT_EQ(tile.patches[i].degrees, (std::array<int, 2>{3, 0}));
    const std::size_t axis = i / 4;
    for (const TilePoint& p : tile.patches[i].points.front()) {
      EXPECT_LT(p[(axis + 1) % 3], cq(1, 2));
      EXPECT_GT(p[(axis + 2) % 3], cq(1, 2));
    }
  }
}

// Value, first and second difference of control points agree from each span to the next, and from the last one to the
// first one of the next cell.
TEST(Curves3, IsPeriodicWithTwoDerivatives) {
  const MicroTile tile = curves3_tile({cq(1, 5), {}}).value();
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (std::size_t span = 0; span < 4; ++span) {
      const auto& a = tile.patches[4 * axis + span].points.front();
      const auto& b = tile.patches[4 * axis + (span + 1) % 4].points.front();
      for (std::size_t c = 0; c < 3; ++c) {
        const Rational shift = c == axis && span == 3 ? Rational(1) : Rational(0);
        EXPECT_EQ(a[3][c], b[0][c] + shift);
        EXPECT_EQ(a[3][c] - a[2][c], b[1][c] - b[0][c]);
        EXPECT_EQ(a[3][c] - Rational(2) * a[2][c] + a[1][c],
                  b[2][c] - Rational(2) * b[1][c] + b[0][c]);
      }
    }
}

TEST(Curves3, AsPolylinesHasItsPointsAtEqualParameters) {
  const MicroTile curve = curves3_tile({}).value();
  for (const int parts : {1, 2, 8, 10, 256}) {
    const MicroTile tile = curves3_tile({Curves3Shape{}.radius, parts}).value();
    ASSERT_EQ(tile.patches.size(), static_cast<std::size_t>(3 * parts));
    EXPECT_TRUE(check_open_tile(tile).has_value());
    for (int axis = 0; axis < 3; ++axis)
      for (int n = 0; n < parts; ++n) {
        const int span = 4 * n / parts;
        const auto& points =
            tile.patches[static_cast<std::size_t>(axis * parts + n)].points.front();
        const auto s = surface_of_patch(curve.patches[static_cast<std::size_t>(4 * axis + span)]);
        const auto x = evaluate<Rational, 2>(s, {cq(4 * n, parts) - Rational(span), Rational(0)});
        EXPECT_EQ(points[0], (TilePoint{x[0], x[1], x[2]}));
        if (n + 1 < parts) {
          EXPECT_EQ(points[1],
                    tile.patches[static_cast<std::size_t>(axis * parts + n + 1)].points.front()[0]);
        }
      }
  }
}

TEST(Curves3, RefusesNumbersOutOfRangeWithTheirValue) {
  for (const Rational& radius : {cq(0), cq(-1, 8), cq(1, 4), cq(7)}) {
    const auto made = curves3_tile({radius, {}});
    ASSERT_FALSE(made.has_value());
    EXPECT_EQ(made.error().code, Code::kBadArgument);
    EXPECT_NE(made.error().message.find(radius.to_string()), std::string::npos);
  }
  for (const int parts : {-1, 0, 257}) {
    const auto made = curves3_tile({cq(1, 8), parts});
    ASSERT_FALSE(made.has_value());
    EXPECT_NE(made.error().message.find(std::to_string(parts)), std::string::npos);
  }
}

TEST(SheetsOf, LeavesOutCapsAndNothingElse) {
  JackShape shape;
  const MicroTile jack = jack_tile(shape).value(), sheets = sheets_of(jack);
  EXPECT_EQ(sheets.patches.size(), 24u);
  EXPECT_TRUE(sheets.is_open && check_open_tile(sheets).has_value());
  shape.arms = 5;
  EXPECT_EQ(sheets_of(jack_tile(shape).value()).patches.size(), 2u * 4 + 4);
  shape.arms = 63;
  shape.range = {1000, 2000};
  const MicroTile family = sheets_of(jack_tile(shape).value());
  EXPECT_EQ(family.patches.size(), 24u);
  EXPECT_TRUE(family.range.has_value());
}

TEST(CheckOpenTile, NamesWhatIsWrong) {
  MicroTile tile = curves3_tile({}).value();
  tile.patches[5].points.front()[2][1] = cq(9, 8);
  const Status outside = check_open_tile(tile);
  ASSERT_FALSE(outside.has_value());
  EXPECT_NE(outside.error().message.find("patch 5"), std::string::npos);
  EXPECT_NE(outside.error().message.find("9/8"), std::string::npos);
  tile = curves3_tile({}).value();
  tile.patches[3].degrees = {0, 3};
  EXPECT_FALSE(check_open_tile(tile).has_value());
  tile.patches[3] = point_of_degree(8);
  EXPECT_EQ(check_open_tile(tile).error().code, Code::kOverLimit);
  tile.patches[3] = point_of_degree(7);
  EXPECT_TRUE(check_open_tile(tile).has_value());
}

TEST(OpenTiles, AreInNoFileOfMicrostructures) {
  Microstructure micro =
      micro_cells::full({v_cells::cube(0, 0, 0)}, {1, 1, 1}, curves3_tile({}).value());
  const Status valid = validate(micro);
  ASSERT_FALSE(valid.has_value());
  EXPECT_NE(valid.error().message.find("tile 0"), std::string::npos) << valid.error().message;
}

TEST(TileShape, AdmitsCurvesOnlyInOpenTiles) {
  const auto line = segment({cq(0), cq(0), cq(0)}, {cq(1), cq(1), cq(1)});
  EXPECT_FALSE(TileShape::make({line}).has_value());
  ASSERT_TRUE(TileShape::make_open({line}).has_value());
  const TileShape shape = std::move(TileShape::make_open({line}).value());
  EXPECT_TRUE(shape.is_open() && shape.patches()[0].is_curve());
  EXPECT_EQ(shape.corners().size(), 2u);
  const TileShape::Surface across({0, 1}, 3, false, std::vector<Rational>(6));
  EXPECT_FALSE(TileShape::make_open({across}).has_value());
  const TileShape::Surface high({16, 0}, 3, false, std::vector<Rational>(51));
  EXPECT_FALSE(TileShape::make_open({high}).has_value());
  EXPECT_FALSE(TileShape::make_open({}).has_value());
}

// ---- the filter, by hand

TEST(CurveFilter, SeesCurvesInsideOutsideAndAcross) {
  const auto map = identity_cell();
  const TileShape coils = open_shape(curves3_tile({}).value());
  const auto status = [&](const std::string& solid) {
    const TriangleMesh mesh = shapes::parse(solid);
    return TileFilter::make(mesh).value().find({&map}, coils).status;
  };
  EXPECT_EQ(status("box -1,-1,-1 2,2,2"), CellStatus::kKept);
  EXPECT_EQ(status("box 2,-1,-1 3,2,2"), CellStatus::kOutside);
  EXPECT_EQ(status("box 1/2,-1,-1 3,2,2"), CellStatus::kCrossing);
  // A solid between the coils, and a bubble there: a body would hold them, curves do not.
  EXPECT_EQ(status("box 7/16,7/16,7/16 9/16,9/16,9/16"), CellStatus::kOutside);
  EXPECT_EQ(status("box -1,-1,-1 2,2,2; box 7/16,7/16,7/16 9/16,9/16,9/16; flip"),
            CellStatus::kKept);
  EXPECT_EQ(status("box -1,-1,-1 1,2,2"), CellStatus::kTouching);
}

// A closed sheet round a bubble is not a body.
TEST(CurveFilter, SheetsHoldNothingInside) {
  const auto map = identity_cell();
  const TriangleMesh mesh =
      shapes::parse("box -1,-1,-1 2,2,2; box 7/16,7/16,7/16 9/16,9/16,9/16; flip");
  const auto box = micro_tiles::box({cq(1, 8), cq(1, 8), cq(1, 8)}, {cq(7, 8), cq(7, 8), cq(7, 8)});
  const TileFilter filter = std::move(TileFilter::make(mesh).value());
  EXPECT_EQ(filter.status({&map}, micro_tiles::shape_of(box)), CellStatus::kCrossing);
  const TileShape sheets = std::move(TileShape::make_open(box.patches).value());
  EXPECT_EQ(filter.status({&map}, sheets), CellStatus::kKept);
}

// One piece inside says nothing of another one.
TEST(CurveFilter, EachPieceIsAsked) {
  const TriangleMesh mesh = shapes::parse("box -1,-1,-1 1/2,2,2; box 5/8,-1,-1 2,2,2");
  const Polyline left{{cq(1, 8), cq(0), cq(0)}, {cq(1, 8), cq(1), cq(1)}};
  const Polyline gap{{cq(9, 16), cq(0), cq(1)}, {cq(9, 16), cq(1), cq(0)}};
  const Polyline right{{cq(7, 8), cq(0), cq(1)}, {cq(7, 8), cq(1), cq(0)}};
  EXPECT_EQ(find_lines(mesh, {left, right}).status, CellStatus::kKept);
  EXPECT_EQ(find_lines(mesh, {gap}).status, CellStatus::kOutside);
  const CellFinding found = find_lines(mesh, {left, gap, right});
  EXPECT_EQ(found.status, CellStatus::kCrossing);
  EXPECT_TRUE(found.inside && found.off);
}

// Both ends are off, and the middle dips into an edge of the solid by 2^-12.
TEST(CurveFilter, AShallowEdgeIsSeen) {
  const TriangleMesh mesh = shapes::parse("box 1/2,1/2,-1 2,2,2");
  EXPECT_EQ(
      find_lines(mesh, {{{cq(1, 4), cq(3, 4), cq(1, 3)}, {cq(3, 4), cq(1, 4), cq(1, 2)}}}).status,
      CellStatus::kTouching);
  EXPECT_EQ(find_lines(mesh, {{{cq(1, 4) + cq(1, 4096), cq(3, 4), cq(1, 3)},
                               {cq(3, 4) + cq(1, 4096), cq(1, 4), cq(1, 2)}}})
                .status,
            CellStatus::kCrossing);
  EXPECT_EQ(find_lines(mesh, {{{cq(1, 4) - cq(1, 4096), cq(3, 4), cq(1, 3)},
                               {cq(3, 4) - cq(1, 4096), cq(1, 4), cq(1, 2)}}})
                .status,
            CellStatus::kOutside);
}

// A segment in the plane of a face whose ends are off the face.
TEST(CurveFilter, ASegmentInAFaceTouches) {
  const TriangleMesh mesh = shapes::parse("box 1/4,1/4,-1 3/4,3/4,1/2");
  const CellFinding found =
      find_lines(mesh, {{{cq(0), cq(1, 8), cq(1, 2)}, {cq(1), cq(7, 8), cq(1, 2)}}});
  EXPECT_EQ(found.status, CellStatus::kTouching);
  ASSERT_TRUE(found.contact.has_value());
  EXPECT_EQ((*found.contact)[2], cq(1, 2));
}

// ---- the filter against truth

// The sides of points of a segment that tell all: between neighbouring ones no plane of the solid is crossed.
std::vector<int> sides_of_segment(const micro_truth::Solid& solid, const RVec& a, const RVec& b) {
  std::vector<Rational> at{Rational(0), Rational(1)};
  const auto cut = [&](const Rational& x, const Rational& y) {  // heights of a and b
    if (x == y) return;
    const Rational t = x / (x - y);
    if (Rational(0) < t && t < Rational(1)) at.push_back(t);
  };
  if (solid.convex)
    for (std::uint32_t f = 0; f < solid.convex_mesh.faces.size(); ++f) {
      using oracle::operator-;
      const auto t = oracle::rational_triangle(solid.convex_mesh, f);
      const RVec n = oracle::normal_of(t);
      cut(oracle::dot(n, a - t[0]), oracle::dot(n, b - t[0]));
    }
  else
    for (std::size_t c = 0; c < 3; ++c)
      for (int k = 0; k <= 6; ++k) cut(a[c] - Rational(k), b[c] - Rational(k));
  std::sort(at.begin(), at.end());
  std::vector<int> out;
  const auto look = [&](const Rational& t) {
    RVec p;
    for (std::size_t c = 0; c < 3; ++c) p[c] = a[c] + t * (b[c] - a[c]);
    out.push_back(solid.side(p));
  };
  for (std::size_t i = 0; i < at.size(); ++i) {
    look(at[i]);
    if (i + 1 < at.size()) look((at[i] + at[i + 1]) / Rational(2));
  }
  return out;
}
CellStatus status_of_sides(const std::vector<int>& sides) {
  const auto [least, most] = std::minmax_element(sides.begin(), sides.end());
  if (*least == 1) return CellStatus::kKept;
  if (*most == -1) return CellStatus::kOutside;
  return *least == -1 && *most == 1 ? CellStatus::kCrossing : CellStatus::kTouching;
}
std::string text_of_lines(const std::vector<Polyline>& lines) {
  std::string out;
  for (const Polyline& line : lines) {
    out += "\n line";
    for (const Point& p : line)
      for (const Rational& x : p) out += " " + x.to_string();
  }
  return out;
}
// Points on a grid, and corners of the tile that lie where the case wants them.
std::vector<Polyline> random_lines(Random& random, const micro_tiles::Tile& tile) {
  std::vector<Polyline> out(1 + random.below(3));
  for (Polyline& line : out) {
    const std::size_t n = 2 + random.below(3);
    for (std::size_t i = 0; i < n; ++i) {
      Point p;
      for (Rational& x : p) x = micro_truth::random_fraction(random, 0, 16, 16);
      if (random.below(2) == 0) p = tile.parts[random.below(tile.parts.size())][random.below(8)];
      if (line.empty() || line.back() != p) line.push_back(p);
    }
    if (line.size() < 2) line = {{cq(0), cq(0), cq(0)}, {cq(1), cq(1), cq(1)}};
  }
  return out;
}

TEST(CurveFilterDiff, EveryStatusOfPolylinesInAffineCellsIsRight) {
  std::array<int, 5> seen{};
  int touching_decided = 0, touching = 0;
  for (int n = 0; n < scaled(500); ++n) {
    Random random(kCurveSeed + static_cast<std::uint64_t>(n));
    const micro_truth::Case c = micro_truth::random_case(random, n % 2 != 0);
    const std::vector<Polyline> lines = random_lines(random, c.tile);
    const TileFilter filter = std::move(TileFilter::make(c.solid.mesh).value());
    const TileShape shape = shape_of_polylines(lines);
    const CellMap cell{&c.map};
    const CellFinding finding = filter.find(cell, shape);
    std::vector<int> sides;
    for (const Polyline& line : lines)
      for (std::size_t i = 0; i + 1 < line.size(); ++i)
        for (const int s : sides_of_segment(c.solid, c.cell(line[i]), c.cell(line[i + 1])))
          sides.push_back(s);
    const CellStatus truth = status_of_sides(sides);
    const std::string where = "seed " + std::to_string(kCurveSeed) + " case " + std::to_string(n) +
                              "\n" + c.text() + text_of_lines(lines);
    const bool is_open = finding.status == CellStatus::kUndecided;
    ASSERT_EQ(is_open ? CellStatus::kTouching : finding.status, truth) << where;
    ASSERT_EQ(micro_truth::fault_of(c, cell, shape, finding, std::nullopt), "") << where;
    ++seen[static_cast<std::size_t>(finding.status)];
    touching += truth == CellStatus::kTouching;
    touching_decided += finding.status == CellStatus::kTouching;
  }
  for (std::size_t s = 0; s < 4; ++s) EXPECT_GT(seen[s], 0) << s;
  EXPECT_GE(4 * touching_decided, 3 * touching) << touching_decided << " of " << touching;
}

TEST(CurveFilterDiff, ExactPointsOfCoilsInCurvedCellsContradictNoStatus) {
  std::array<int, 5> seen{};
  for (int n = 0; n < scaled(60); ++n) {
    Random random(kCurveSeed + 7000 + static_cast<std::uint64_t>(n));
    const micro_truth::Case c = micro_truth::random_curved_case(random, n % 2 != 0);
    const Rational radius = micro_truth::random_fraction(random, 1, 7, 32);
    const TileShape shape = open_shape(curves3_tile({radius, {}}).value());
    const TileFilter filter = std::move(TileFilter::make(c.solid.mesh).value());
    const CellMap cell{&c.map};
    const CellFinding finding = filter.find(cell, shape);
    const std::string where = "seed " + std::to_string(kCurveSeed + 7000) + " case " +
                              std::to_string(n) + "\n" + c.text();
    ASSERT_NE(finding.status, CellStatus::kUndecided) << where;
    ASSERT_EQ(micro_truth::fault_of(c, cell, shape, finding, std::nullopt), "") << where;
    std::vector<int> sides;
    for (std::uint32_t p = 0; p < shape.patches().size(); ++p)
      for (int i = 0; i <= 8; ++i)
        sides.push_back(c.solid.side(cell.image(shape, {p, cq(i, 8), Rational(0)})));
    const CellStatus truth = status_of_sides(sides);
    if (finding.status == CellStatus::kKept || finding.status == CellStatus::kOutside) {
      ASSERT_EQ(truth, finding.status) << where;
    }
    if (truth == CellStatus::kCrossing) {
      ASSERT_EQ(finding.status, CellStatus::kCrossing) << where;
    }
    ++seen[static_cast<std::size_t>(finding.status)];
  }
  for (const std::size_t s : {0u, 1u, 3u}) EXPECT_GT(seen[s], 0) << s;
}

TEST(CurveFilterDiff, PolylinesNearBallsOfPatchesAreRight) {
  std::array<int, 5> seen{};
  const PatchComplex cubic = make_patch_complex(round_truth::Solid{}.patches()).value();
  const PatchComplex polar =
      make_patch_complex(
          round_truth::Solid{round_truth::Solid::Kind::kPolarBall, Rational(1), {}}.patches())
          .value();
  const TileFilter filters[] = {TileFilter::make(cubic), TileFilter::make(polar)};
  for (int n = 0; n < scaled(120); ++n) {
    Random random(kCurveSeed + 9000 + static_cast<std::uint64_t>(n));
    const round_truth::Solid ball{
        n % 2 == 0 ? round_truth::Solid::Kind::kBall : round_truth::Solid::Kind::kPolarBall,
        Rational(1),
        {}};
    const PatchComplex complex = make_patch_complex(ball.patches()).value();
    std::vector<Polyline> lines;
    Point lo;
    const Rational size = micro_truth::random_fraction(random, 1, 40, 16);
    for (Rational& x : lo) x = micro_truth::random_fraction(random, -25, 20, 16);
    const auto map = micro_tiles::cage({1, 1, 1}, [&](const Point& u) {
      Point p;
      for (std::size_t c = 0; c < 3; ++c) p[c] = lo[c] + size * u[c];
      return p;
    });
    for (std::uint64_t i = random.below(3) + 1; i > 0; --i) {
      Polyline& line = lines.emplace_back();
      for (int k = 0; k < 3; ++k) {
        Point p;
        for (Rational& x : p) x = micro_truth::random_fraction(random, 0, 1009, 1009);
        line.push_back(p);
      }
    }
    bool is_kept = true, is_outside = true, meets_inside = false, meets_off = false;
    for (const Polyline& line : lines)
      for (std::size_t i = 0; i + 1 < line.size(); ++i) {
        std::array<RVec, 2> ends;
        for (std::size_t e = 0; e < 2; ++e)
          for (std::size_t c = 0; c < 3; ++c) ends[e][c] = lo[c] + size * line[i + e][c];
        const Rational least = round_truth::least_square(ends[0], ends[1]);
        const Rational most =
            std::max(oracle::dot(ends[0], ends[0]), oracle::dot(ends[1], ends[1]));
        is_kept = is_kept && most < Rational(1);
        is_outside = is_outside && least > Rational(1);
        meets_inside = meets_inside || least < Rational(1);
        meets_off = meets_off || most > Rational(1);
      }
    const CellStatus truth = is_kept                     ? CellStatus::kKept
                             : is_outside                ? CellStatus::kOutside
                             : meets_inside && meets_off ? CellStatus::kCrossing
                                                         : CellStatus::kTouching;
    const CellStatus found = filters[n % 2].status({&map}, shape_of_polylines(lines));
    if (truth != CellStatus::kTouching) {
      ASSERT_EQ(found, truth) << "seed " << kCurveSeed + 9000 << " case " << n
                              << text_of_lines(lines);
    }
    ++seen[static_cast<std::size_t>(found)];
  }
  for (const std::size_t s : {0u, 1u, 3u}) EXPECT_GT(seen[s], 0) << s;
}

// Axes of a curve's parameter and of the cell reversed, its degree raised, its pieces halved.
TEST(CurveFilterLaw, OtherDescriptionsAreOneQuestion) {
  for (int n = 0; n < scaled(40); ++n) {
    Random random(kCurveSeed + 11000 + static_cast<std::uint64_t>(n));
    const micro_truth::Case c = micro_truth::random_curved_case(random, n % 2 != 0);
    const TileFilter filter = std::move(TileFilter::make(c.solid.mesh).value());
    const MicroTile tile = curves3_tile({}).value();
    const CellStatus status = filter.status({&c.map}, open_shape(tile));
    std::vector<TileShape::Surface> others;
    for (const TilePatch& patch : tile.patches) {
      const auto s = surface_of_patch(patch);
      switch (random.below(3)) {
        case 0: others.push_back(elevate(s, 0, 2)); break;
        case 1: {
          TilePatch back = patch;
          std::reverse(back.points.front().begin(), back.points.front().end());
          others.push_back(surface_of_patch(back));
          break;
        }
        default:
          others.push_back(restricted(s, 0, Rational(0), cq(1, 3)));
          others.push_back(restricted(s, 0, cq(1, 3), Rational(1)));
      }
    }
    EXPECT_EQ(filter.status({&c.map}, TileShape::make_open(std::move(others)).value()), status)
        << "seed " << kCurveSeed + 11000 << " case " << n << "\n"
        << c.text();
  }
}

// ---- composition

TEST(ComposedCurves, AreTheImagesOfTheTilesCurves) {
  const auto cage = v_cells::cube(0, 0, 0);
  for (const MicroTile& tile : {curves3_tile({}).value(), curves3_tile({cq(1, 7), 5}).value(),
                                sheets_of(jack_tile({}).value())}) {
    const Microstructure micro = micro_cells::full({cage}, {2, 1, 3}, tile);
    const VModel model = make_v_model(micro.cage, VOrientation::kAuto).value();
    const std::vector<AnalysedTile> tiles{analysis_of_open(tile)};
    const ComposedSurface surface = ComposedSurface::make(micro, model, tiles).value();
    std::uint64_t curves = 0;
    for (const TilePatch& p : tile.patches) curves += p.is_curve();
    EXPECT_EQ(surface.num_patches(), 6 * tile.patches.size());
    EXPECT_EQ(surface.num_curves(), 6 * curves);
    const MicroGrid& grid = micro.grids[0];
    const auto all = surface.compose(0, surface.cells().size());
    for (std::size_t n = 0; n < all.size(); ++n) {
      const auto at = grid.shape().index_of(surface.cells()[n].cell);
      for (const ComposedPatch& p : all[n]) {
        const auto inner = surface_of_patch(tile.patches[p.patch]);
        EXPECT_EQ(p.surface.degree(1) == 0, tile.patches[p.patch].is_curve());
        for (const Rational& u : {Rational(0), cq(1, 3), Rational(1)}) {
          const auto x = evaluate<Rational, 2>(inner, {u, cq(2, 5)});
          std::array<Rational, 3> where;
          for (std::size_t a = 0; a < 3; ++a)
            where[a] =
                grid.breaks[a][at[a]] + (grid.breaks[a][at[a] + 1] - grid.breaks[a][at[a]]) * x[a];
          EXPECT_EQ((evaluate<Rational, 2>(p.surface, {u, cq(2, 5)})),
                    point(micro.cage[0], where).value());
        }
      }
    }
  }
}

TEST(ComposedCurves, HaveDegreesUpToTheLimitOfSplines) {
  MicroTile tile;
  tile.is_open = true;
  tile.patches.push_back(point_of_degree(7));
  const auto composed = [&](int degree) {
    BezierVolume<Rational> map =
        micro_tiles::cage({degree, degree, degree}, [](const Point& u) { return u; });
    const Microstructure micro = micro_cells::full({to_bspline(map)}, {1, 1, 1}, tile);
    const VModel model = make_v_model(micro.cage, VOrientation::kAuto).value();
    const std::vector<AnalysedTile> tiles{analysis_of_open(tile)};
    return ComposedSurface::make(micro, model, tiles).has_value();
  };
  EXPECT_TRUE(composed(3));   // 63
  EXPECT_FALSE(composed(4));  // 84
}

}  // namespace
}  // namespace veritope
