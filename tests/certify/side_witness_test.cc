// SPDX-License-Identifier: LGPL-3.0-or-later
#include "verify/certify/side_witness.h"

#include <gtest/gtest.h>

#include <cmath>

#include "models/patch_shapes.h"
#include "robust/base/random.h"
#include "solids/patches/patch_transform.h"

namespace veritope {
namespace {

using patch_shapes::Patches;

PatchComplex complex_of(Patches patches, PatchOrientation orientation = PatchOrientation::kKeep) {
  PatchInput input;
  input.patches = std::move(patches);
  return make_patch_complex(std::move(input), orientation).value();
}
Patches unit_box() { return patch_shapes::box({0, 0, 0}, {1, 1, 1}); }
Patches without(Patches patches, std::size_t i) {
  patches.erase(patches.begin() + static_cast<std::ptrdiff_t>(i));
  return patches;
}
Patch bilinear(const std::array<PatchPoint, 4>& corners) {
  std::vector<Rational> c;
  for (std::size_t k = 0; k < 3; ++k)
    for (const PatchPoint& p : corners) c.push_back(p[k]);
  return make_patch(BezierSurface<Rational>({1, 1}, 3, false, c)).value();
}

// What the witness must say: numbers of arcs in both directions.
void expect_witness(const char* name, const Patches& patches, std::uint32_t same,
                    std::uint32_t opposite) {
  const PatchComplex complex = complex_of(patches);
  const auto w = find_side_witness(complex, {});
  ASSERT_TRUE(w) << name;
  EXPECT_EQ(broken_condition(complex, {}, *w), std::nullopt) << name;
  EXPECT_EQ(w->same, same) << name;
  EXPECT_EQ(w->opposite, opposite) << name;
}

// PROVES INVALID-2
TEST(SideWitness, NamesOpenBordersDirectionsAndOverusedEdges) {
  expect_witness("open box", without(unit_box(), 5), 1, 0);
  expect_witness("open octants", without(patch_shapes::octant_sphere(), 2), 1, 0);
  expect_witness("open PN torus", without(patch_shapes::pn_torus(12, 8), 17), 1, 0);
  Patches changed = unit_box();
  changed[2] = reversed(changed[2]);
  expect_witness("a face reversed", changed, 2, 0);
  expect_witness("blocks at an edge", patch_shapes::blocks({{0, 0, 0}, {1, 1, 0}}), 2, 2);
  Patches ulp = unit_box();
  Patch::Tensor map = ulp[5].tensor();
  for (Rational& z : map.component(2)) z = Rational::from_double(std::nextafter(1.0, 2.0));
  ulp[5] = make_patch(map).value();
  expect_witness("a face one ulp off", ulp, 1, 0);
}

// Two boxes share a face that both have; one of the two is taken away: along its border three sides are one curve.
TEST(SideWitness, OfThreeSides) {
  const Patches two =
      patch_shapes::joined({unit_box(), without(patch_shapes::box({1, 0, 0}, {2, 1, 1}), 0)});
  const PatchComplex complex = complex_of(two);
  const auto w = find_side_witness(complex, {});
  ASSERT_TRUE(w);
  EXPECT_EQ(w->same + w->opposite, 3u);
}

// Whatever is closed has no witness; neither has what only may be closed as a set of points.
TEST(SideWitness, NoneOfClosedModelsAndOfOtherParametrisations) {
  for (const auto& shape : patch_shapes::sound_shapes())
    EXPECT_FALSE(find_side_witness(complex_of(shape.patches), {})) << shape.name;
  // One face of the box in two halves: its border is that of its neighbours, as a set.
  Patches halves = without(unit_box(), 5);
  const Rational half = Rational(1) / Rational(2);
  halves.push_back(bilinear({PatchPoint{0, 0, 1}, {0, 1, 1}, {half, 0, 1}, {half, 1, 1}}));
  halves.push_back(bilinear({PatchPoint{half, 0, 1}, {half, 1, 1}, {1, 0, 1}, {1, 1, 1}}));
  const PatchComplex complex = complex_of(halves);
  ASSERT_FALSE(complex.is_closed_oriented_surface());
  EXPECT_FALSE(find_side_witness(complex, {}));
}

TEST(SideWitness, EachConditionIsNeeded) {
  const PatchComplex complex = complex_of(without(unit_box(), 5));
  const SideWitness good = find_side_witness(complex, {}).value();
  const auto expect = [&](const SideWitness& w, SideCondition condition,
                          const OuterSides& outer = {}) {
    EXPECT_EQ(broken_condition(complex, outer, w), condition);
  };
  EXPECT_EQ(broken_condition(complex, {}, good), std::nullopt);
  SideWitness w = good;
  w.arcs.clear();
  expect(w, SideCondition::kD1);
  w = good;
  w.arcs[0].side.side = 4;
  expect(w, SideCondition::kD1);
  w = good;
  w.arcs[0].side.patch = 5;
  expect(w, SideCondition::kD1);
  w = good;
  w.arcs[0].at = {1, 1, 1};
  expect(w, SideCondition::kD1);
  w = good;
  w.arcs[0].at = {0, 0, 2};  // beyond the end of the side
  expect(w, SideCondition::kD1);
  w = good;
  w.arcs.push_back(
      {{good.arcs[0].side.patch, (good.arcs[0].side.side + 2) % 4}, {1, 1, 1}});  // a point
  w.same = 2;
  expect(w, SideCondition::kD1);
  w.arcs[1].at = {1, 2, 3};  // it begins where the side ends
  expect(w, SideCondition::kD1);
  w = good;
  w.point_bits = 63;
  expect(w, SideCondition::kD1);
  w = good;
  w.point_bits = 0, w.point = 1;  // the other end
  expect(w, SideCondition::kD1);
  w = good;
  w.point = 0;  // an end of the arc
  expect(w, SideCondition::kD1);
  w = good;
  w.axis = 3;
  expect(w, SideCondition::kD1);
  w = good;
  w.arcs.push_back(w.arcs[0]);  // the same arc twice
  w.same = 2;
  expect(w, SideCondition::kD1);
  OuterSides inner(complex.patches().size(), 15);
  inner[good.arcs[0].side.patch] = 0;
  expect(good, SideCondition::kD1, inner);
  w = good;
  w.same = 2;
  expect(w, SideCondition::kD2);
  w = good;
  w.arcs.push_back(
      {{good.arcs[0].side.patch, (good.arcs[0].side.side + 2) % 4}, DyadicInterval::whole()});
  w.opposite = 1;  // another curve
  expect(w, SideCondition::kD2);
  for (std::uint8_t axis = 0; axis < 3; ++axis) {
    w = good;
    w.axis = axis;
    if (axis != good.axis) expect(w, SideCondition::kD3);  // the side runs along one axis
  }
  // An edge that two sides share: alone each is passed by the other one.
  for (std::uint32_t side = 0; side < 4; ++side) {
    if (!complex.mate({0, side})) continue;
    w = good;
    w.arcs[0] = {{0, side}, DyadicInterval::whole()};
    for (std::uint8_t axis = 0; axis < 3; ++axis) {
      w.axis = axis;
      const auto broken = broken_condition(complex, {}, w);
      EXPECT_TRUE(broken == SideCondition::kD3 || broken == SideCondition::kD4);
    }
    // Both: once in each direction is no defect.
    const PatchSide mate = *complex.mate({0, side});
    w.arcs.push_back({mate, DyadicInterval::whole()});
    w.opposite = 1;
    expect(w, SideCondition::kD2);
  }
}

TEST(SideWitness, HoldsForOtherDescriptions) {
  Random random(3);
  const Patches open = without(patch_shapes::torus(3, 1), 6);
  for (const Patches& patches : {relabelled(open, random), subdivided(open), elevated(open, 1)}) {
    const PatchComplex complex = complex_of(patches);
    const auto w = find_side_witness(complex, {});
    ASSERT_TRUE(w);
    // The same of the reversed patches: other numbers of sides, other directions.
    Patches changed;
    for (const Patch& p : complex.patches()) changed.push_back(reversed(p));
    const SideWitness r = with_reversed(complex, std::vector<bool>(patches.size(), true), *w);
    EXPECT_EQ(broken_condition(complex_of(changed), {}, r), std::nullopt);
  }
}

}  // namespace
}  // namespace veritope
