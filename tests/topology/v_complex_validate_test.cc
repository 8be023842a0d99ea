// SPDX-License-Identifier: LGPL-3.0-or-later
// Each invariant of a V-complex is violated alone, and no change of one reference goes unnoticed.
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <set>
#include <utility>
#include <vector>

#include "tests/support/v_complex_shapes.h"
#include "topology/v_complex.h"

namespace veritope {
namespace {

VComplexTables two_cubes() {
  return v_shapes::complex_of(v_shapes::polycube({{0, 0, 0}, {1, 0, 0}})).tables();
}

// The invariant that a change violates first; 0 if none.
int violated_by(const std::function<void(VComplexTables&)>& change) {
  VComplexTables tables = two_cubes();
  change(tables);
  const auto violation = validate(tables);
  return violation ? static_cast<int>(violation->invariant) : 0;
}

CurveUseId first_mated(const VComplexTables& t) {
  for (const CurveUseId u : t.uses)
    if (!t.uses[u].mate.is_none()) return u;
  return {};
}

TEST(VComplexInvariants, HoldForCubes) {
  EXPECT_EQ(violated_by([](VComplexTables&) {}), 0);
}

TEST(VComplexInvariants, References) {
  EXPECT_EQ(violated_by([](auto& t) { t.uses[CurveUseId{5}].next = {}; }), 1);
  EXPECT_EQ(violated_by([](auto& t) { t.uses[CurveUseId{5}].across.value = 1000; }), 1);
  EXPECT_EQ(violated_by([](auto& t) { t.uses[CurveUseId{5}].curve = {}; }), 1);
  EXPECT_EQ(violated_by([](auto& t) { t.cells[VCellId{0}].half_surfaces.push_back({}); }), 1);
  EXPECT_EQ(violated_by([](auto& t) { t.surfaces[VSurfaceId{0}].halves[0] = {}; }), 1);
  EXPECT_EQ(
      violated_by([](auto& t) { t.half_surfaces[HalfVSurfaceId{2}].loops = {CurveUseId{999}}; }),
      1);
  EXPECT_EQ(violated_by([](auto& t) { t.curves[VCurveId{2}].ends[1] = {}; }), 1);
  EXPECT_EQ(violated_by([](auto& t) { t.curves[VCurveId{2}].fans.push_back({}); }), 1);
  EXPECT_EQ(violated_by([](auto& t) { t.points[VPointId{0}].curves.push_back({}); }), 1);
  EXPECT_EQ(violated_by([](auto& t) { t.points.remove(VPointId{0}); }), 1);
}

TEST(VComplexInvariants, Cells) {
  EXPECT_EQ(violated_by([](auto& t) { t.cells[VCellId{0}].half_surfaces.pop_back(); }), 2);
  EXPECT_EQ(
      violated_by([](auto& t) { t.cells[VCellId{0}].half_surfaces.push_back(HalfVSurfaceId{0}); }),
      2);
  EXPECT_EQ(violated_by([](auto& t) { t.half_surfaces[HalfVSurfaceId{0}].cell = VCellId{1}; }), 2);
  EXPECT_EQ(violated_by([](auto& t) { t.half_surfaces[HalfVSurfaceId{0}].trivariate = 7; }), 2);
  EXPECT_EQ(violated_by([](auto& t) { t.cells[VCellId{1}].trivariates.clear(); }), 2);
  EXPECT_EQ(violated_by([](auto& t) { t.cells.add({{0}, {}}); }), 2);
}

TEST(VComplexInvariants, Surfaces) {
  EXPECT_EQ(
      violated_by([](auto& t) { t.half_surfaces[HalfVSurfaceId{0}].surface = VSurfaceId{1}; }), 3);
  EXPECT_EQ(violated_by([](auto& t) { t.surfaces[VSurfaceId{0}].halves[1] = HalfVSurfaceId{0}; }),
            3);
  EXPECT_EQ(violated_by([](auto& t) { t.surfaces[VSurfaceId{0}].halves[1] = HalfVSurfaceId{1}; }),
            3);
  EXPECT_EQ(violated_by([](auto& t) { t.surfaces.add({{HalfVSurfaceId{0}, {}}}); }), 3);
}

TEST(VComplexInvariants, Loops) {
  EXPECT_EQ(violated_by(
                [](auto& t) { std::swap(t.uses[CurveUseId{0}].next, t.uses[CurveUseId{1}].next); }),
            4);
  EXPECT_EQ(violated_by([](auto& t) { t.uses[CurveUseId{0}].half_surface = HalfVSurfaceId{1}; }),
            4);
  EXPECT_EQ(violated_by([](auto& t) { t.half_surfaces[HalfVSurfaceId{0}].loops.clear(); }), 4);
  EXPECT_EQ(violated_by(
                [](auto& t) { t.half_surfaces[HalfVSurfaceId{0}].loops.push_back(CurveUseId{1}); }),
            4);
  EXPECT_EQ(violated_by([](auto& t) {
              CurveUse use = t.uses[CurveUseId{0}];  // a loop of its own that nothing lists
              use.next = use.previous = CurveUseId{t.uses.end_id()};
              t.uses.add(use);
            }),
            4);
}

TEST(VComplexInvariants, Ends) {
  EXPECT_EQ(violated_by([](auto& t) {
              std::swap(t.curves[VCurveId{0}].ends[0], t.curves[VCurveId{0}].ends[1]);
            }),
            5);
  EXPECT_EQ(violated_by([](auto& t) { t.uses[CurveUseId{3}].is_forward ^= true; }), 5);
}

TEST(VComplexInvariants, Across) {
  EXPECT_EQ(
      violated_by([](auto& t) { t.uses[CurveUseId{0}].across = t.uses[CurveUseId{1}].across; }), 6);
  EXPECT_EQ(violated_by([](auto& t) {  // to the other cell
              const CurveUseId u = first_mated(t), v = t.uses[u].mate, a = t.uses[u].across,
                               b = t.uses[v].across;
              t.uses[u].across = v, t.uses[v].across = u, t.uses[a].across = b,
              t.uses[b].across = a;
            }),
            6);
}

TEST(VComplexInvariants, Mates) {
  EXPECT_EQ(violated_by([](auto& t) { t.uses[first_mated(t)].mate = {}; }), 7);
  EXPECT_EQ(violated_by([](auto& t) {  // unglued by the surfaces only
              const CurveUseId u = first_mated(t);
              const HalfVSurfaceId mate = t.mate(t.uses[u].half_surface);
              t.surfaces[t.half_surfaces[mate].surface].halves[1] = {};
              t.half_surfaces[mate].surface = t.surfaces.add({{mate, {}}});
              if (t.surfaces[t.half_surfaces[t.uses[u].half_surface].surface].halves[0].is_none())
                FAIL();
            }),
            7);
  EXPECT_EQ(violated_by([](auto& t) {
              for (const CurveUseId u : t.uses)
                if (t.uses[u].mate.is_none()) {
                  t.uses[u].mate = t.uses[u].across;
                  return;
                }
            }),
            7);
}

TEST(VComplexInvariants, Fans) {
  EXPECT_EQ(violated_by([](auto& t) { t.curves[VCurveId{0}].fans.clear(); }), 8);
  EXPECT_EQ(violated_by([](auto& t) {
              t.curves[VCurveId{0}].fans[0] = t.uses[t.curves[VCurveId{0}].fans[0]].across;
            }),
            8);
  EXPECT_EQ(violated_by([](auto& t) {
              const auto fans = t.curves[VCurveId{0}].fans;
              t.curves[VCurveId{0}].fans.push_back(fans[0]);
            }),
            8);
  EXPECT_EQ(violated_by([](auto& t) {  // the second sector of an open fan
              for (const VCurveId c : t.curves) {
                CurveUseId& first = t.curves[c].fans[0];
                const CurveUseId mate = t.uses[t.uses[first].across].mate;
                if (mate.is_none()) continue;
                first = mate;
                return;
              }
            }),
            8);
}

TEST(VComplexInvariants, Points) {
  EXPECT_EQ(violated_by([](auto& t) { t.points[VPointId{0}].curves.pop_back(); }), 9);
  EXPECT_EQ(violated_by([](auto& t) {
              const VCurveId c = t.points[VPointId{0}].curves[0];
              t.points[VPointId{0}].curves.push_back(c);
            }),
            9);
  EXPECT_EQ(violated_by([](auto& t) { t.points.add({}); }), 9);
}

// Every reference is replaced by every other one of its kind: no lie passes, except where the list names a loop or a
// fan by another of its uses.
TEST(VComplexInvariants, NoticeEveryChangeOfOneReference) {
  const VComplexTables original =
      v_shapes::complex_of(
          {v_shapes::tetrahedron(), {{{1, 0, 2}}, {{1, 3, 0}}, {{2, 3, 1}}, {{0, 3, 2}}}})
          .tables();
  ASSERT_FALSE(validate(original));
  std::size_t changes = 0;
  const auto try_all = [&](auto get, std::uint32_t bound, bool may_be_none) {
    VComplexTables t = original;
    auto& id = get(t);
    const auto was = id;
    for (std::uint32_t value = 0; value <= bound; ++value) {
      id.value = value < bound ? value : 0xffffffffu;
      if (id == was || (id.is_none() && may_be_none && was.is_none())) continue;
      ++changes;
      ASSERT_TRUE(validate(t).has_value())
          << "a reference " << was.value << " was replaced by " << id.value;
    }
  };
  for (const CurveUseId u : original.uses) {
    const std::uint32_t uses = original.uses.end_id();
    try_all(
        [&](auto& t) -> auto& { return t.uses[u].next; }, uses, false);
    try_all(
        [&](auto& t) -> auto& { return t.uses[u].previous; }, uses, false);
    try_all(
        [&](auto& t) -> auto& { return t.uses[u].across; }, uses, false);
    try_all(
        [&](auto& t) -> auto& { return t.uses[u].mate; }, uses, true);
    try_all(
        [&](auto& t) -> auto& { return t.uses[u].curve; }, original.curves.end_id(), false);
    try_all(
        [&](auto& t) -> auto& { return t.uses[u].half_surface; }, original.half_surfaces.end_id(),
        false);
    VComplexTables t = original;
    t.uses[u].is_forward ^= true;
    EXPECT_TRUE(validate(t).has_value());
  }
  for (const HalfVSurfaceId h : original.half_surfaces) {
    try_all(
        [&](auto& t) -> auto& { return t.half_surfaces[h].cell; }, original.cells.end_id(), false);
    try_all(
        [&](auto& t) -> auto& { return t.half_surfaces[h].surface; }, original.surfaces.end_id(),
        false);
  }
  for (const VSurfaceId s : original.surfaces)
    for (unsigned k = 0; k < 2; ++k)
      try_all(
          [&](auto& t) -> auto& { return t.surfaces[s].halves[k]; },
          original.half_surfaces.end_id(), k == 1);
  for (const VCurveId c : original.curves)
    for (unsigned k = 0; k < 2; ++k)
      try_all(
          [&](auto& t) -> auto& { return t.curves[c].ends[k]; }, original.points.end_id(), false);
  EXPECT_GT(changes, 2000u);
}

}  // namespace
}  // namespace veritope
