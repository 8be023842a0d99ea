// SPDX-License-Identifier: LGPL-3.0-or-later
// Edits of a V-complex, one by one: what they do, that they can be undone, and what they refuse.
#include "topology/v_complex_edit.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "tests/support/v_complex_shapes.h"
#include "topology/v_complex_boundary.h"
#include "topology/v_complex_homology.h"
#include "topology/v_complex_links.h"

namespace veritope {
namespace {

using v_shapes::complex_of;
using v_shapes::data_of;
using v_shapes::polycube;

template <class T>
std::string message_of(const Result<T>& result) {
  return result ? "none" : result.error().message;
}
#define EXPECT_REFUSED(complex, part, edit)                                            \
  do {                                                                                 \
    const VComplexTables before = (complex).tables();                                  \
    const auto result = (edit);                                                        \
    EXPECT_NE(message_of(result).find(part), std::string::npos) << message_of(result); \
    EXPECT_TRUE((complex).tables() == before);                                         \
  } while (false)

void expect_valid(const VComplex& complex, const VComplexCounts& counts) {
  const auto violation = validate(complex.tables());
  EXPECT_FALSE(violation) << violation->message;
  EXPECT_EQ(complex.counts(), counts);
}

// A use from a to b in this half-V-surface, or in any.
CurveUseId use_from_to(const VComplex& complex, std::uint32_t a, std::uint32_t b,
                       HalfVSurfaceId h = {}) {
  for (const CurveUseId u : complex.tables().uses)
    if (complex.start(u) == VPointId{a} && complex.end(u) == VPointId{b} &&
        (h.is_none() || complex.use(u).half_surface == h))
      return u;
  return {};
}

const VComplexCounts kCube{1, 6, 0, 6, 12, 8};

TEST(VComplexEdit, CellsAreAddedAndRemoved) {
  VComplex complex;
  const auto first = add_cell(complex, data_of({v_shapes::cube()}));
  const auto second = add_cell(complex, data_of({v_shapes::tetrahedron()}));
  ASSERT_TRUE(first && second);
  expect_valid(complex, {2, 10, 0, 10, 18, 12});
  EXPECT_TRUE(remove_cell(complex, first.value()));
  expect_valid(complex, {1, 4, 0, 4, 6, 4});
  EXPECT_TRUE(remove_cell(complex, second.value()));
  expect_valid(complex, {});
  EXPECT_REFUSED(complex, "there is no V-cell 0", remove_cell(complex, first.value()));
  EXPECT_REFUSED(complex, "a list of 2 V-cells",
                 add_cell(complex, data_of(polycube({{0, 0, 0}, {1, 0, 0}}))));
  EXPECT_REFUSED(complex, "the boundary is not closed",
                 add_cell(complex, data_of({{{{0, 1, 2}}}})));
}

TEST(VComplexEdit, ARemovedCellLeavesItsNeighbours) {
  VComplex complex = complex_of(v_shapes::three_in_an_l());
  EXPECT_TRUE(remove_cell(complex, VCellId{1}));
  // The curve and the points that only the removed cell connected are two now.
  expect_valid(complex, {2, 12, 0, 12, 24, 16});
  EXPECT_TRUE(is_manifold(complex));
}

// Gluing two cubes face to face by each of the four turns, and back.
TEST(VComplexEdit, GlueAndUnglueAreInverse) {
  for (std::uint32_t turn = 0; turn < 4; ++turn) {
    VComplex complex;
    ASSERT_TRUE(add_cell(complex, data_of({v_shapes::cube()})) &&
                add_cell(complex, data_of({v_shapes::cube()})));
    const auto a = complex.loops(HalfVSurfaceId{1})[0], b = complex.loops(HalfVSurfaceId{6})[0];
    ASSERT_TRUE(glue(complex, std::vector<UsePair>{{a[0], b[turn]}}));
    expect_valid(complex, {2, 11, 1, 12, 20, 12});
    EXPECT_EQ(complex.use(a[0]).mate, b[turn]);
    EXPECT_EQ(complex.mate(HalfVSurfaceId{1}), HalfVSurfaceId{6});
    EXPECT_EQ(complex.surface(complex.half_surface(HalfVSurfaceId{1}).surface).halves[0],
              HalfVSurfaceId{1});
    EXPECT_TRUE(is_manifold(complex));
    EXPECT_REFUSED(complex, "glued already", glue(complex, std::vector<UsePair>{{a[0], b[turn]}}));
    ASSERT_TRUE(unglue(complex, complex.half_surface(HalfVSurfaceId{1}).surface));
    expect_valid(complex, {2, 12, 0, 12, 24, 16});
    EXPECT_TRUE(complex.common(VCellId{0}, VCellId{1}).points.empty());
  }
}

// Cubes around an edge: the last gluing closes the fan, and every ungluing opens it without parting curves.
TEST(VComplexEdit, ACyclicFanOpensBeforeItParts) {
  VComplex complex = complex_of(polycube({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}));
  VCurveId axis;
  for (const VCurveId c : complex.tables().curves)
    if (complex.cells_of_curve(c).size() == 4) axis = c;
  ASSERT_FALSE(axis.is_none());
  EXPECT_TRUE(complex.fans(axis)[0].is_cyclic);
  const VComplexCounts closed = complex.counts();
  ASSERT_TRUE(unglue(complex, complex.surfaces_of_curve(axis)[0]));
  EXPECT_FALSE(complex.fans(axis)[0].is_cyclic);
  EXPECT_EQ(complex.half_surfaces_of_curve(axis).size(), 8u);
  // The two outer ends of the wall part: three curves and two points more.
  expect_valid(complex, {4, closed.surfaces + 1, closed.internal_surfaces - 1, 24,
                         closed.curves + 3, closed.points + 2});
  const auto walls = complex.surfaces_of_curve(axis);
  for (const VSurfaceId s : walls)
    if (complex.surface(s).is_internal()) {
      ASSERT_TRUE(unglue(complex, s));
    }
  expect_valid(complex, {4, 24, 0, 24, 48, 32});
}

TEST(VComplexEdit, GluingIsRefusedWhereLoopsDoNotFit) {
  VComplex complex = complex_of({v_shapes::triangular_prism()});
  ASSERT_TRUE(add_cell(complex, data_of({v_shapes::cube_with_window()})));
  const auto use = [&](std::uint32_t h, std::size_t loop = 0) {
    return complex.half_surface(HalfVSurfaceId{h}).loops[loop];
  };
  const auto glue_uses = [&](CurveUseId u, CurveUseId v) {
    return glue(complex, std::vector<UsePair>{{u, v}});
  };
  EXPECT_REFUSED(complex, "no uses to glue", glue(complex, {}));
  EXPECT_REFUSED(complex, "there is no use", glue_uses(use(0), CurveUseId{}));
  EXPECT_REFUSED(complex, "are one", glue_uses(use(0), use(0)));
  EXPECT_REFUSED(complex, "not equally long", glue_uses(use(0), use(2)));
  EXPECT_REFUSED(complex, "do not both have 1 loops", glue_uses(use(2), use(6)));
  const CurveUseId a = use(6, 0);
  EXPECT_REFUSED(complex, "do not both have 2 loops",
                 glue(complex, std::vector<UsePair>{{a, use(2)}, {use(6, 1), use(2)}}));
}

// Gluing alone never does that, because each use in a fan is opposite to the next one. Where two curves are identified
// that have other sides, it would.
TEST(VComplexEdit, NoCurveIsGluedToItsOwnReverse) {
  for (const bool is_opposite : {false, true}) {
    VComplex complex = complex_of({v_shapes::cube()});
    ASSERT_TRUE(add_cell(complex, data_of({v_shapes::cube()})));
    const CurveUseId u = complex.half_surface(HalfVSurfaceId{0}).loops[0];
    const CurveUseId v = complex.half_surface(HalfVSurfaceId{6}).loops[0];
    ASSERT_TRUE(identify_points(complex, complex.start(u),
                                is_opposite ? complex.end(v) : complex.start(v)));
    ASSERT_TRUE(
        identify_points(complex, complex.end(u), is_opposite ? complex.start(v) : complex.end(v)));
    const CurveUse with = complex.use(u), by = complex.use(v);
    ASSERT_TRUE(identify_curves(complex, with.curve, by.curve,
                                (with.is_forward == by.is_forward) == is_opposite));
    const std::vector<UsePair> pairs{{u, v}};
    if (is_opposite) {
      EXPECT_TRUE(glue(complex, pairs));
      expect_valid(complex, {2, 11, 1, 12, 20, 12});
    } else {
      EXPECT_REFUSED(complex, "its own reverse", glue(complex, pairs));
    }
  }
}

TEST(VComplexEdit, GlueWithTwoLoops) {
  VComplex complex;
  ASSERT_TRUE(add_cell(complex, data_of({v_shapes::cube_with_through_hole()})));
  ASSERT_TRUE(add_cell(complex, data_of({v_shapes::cube_with_through_hole()})));
  const auto a = complex.loops(HalfVSurfaceId{1}), b = complex.loops(HalfVSurfaceId{10});
  EXPECT_REFUSED(complex, "are there twice",
                 glue(complex, std::vector<UsePair>{{a[0][0], b[0][0]}, {a[0][1], b[1][0]}}));
  ASSERT_TRUE(glue(complex, std::vector<UsePair>{{a[0][0], b[0][0]}, {a[1][0], b[1][0]}}));
  expect_valid(complex, {2, 19, 1, 20, 40, 24});
  EXPECT_EQ(boundary_brep(complex).shells.at(0).genus(), 1);
  // Removing the wall makes one longer tube.
  ASSERT_TRUE(merge_cells(complex, complex.half_surface(HalfVSurfaceId{1}).surface));
  expect_valid(complex, {1, 18, 0, 18, 40, 24});
  EXPECT_EQ(boundary_of_cell(complex, VCellId{0}).at(0).genus(), 1);
}

TEST(VComplexEdit, CurvesAreSplitAndMerged) {
  VComplex complex = complex_of(polycube({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}));
  const VComplexCounts counts = complex.counts();
  for (const VCurveId c : {VCurveId{0}, VCurveId{7}, VCurveId{12}}) {
    const auto ends = complex.curve(c).ends;
    const auto split = split_curve(complex, c);
    ASSERT_TRUE(split);
    EXPECT_EQ(complex.curve(c).ends[0], ends[0]);
    EXPECT_EQ(complex.curve(split.value().curve).ends[1], ends[1]);
    EXPECT_EQ(complex.point(split.value().point).curves,
              (std::vector<VCurveId>{c, split.value().curve}));
    VComplexCounts more = counts;
    ++more.curves;
    ++more.points;
    expect_valid(complex, more);
    EXPECT_EQ(complex.half_surfaces_of_curve(c),
              complex.half_surfaces_of_curve(split.value().curve));
    ASSERT_TRUE(merge_curves(complex, split.value().point));
    expect_valid(complex, counts);
    EXPECT_EQ(complex.curve(c).ends, ends);
  }
  EXPECT_REFUSED(complex, "does not have two V-curves", merge_curves(complex, VPointId{0}));
  EXPECT_REFUSED(complex, "there is no V-curve", split_curve(complex, VCurveId{999}));
  EXPECT_REFUSED(complex, "there is no V-point", merge_curves(complex, VPointId{999}));
}

TEST(VComplexEdit, SurfacesAreSplitAndMerged) {
  for (const bool is_internal : {false, true}) {
    VComplex complex = complex_of(polycube({{0, 0, 0}, {1, 0, 0}}));
    const VComplexCounts counts = complex.counts();
    VSurfaceId s;
    for (const VSurfaceId at : complex.tables().surfaces)
      if (complex.surface(at).is_internal() == is_internal) s = at;
    const auto loop = complex.loops(complex.surface(s).halves[0])[0];
    const auto split = split_surface(complex, loop[0], loop[2]);
    ASSERT_TRUE(split) << message_of(split);
    const std::uint64_t halves = is_internal ? 2 : 1;
    expect_valid(complex, {2, counts.surfaces + 1, counts.internal_surfaces + halves - 1,
                           12 + halves, counts.curves + 1, counts.points});
    EXPECT_EQ(complex.loop(loop[0]).size(), 3u);
    EXPECT_EQ(complex.surface(split.value().surface).is_internal(), is_internal);
    EXPECT_EQ(complex.use(loop[0]).half_surface, complex.surface(split.value().surface).halves[0]);
    EXPECT_EQ(complex.fans(split.value().curve).at(0).is_cyclic, is_internal);
    ASSERT_TRUE(merge_surfaces(complex, split.value().curve));
    expect_valid(complex, counts);
    EXPECT_EQ(complex.loop(loop[0]), loop);
  }
}

TEST(VComplexEdit, AClosedCurveSplitsASurfaceToo) {
  VComplex complex = complex_of({v_shapes::cube()});
  const CurveUseId u = complex.half_surface(HalfVSurfaceId{0}).loops[0];
  const auto split = split_surface(complex, u, u);
  ASSERT_TRUE(split);
  expect_valid(complex, {1, 7, 0, 7, 13, 8});
  EXPECT_EQ(complex.curve(split.value().curve).ends[0], complex.curve(split.value().curve).ends[1]);
  ASSERT_TRUE(merge_surfaces(complex, split.value().curve));
  expect_valid(complex, kCube);
}

// A bridge between two loops of a face, and loops that go with the new part.
TEST(VComplexEdit, LoopsAreConnectedAndMoved) {
  VComplex complex = complex_of({v_shapes::cube_with_window()});
  const auto loops = complex.loops(HalfVSurfaceId{1});
  const auto bridge = split_surface(complex, loops[0][0], loops[1][2]);
  ASSERT_TRUE(bridge);
  EXPECT_TRUE(bridge.value().surface.is_none());
  expect_valid(complex, {1, 7, 0, 7, 17, 12});
  EXPECT_EQ(complex.loops(HalfVSurfaceId{1}).size(), 1u);
  EXPECT_EQ(complex.loop(loops[0][0]).size(), 10u);
  ASSERT_TRUE(merge_surfaces(complex, bridge.value().curve));
  expect_valid(complex, {1, 7, 0, 7, 16, 12});
  EXPECT_EQ(complex.loops(HalfVSurfaceId{1}).size(), 2u);

  EXPECT_REFUSED(
      complex, "does not split",
      split_surface(complex, loops[0][0], loops[1][2], std::vector<CurveUseId>{loops[1][0]}));
  EXPECT_REFUSED(
      complex, "is split, or moved twice",
      split_surface(complex, loops[0][0], loops[0][2], std::vector<CurveUseId>{loops[0][1]}));
  const auto split =
      split_surface(complex, loops[0][0], loops[0][2], std::vector<CurveUseId>{loops[1][0]});
  ASSERT_TRUE(split);
  const HalfVSurfaceId part = complex.surface(split.value().surface).halves[0];
  EXPECT_EQ(complex.use(loops[1][3]).half_surface, part);
  EXPECT_EQ(complex.half_surface(part).loops.size(), 2u);
  EXPECT_EQ(complex.half_surface(HalfVSurfaceId{1}).loops.size(), 1u);
  expect_valid(complex, {1, 8, 0, 8, 17, 12});
  ASSERT_TRUE(merge_surfaces(complex, split.value().curve));
  EXPECT_EQ(complex.half_surface(HalfVSurfaceId{1}).loops.size(), 2u);
  EXPECT_REFUSED(complex, "are not in one half-V-surface",
                 split_surface(complex, loops[0][0], CurveUseId{0}));
}

TEST(VComplexEdit, SurfacesThatCannotBeMergedAreNamed) {
  VComplex l = complex_of(v_shapes::three_in_an_l());
  for (const VCurveId c : l.tables().curves)
    if (l.cells_of_curve(c).size() == 3)
      EXPECT_REFUSED(l, "not between two V-surfaces", merge_surfaces(l, c));
  VComplex edge = complex_of(polycube({{0, 0, 0}, {1, 1, 0}}));
  EXPECT_REFUSED(edge, "several fans", merge_surfaces(edge, nonmanifold_curves(edge).at(0)));
  EXPECT_REFUSED(edge, "there is no V-curve", merge_surfaces(edge, VCurveId{999}));
  // A cube whose curves are merged away one by one, until one face bounds it, with a loop along both sides of each curve
  // that is left.
  VComplex cube = complex_of({v_shapes::cube()});
  std::uint64_t merged = 0;
  for (std::uint32_t c = 0; c < 12; ++c)
    merged += merge_surfaces(cube, VCurveId{c}).has_value() ? 1 : 0;
  EXPECT_FALSE(validate(cube.tables()));
  EXPECT_EQ(merged, 8u);
  EXPECT_EQ(cube.counts().surfaces, 1u);
  for (const VCurveId c : cube.tables().curves) EXPECT_FALSE(merge_surfaces(cube, c));
  VComplex data = complex_of({v_shapes::cube()});
  VComplexTables tables = data.tables();
  tables.cells[VCellId{0}].trivariates = {0, 1};
  tables.half_surfaces[HalfVSurfaceId{0}].trivariate = 1;
  VComplex two = VComplex::from_tables(tables).value();
  EXPECT_REFUSED(two, "different trivariates", merge_surfaces(two, VCurveId{0}));
}

// A ball of two digons, glued to each other after a half turn: projective space. Its only curve has the only V-surface on
// both sides, twice.
TEST(VComplexEdit, ACurveWithOneSurfaceOnBothSidesStays) {
  VComplexData data;
  data.num_points = 2;
  data.curves = {{0, 1}, {1, 0}};
  data.cells = {{{0}, {{0, {{{0, true}, {1, true}}}}, {0, {{{1, false}, {0, false}}}}}}};
  VComplex complex = make_v_complex(data).value();
  const auto loop = complex.loops(HalfVSurfaceId{1})[0];
  ASSERT_TRUE(glue(
      complex, std::vector<UsePair>{{complex.half_surface(HalfVSurfaceId{0}).loops[0], loop[0]}}));
  expect_valid(complex, {1, 1, 1, 2, 1, 1});
  EXPECT_TRUE(is_manifold(complex));
  EXPECT_EQ(betti_numbers(complex).value(), (std::array<std::uint64_t, 4>{1, 0, 0, 1}));
  EXPECT_REFUSED(complex, "one V-surface on both sides", merge_surfaces(complex, VCurveId{0}));
}

TEST(VComplexEdit, ACurveAroundAHandleStays) {
  VComplexData data;  // a solid torus, its boundary one annulus
  data.num_points = 1;
  data.curves = {{0, 0}};
  data.cells = {{{0}, {{0, {{{0, true}}, {{0, false}}}}}}};
  VComplex complex = make_v_complex(data).value();
  EXPECT_EQ(boundary_of_cell(complex, VCellId{0}).at(0).genus(), 1);
  EXPECT_REFUSED(complex, "around a handle", merge_surfaces(complex, VCurveId{0}));
}

// The apex of a pyramid whose opposite edges are identified has two curves, but four uses of them around its corner.
TEST(VComplexEdit, CurvesThatCrossAtAPointStay) {
  VComplex pyramid =
      complex_of({{{{0, 3, 2, 1}}, {{0, 1, 4}}, {{1, 2, 4}}, {{2, 3, 4}}, {{3, 0, 4}}}});
  for (std::uint32_t p = 0; p < 2; ++p) {
    const VCurveId c = pyramid.use(use_from_to(pyramid, p, 4)).curve,
                   d = pyramid.use(use_from_to(pyramid, p + 2, 4)).curve;
    ASSERT_TRUE(identify_points(pyramid, VPointId{p}, VPointId{p + 2}));
    ASSERT_TRUE(identify_curves(pyramid, c, d, false));
  }
  ASSERT_EQ(pyramid.point(VPointId{4}).curves.size(), 2u);
  EXPECT_REFUSED(pyramid, "more than two V-curve uses", merge_curves(pyramid, VPointId{4}));
}

// PROVES VCOMPLEX-4
TEST(VComplexEdit, CellsAreSplitAndMerged) {
  VComplex complex = complex_of({v_shapes::cube()});
  // Diagonals of bottom and top, and the two vertical curves at their ends.
  const HalfVSurfaceId bottom{0}, top{1};
  const auto starting = [&](HalfVSurfaceId h, std::uint32_t p) {
    for (const CurveUseId u : complex.loop(complex.half_surface(h).loops[0]))
      if (complex.start(u) == VPointId{p}) return u;
    return CurveUseId{};
  };
  ASSERT_TRUE(split_surface(complex, starting(bottom, 0), starting(bottom, 2)));
  ASSERT_TRUE(split_surface(complex, starting(top, 4), starting(top, 6)));
  const VComplexCounts before = complex.counts();
  const std::vector<CurveUseId> cycle{use_from_to(complex, 0, 2), use_from_to(complex, 2, 6),
                                      use_from_to(complex, 6, 4), use_from_to(complex, 4, 0)};
  const auto split = split_cell(complex, cycle, 0);
  ASSERT_TRUE(split) << message_of(split);
  expect_valid(complex, {2, 9, 1, 10, 14, 8});
  EXPECT_TRUE(is_manifold(complex));
  for (const VCellId c : complex.tables().cells)
    EXPECT_EQ(complex.cell(c).half_surfaces.size(), 5u);
  EXPECT_EQ(complex.neighbours(VCellId{0}), std::vector<VCellId>{split.value().cell});
  // What is on the left of the cycle stays.
  for (const CurveUseId u : cycle)
    EXPECT_EQ(complex.half_surface(complex.use(u).half_surface).cell, VCellId{0});
  ASSERT_TRUE(merge_cells(complex, split.value().surface));
  expect_valid(complex, before);
}

TEST(VComplexEdit, ACycleMustCloseAndMeetNoCornerTwice) {
  VComplex complex = complex_of({v_shapes::cube()});
  const auto loop = complex.loops(HalfVSurfaceId{0})[0];
  const auto split = [&](std::vector<CurveUseId> cycle, std::uint32_t trivariate = 0,
                         std::vector<HalfVSurfaceId> moved = {}) {
    return split_cell(complex, cycle, trivariate, moved);
  };
  EXPECT_REFUSED(complex, "without V-curves", split({}));
  EXPECT_REFUSED(complex, "there is no use", split({CurveUseId{}}));
  EXPECT_REFUSED(complex, "does not begin at the corner", split({loop[0], loop[1]}));
  EXPECT_REFUSED(complex, "passes use", split({loop[0], complex.use(loop[0]).across}));
  EXPECT_REFUSED(complex, "trivariate 3", split(loop, 3));
  EXPECT_REFUSED(complex, "has no half-V-surface", split(loop, 0, {HalfVSurfaceId{77}}));
  // The loop of a face: the new cell is a pillow of two faces, or all but one.
  ASSERT_TRUE(split(loop));
  expect_valid(complex, {2, 7, 1, 8, 12, 8});
}

TEST(VComplexEdit, ACycleIsNoFigureOfEight) {
  VComplex pyramid =
      complex_of({{{{0, 3, 2, 1}}, {{0, 1, 4}}, {{1, 2, 4}}, {{2, 3, 4}}, {{3, 0, 4}}}});
  std::vector<CurveUseId> cycle;
  constexpr std::array<std::uint32_t, 7> kPath{4, 0, 1, 4, 2, 3, 4};
  for (std::size_t i = 0; i < 6; ++i) cycle.push_back(use_from_to(pyramid, kPath[i], kPath[i + 1]));
  EXPECT_REFUSED(pyramid, "passes a corner of the V-cell twice", split_cell(pyramid, cycle, 0));
  cycle.resize(3);
  EXPECT_TRUE(split_cell(pyramid, cycle, 0));
  expect_valid(pyramid, {2, 6, 1, 7, 8, 5});
}

TEST(VComplexEdit, VoidsGoWithThePartThatIsNamed) {
  VComplex complex = complex_of({v_shapes::cube_with_void()});
  const auto loop = complex.loops(HalfVSurfaceId{0})[0];
  const auto split = split_cell(complex, loop, 0, std::vector<HalfVSurfaceId>{HalfVSurfaceId{7}});
  ASSERT_TRUE(split);
  EXPECT_EQ(boundary_of_cell(complex, VCellId{0}).size(), 1u);
  EXPECT_EQ(boundary_of_cell(complex, split.value().cell).size(), 2u);
  expect_valid(complex, {2, 13, 1, 14, 24, 16});
}

TEST(VComplexEdit, ARingIsCutAndJoined) {
  std::vector<HexahedralCell> cells(1);
  v_shapes::glue_faces(cells, 0, 0, 0, 1, 0);
  VComplex complex = hexahedral_v_complex(cells).value().complex;
  const VComplexCounts counts = complex.counts();
  VSurfaceId wall;
  for (const VSurfaceId s : complex.tables().surfaces)
    if (complex.surface(s).is_internal()) wall = s;
  const auto loop = complex.loops(complex.surface(wall).halves[0])[0];
  std::vector<CurveUseId> across;  // around the ring's section, seen from its walls
  for (const CurveUseId u : loop) across.insert(across.begin(), complex.use(u).across);
  ASSERT_TRUE(merge_cells(complex, wall));
  EXPECT_EQ(boundary_of_cell(complex, VCellId{0}).at(0).genus(), 1);
  EXPECT_FALSE(betti_numbers(complex));
  const auto cut = split_cell(complex, across, 0);
  ASSERT_TRUE(cut) << message_of(cut);
  EXPECT_TRUE(cut.value().cell.is_none());
  expect_valid(complex, counts);
  EXPECT_EQ(betti_numbers(complex).value(), (std::array<std::uint64_t, 4>{1, 1, 0, 0}));
}

// PROVES VCOMPLEX-4
TEST(VComplexEdit, CellsThatCannotBeMergedAreNamed) {
  VComplex complex = complex_of(polycube({{0, 0, 0}, {1, 0, 0}}));
  EXPECT_REFUSED(complex, "not there, or not inside", merge_cells(complex, VSurfaceId{999}));
  for (const VSurfaceId s : complex.tables().surfaces)
    if (!complex.surface(s).is_internal())
      EXPECT_REFUSED(complex, "not there, or not inside", merge_cells(complex, s));
  VComplexData data = data_of(polycube({{0, 0, 0}, {1, 0, 0}}));
  data.cells[1].trivariates = {0, 1};
  VComplex other = make_v_complex(data).value();
  EXPECT_REFUSED(other, "have other trivariates",
                 merge_cells(other, other.common(VCellId{0}, VCellId{1}).surfaces[0]));
  // The wall of a one-cell cylinder touches the axis from both sides of one cell.
  std::vector<HexahedralCell> cylinder(1);
  v_shapes::glue_faces(cylinder, 0, 2, 0, 3, 0);
  cylinder[0].faces[0].kind = HexahedralFace::Kind::kAlongFirst;
  VComplex round = hexahedral_v_complex(cylinder).value().complex;
  for (const VSurfaceId s : round.tables().surfaces)
    if (round.surface(s).is_internal())
      EXPECT_REFUSED(round, "on two sides in a V-cell", merge_cells(round, s));
  // The inner wall of a void, glued to the outer one: no part of space.
  VComplex shell = complex_of({v_shapes::cube_with_void()});
  const auto a = shell.loops(HalfVSurfaceId{0})[0], b = shell.loops(HalfVSurfaceId{6})[0];
  ASSERT_TRUE(glue(shell, std::vector<UsePair>{{a[0], b[0]}}));
  EXPECT_REFUSED(shell, "no disk on one surface",
                 merge_cells(shell, shell.half_surface(HalfVSurfaceId{0}).surface));
}

// A disk that touches itself at a corner of one cell, but not in the other one: a closed curve in a face of a cube, and
// what is beside it glued to a pentagon. Without the disk the boundary would be pinched.
// PROVES VCOMPLEX-4
TEST(VComplexEdit, ASurfaceThatMeetsItselfInACornerStays) {
  VComplex complex = complex_of({v_shapes::cube()});
  const CurveUseId u = complex.half_surface(HalfVSurfaceId{0}).loops[0];
  ASSERT_TRUE(split_surface(complex, u, u));
  ASSERT_TRUE(add_cell(complex, data_of({v_shapes::prism({0, 1, 2, 3, 4}, {5, 6, 7, 8, 9})})));
  const CurveUseId v = complex.half_surface(HalfVSurfaceId{7}).loops[0];
  ASSERT_EQ(complex.loop(u).size(), 5u);
  ASSERT_TRUE(glue(complex, std::vector<UsePair>{{u, v}}));
  const VSurfaceId wall = complex.half_surface(HalfVSurfaceId{0}).surface;
  EXPECT_REFUSED(complex, "meets itself at V-point", merge_cells(complex, wall));
}

TEST(VComplexEdit, PointsAndCurvesAreIdentified) {
  VComplex complex;
  ASSERT_TRUE(add_cell(complex, data_of({v_shapes::cube()})) &&
              add_cell(complex, data_of({v_shapes::cube()})));
  const VCurveId a = complex.use(use_from_to(complex, 0, 1)).curve,
                 b = complex.use(use_from_to(complex, 8, 9)).curve;
  EXPECT_REFUSED(complex, "have other V-points", identify_curves(complex, a, b, false));
  ASSERT_TRUE(identify_points(complex, VPointId{0}, VPointId{9}));
  EXPECT_EQ(link_of(complex, VPointId{0}).components.size(), 2u);
  ASSERT_TRUE(identify_points(complex, VPointId{1}, VPointId{8}));
  EXPECT_REFUSED(complex, "have other V-points", identify_curves(complex, a, b, false));
  ASSERT_TRUE(identify_curves(complex, a, b, true));
  expect_valid(complex, {2, 12, 0, 12, 23, 14});
  EXPECT_EQ(link_of(complex, a).open_fans, 2u);
  EXPECT_REFUSED(complex, "are not two V-curves", identify_curves(complex, a, a, false));
  EXPECT_REFUSED(complex, "are not two V-points",
                 identify_points(complex, VPointId{0}, VPointId{0}));
  EXPECT_EQ(complex.common(VCellId{0}, VCellId{1}).curves, std::vector<VCurveId>{a});
  ASSERT_TRUE(remove_cell(complex, VCellId{1}));
  expect_valid(complex, kCube);
}

TEST(VComplexEdit, UnglueNeedsAnInternalSurface) {
  VComplex complex = complex_of({v_shapes::cube()});
  EXPECT_REFUSED(complex, "not there, or not inside", unglue(complex, VSurfaceId{0}));
  EXPECT_REFUSED(complex, "not there, or not inside", unglue(complex, VSurfaceId{99}));
}

}  // namespace
}  // namespace veritope
