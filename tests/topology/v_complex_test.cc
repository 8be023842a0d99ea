// SPDX-License-Identifier: LGPL-3.0-or-later
// V-complexes from plain lists: counts, queries, and what is refused.
#include "topology/v_complex.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "tests/support/v_complex_shapes.h"

namespace veritope {
namespace {

using v_shapes::complex_of;
using v_shapes::data_of;

VComplexCounts counts_of(const std::vector<v_shapes::Polyhedron>& cells) {
  return complex_of(cells).counts();
}

TEST(VComplex, CountsTheElementsOfCellsOfAllKinds) {
  EXPECT_EQ(counts_of({v_shapes::cube()}), (VComplexCounts{1, 6, 0, 6, 12, 8}));
  EXPECT_EQ(counts_of({v_shapes::triangular_prism()}), (VComplexCounts{1, 5, 0, 5, 9, 6}));
  EXPECT_EQ(counts_of({v_shapes::tetrahedron()}), (VComplexCounts{1, 4, 0, 4, 6, 4}));
  EXPECT_EQ(counts_of({v_shapes::cube_with_through_hole()}),
            (VComplexCounts{1, 10, 0, 10, 24, 16}));
  EXPECT_EQ(counts_of({v_shapes::cube_with_window()}), (VComplexCounts{1, 7, 0, 7, 16, 12}));
  EXPECT_EQ(counts_of({v_shapes::cube_with_void()}), (VComplexCounts{1, 12, 0, 12, 24, 16}));
  EXPECT_EQ(VComplex().counts(), VComplexCounts());
}

TEST(VComplex, AFaceWithAHoleHasTwoLoops) {
  const VComplex complex = complex_of({v_shapes::cube_with_through_hole()});
  const auto loops = complex.loops(HalfVSurfaceId{0});
  ASSERT_EQ(loops.size(), 2u);
  EXPECT_EQ(loops[0].size(), 4u);
  for (const CurveUseId u : loops[1]) EXPECT_EQ(complex.use(u).half_surface, HalfVSurfaceId{0});
}

// [ME16] figure 3 and the numbers in its caption's paragraph.
TEST(VComplex, ThreeCubesInAnLAreThoseOfFigure3) {
  const VComplex complex = complex_of(v_shapes::three_in_an_l());
  EXPECT_EQ(complex.counts(), (VComplexCounts{3, 16, 2, 18, 28, 16}));
  std::size_t inner = 0;
  for (const VCurveId c : complex.tables().curves) {
    const std::size_t cells = complex.cells_of_curve(c).size();
    if (cells == 3) {  // the curve labelled 1
      ++inner;
      EXPECT_EQ(complex.surfaces_of_curve(c).size(), 4u);
      EXPECT_EQ(complex.half_surfaces_of_curve(c).size(), 6u);
      ASSERT_EQ(complex.fans(c).size(), 1u);
      EXPECT_FALSE(complex.fans(c)[0].is_cyclic);
      for (const VPointId p : complex.curve(c).ends) EXPECT_EQ(complex.point(p).curves.size(), 5u);
    } else if (cells == 1) {  // like the one labelled 2
      EXPECT_EQ(complex.surfaces_of_curve(c).size(), 2u);
      EXPECT_EQ(complex.half_surfaces_of_curve(c).size(), 2u);
    }
  }
  EXPECT_EQ(inner, 1u);
  const VCellId a{0}, b{1}, c{2};
  EXPECT_EQ(complex.neighbours(a), std::vector<VCellId>{b});
  EXPECT_EQ(complex.neighbours(b), (std::vector<VCellId>{a, c}));
  EXPECT_EQ(complex.common(a, b).surfaces.size(), 1u);
  EXPECT_EQ(complex.common(a, b).curves.size(), 4u);
  EXPECT_EQ(complex.common(a, b).points.size(), 4u);
  EXPECT_EQ(complex.common(a, c).surfaces.size(), 0u);
  EXPECT_EQ(complex.common(a, c).curves.size(), 1u);
  EXPECT_FALSE(complex.common(a, c).is_exactly_one_point());
}

TEST(VComplex, CellsCanMeetAtExactlyOnePoint) {
  const VComplex complex = complex_of(v_shapes::polycube({{0, 0, 0}, {1, 1, 1}}));
  EXPECT_TRUE(complex.common(VCellId{0}, VCellId{1}).is_exactly_one_point());
  const VPointId p = complex.common(VCellId{0}, VCellId{1}).points[0];
  EXPECT_EQ(complex.cells_of_point(p), (std::vector<VCellId>{VCellId{0}, VCellId{1}}));
  EXPECT_EQ(complex.point(p).curves.size(), 6u);
  EXPECT_EQ(complex.surfaces_of_point(p).size(), 6u);
}

TEST(VComplex, AMateIsTheOtherSideWithTheSameCurvesBackwards) {
  const VComplex complex = complex_of(v_shapes::polycube({{0, 0, 0}, {1, 0, 0}}));
  const VSurfaceId shared = complex.common(VCellId{0}, VCellId{1}).surfaces.at(0);
  const auto halves = complex.surface(shared).halves;
  EXPECT_EQ(complex.mate(halves[0]), halves[1]);
  EXPECT_EQ(complex.mate(halves[1]), halves[0]);
  for (const CurveUseId u : complex.loop(complex.half_surface(halves[0]).loops[0])) {
    const CurveUse &use = complex.use(u), &mate = complex.use(use.mate);
    EXPECT_EQ(use.curve, mate.curve);
    EXPECT_NE(use.is_forward, mate.is_forward);
    EXPECT_EQ(complex.use(use.next).mate, mate.previous);
  }
}

// Eight cubes around a point: an inner curve has one cyclic fan of four sectors, each half-V-surface beside its mate.
TEST(VComplex, AnInnerCurveHasACyclicFanInRadialOrder) {
  std::vector<std::array<std::uint32_t, 3>> cubes;
  for (std::uint32_t n = 0; n < 8; ++n) cubes.push_back({n & 1, n >> 1 & 1, n >> 2});
  const VComplex complex = complex_of(v_shapes::polycube(cubes));
  std::size_t cyclic = 0;
  for (const VCurveId c : complex.tables().curves) {
    const auto fans = complex.fans(c);
    ASSERT_EQ(fans.size(), 1u);
    const auto halves = complex.half_surfaces_of_curve(c);
    for (std::size_t i = 0; i < halves.size(); i += 2)
      EXPECT_EQ(complex.half_surface(halves[i]).cell, complex.half_surface(halves[i + 1]).cell);
    for (std::size_t i = 1; i + 1 < halves.size(); i += 2)
      EXPECT_EQ(complex.mate(halves[i]), halves[i + 1]);
    if (!fans[0].is_cyclic) {
      EXPECT_TRUE(complex.mate(halves.front()).is_none() && complex.mate(halves.back()).is_none());
      continue;
    }
    ++cyclic;
    EXPECT_EQ(halves.size(), 8u);
    EXPECT_EQ(complex.mate(halves.back()), halves.front());
    EXPECT_EQ(complex.cells_of_curve(c).size(), 4u);
  }
  EXPECT_EQ(cyclic, 6u);
}

// Right-handed: from the face x = 0, which the loop passes down, to y = 0 is clockwise from above; so the sector of the
// cube at a vertical curve through its corner (0, 0) begins with the half-V-surface on y = 0.
TEST(VComplex, FansTurnInTheRightHandedSense) {
  const VComplex complex = complex_of({v_shapes::prism({0, 1, 2, 3}, {4, 5, 6, 7})});
  for (const VCurveId c : complex.tables().curves) {
    if (complex.curve(c).ends != std::array<VPointId, 2>{VPointId{0}, VPointId{4}}) continue;
    const auto halves = complex.half_surfaces_of_curve(c);
    const auto has = [&](HalfVSurfaceId h, std::uint32_t p) {
      const auto loop = complex.loops(h)[0];
      return std::any_of(loop.begin(), loop.end(),
                         [&](CurveUseId u) { return complex.start(u) == VPointId{p}; });
    };
    EXPECT_TRUE(has(halves[0], 1));  // y = 0
    EXPECT_TRUE(has(halves[1], 3));  // x = 0
  }
}

TEST(VComplex, CompactingKeepsTheOrderOfAllElements) {
  const VComplex complex = complex_of(v_shapes::three_in_an_l());
  EXPECT_EQ(compacted(complex).tables(), complex.tables());
}

TEST(VComplex, FromTablesRefusesTablesThatAreNone) {
  VComplexTables tables = complex_of({v_shapes::cube()}).tables();
  EXPECT_TRUE(VComplex::from_tables(tables));
  tables.curves[VCurveId{3}].fans.clear();
  const auto made = VComplex::from_tables(tables);
  ASSERT_FALSE(made);
  EXPECT_EQ(made.error().code, Code::kBadArgument);
  EXPECT_NE(made.error().message.find("V-curve 3 has no fan"), std::string::npos);
}

// The error of the lists of two glued cubes after a change.
template <class Change>
std::string error_after(Change change) {
  VComplexData data = data_of(v_shapes::polycube({{0, 0, 0}, {1, 0, 0}}));
  change(data);
  const auto made = make_v_complex(data);
  if (made) return "none";
  EXPECT_EQ(made.error().code, Code::kBadArgument);
  return made.error().message;
}

#define EXPECT_ERROR(part, change)                                                      \
  EXPECT_NE(error_after([](VComplexData& d) { change; }).find(part), std::string::npos) \
      << error_after([](VComplexData& d) { change; })

TEST(VComplexData, IsRefusedWithThePlace) {
  EXPECT_EQ(error_after([](VComplexData&) {}), "none");
  EXPECT_ERROR("V-curve 2 ends at V-point 99", d.curves[2][1] = 99);
  EXPECT_ERROR("there is no V-curve 77", d.cells[1].half_surfaces[2].loops[0][1].curve = 77);
  EXPECT_ERROR("V-cell 1, half-V-surface 2: the loop is not closed",
               d.cells[1].half_surfaces[2].loops[0][1].is_forward ^= true);
  EXPECT_ERROR("has no loop", d.cells[0].half_surfaces[0].loops.clear());
  EXPECT_ERROR("a loop without V-curves", d.cells[0].half_surfaces[0].loops[0].clear());
  EXPECT_ERROR("V-cell 1 has no half-V-surface, or no trivariate",
               d.cells[1].half_surfaces.clear());
  EXPECT_ERROR("V-cell 1 has no half-V-surface, or no trivariate", d.cells[1].trivariates.clear());
  EXPECT_ERROR("trivariate 5 is not one of the V-cell's",
               d.cells[0].half_surfaces[3].trivariate = 5);
  EXPECT_ERROR("the boundary is not closed",
               d.cells[0].half_surfaces.erase(d.cells[0].half_surfaces.begin()));
  EXPECT_ERROR("used more than twice",
               d.cells[0].half_surfaces.push_back(d.cells[0].half_surfaces[0]));
  EXPECT_ERROR("no loop uses V-curve", d.curves.push_back({0, 1}));
  EXPECT_ERROR("no V-curve begins or ends at V-point", ++d.num_points);
  EXPECT_ERROR("there is no such half-V-surface", d.glued[0][1].half_surface = 6);
  EXPECT_ERROR("are one", d.glued[0][1] = d.glued[0][0]);
  EXPECT_ERROR("is glued twice", d.glued.push_back(d.glued[0]));
  EXPECT_ERROR("has no use that could be its mate", d.glued[0][1].half_surface = 0);
  EXPECT_ERROR("across: there is no such use",
               d.across.push_back({CurveUsePlace{0, 0, 1, 0}, {0, 0, 0, 0}}));
  EXPECT_ERROR("are not in one V-cell on one V-curve",
               d.across.push_back({CurveUsePlace{0, 0, 0, 1}, {0, 0, 0, 0}}));
  EXPECT_ERROR("mates: there is no such use",
               d.mates.push_back({CurveUsePlace{5, 0, 0, 0}, {0, 0, 0, 0}}));
  EXPECT_ERROR("is not glued in this way",
               d.mates.push_back({CurveUsePlace{0, 0, 0, 0}, {1, 0, 0, 0}}));
}

TEST(VComplexData, GluedHalvesMustHaveEquallyManyLoops) {
  VComplexData data = data_of({v_shapes::cube_with_window(), v_shapes::cube()}, false);
  data.glued.push_back({HalfVSurfacePlace{0, 1}, {1, 0}});
  const auto made = make_v_complex(data);
  ASSERT_FALSE(made);
  EXPECT_NE(made.error().message.find("not equally many loops"), std::string::npos);
}

// A cell that is glued to itself: the curves of its two ends are one, and used four times by the cell.
TEST(VComplexData, ARingNeedsToSayWhichUsesAreAcross) {
  VComplexData data = data_of({v_shapes::prism({0, 1, 2}, {3, 4, 5})}, false);
  for (auto& ends : data.curves)
    for (std::uint32_t& p : ends) p %= 3;
  data.num_points = 3;
  // Prism: faces 0 bottom, 1 top, 2 to 4 the sides, each from bottom to top. The top's curves become the bottom's.
  std::vector<std::array<std::uint32_t, 2>> curves;
  std::vector<std::uint32_t> number;
  std::vector<bool> is_turned;
  for (const auto& ends : data.curves) {
    std::uint32_t at = static_cast<std::uint32_t>(curves.size());
    bool turned = false;
    for (std::uint32_t i = 0; i < curves.size() && ends[0] != ends[1]; ++i) {
      if (curves[i] == ends) at = i;
      if (curves[i][0] == ends[1] && curves[i][1] == ends[0]) at = i, turned = true;
    }
    if (at == curves.size()) curves.push_back(ends);
    number.push_back(at);
    is_turned.push_back(turned);
  }
  for (HalfVSurfaceData& half : data.cells[0].half_surfaces)
    for (CurveUseData& use : half.loops[0])
      use = {number[use.curve], use.is_forward != is_turned[use.curve]};
  data.curves = curves;
  data.glued.push_back({HalfVSurfacePlace{0, 0}, {0, 1}});
  const auto ambiguous = make_v_complex(data);
  ASSERT_FALSE(ambiguous);
  EXPECT_NE(ambiguous.error().message.find("used more than twice"), std::string::npos);
  const auto& halves = data.cells[0].half_surfaces;
  for (std::uint32_t side = 2; side < 5; ++side)
    for (std::uint32_t cap = 0; cap < 2; ++cap)
      for (std::uint32_t i = 0; i < 3; ++i)
        if (halves[cap].loops[0][i].curve == halves[side].loops[0][0].curve)
          data.across.push_back({CurveUsePlace{0, cap, 0, i}, {0, side, 0, cap == 0 ? 0u : 2u}});
  const auto ring = make_v_complex(data);
  ASSERT_TRUE(ring) << ring.error().message;
  EXPECT_EQ(ring.value().counts(), (VComplexCounts{1, 4, 1, 5, 6, 3}));
}

}  // namespace
}  // namespace veritope
