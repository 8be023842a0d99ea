// SPDX-License-Identifier: LGPL-3.0-or-later
#include "verify/certify/side_witness.h"

#include <gtest/gtest.h>

#include <algorithm>
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

// A patch over a plane curve x(t), y(t), which is its side 3 run downwards: the opposite side lies at z = top. With
// weights the curve is rational, and x and y hold the products of coordinates and weights.
Patch strip_over(const std::vector<Rational>& x, const std::vector<Rational>& y, int top = 5,
                 const std::vector<Rational>& weights = {}) {
  std::vector<Rational> c;
  for (const auto* values : {&x, &y})
    for (const Rational& v : *values) c.insert(c.end(), 2, v);
  for (std::size_t i = 0; i < x.size(); ++i) c.push_back(Rational(0)), c.push_back(Rational(top));
  for (const Rational& w : weights) c.insert(c.end(), 2, w);
  const int degree = static_cast<int>(x.size()) - 1;
  const bool is_rational = !weights.empty();
  return make_patch(BezierSurface<Rational>({degree, 1}, is_rational ? 4 : 3, is_rational, c))
      .value();
}
// The side of a strip that lies over z = 0, and whether parameters run along it.
SideWitness on_curve(const Patch& strip, const DyadicInterval& arc, unsigned bits,
                     std::uint64_t point) {
  SideWitness w;
  for (std::uint32_t s = 0; s < strip.num_sides(); ++s) {
    const auto z = strip.side(s);
    const auto values = z.component(2);
    if (std::all_of(values.begin(), values.end(),
                    [](const Rational& v) { return v.sign() == Sign::kZero; }))
      w.arcs = {{{0, s}, arc}};
  }
  w.point_bits = bits, w.point = point, w.same = 1;
  return w;
}
// Whole sides over z = 0, one of each of the strips in this order, and their common middle.
SideWitness on_strips(const PatchComplex& complex, const std::vector<std::uint32_t>& strips,
                      std::uint32_t same, std::uint32_t opposite) {
  SideWitness w;
  for (const std::uint32_t p : strips) {
    const SideWitness one = on_curve(complex.patch(p), DyadicInterval::whole(), 1, 1);
    w.arcs.push_back({{p, one.arcs[0].side.side}, DyadicInterval::whole()});
  }
  w.point_bits = 1, w.point = 1, w.same = same, w.opposite = opposite;
  return w;
}
// The first of the three coordinates with which the witness holds, or why it does not with the best of them.
std::optional<SideCondition> best(const PatchComplex& complex, SideWitness w) {
  std::optional<SideCondition> out = SideCondition::kD1;
  for (w.axis = 0; w.axis < 3; ++w.axis) {
    const auto broken = broken_condition(complex, {}, w);
    if (!broken) return broken;
    if (*broken > *out) out = broken;
  }
  return out;
}

// The cubic x = s^2, y = s^3 - s passes (1, 0) for s = -1 and s = 1. Wherever these two lie among
// the parameters, an arc around one of them does not hold the other, and an arc around another
// point of the curve is a proof.
TEST(SideWitness, APointThatItsOwnSidePassesAgainIsNoProof) {
  for (std::uint64_t a = 1; a < 12; a += 3)
    for (std::uint64_t b = a + 3; b < 16; b += 4) {
      SCOPED_TRACE(std::to_string(a) + " / 16 and " + std::to_string(b) + " / 16");
      // s = p + q t with s(a / 16) = -1, s(b / 16) = 1; in Bernstein form by blossoms.
      const Rational q = Rational(32) / Rational(b - a), p = Rational(-1) - q * Rational(a) / 16;
      const Rational s0 = p, s1 = p + q;
      const Rational third = Rational(1) / Rational(3);
      const auto square = [&](const Rational& u, const Rational& v, const Rational& w) {
        return third * (u * v + v * w + w * u);
      };
      const auto cubic = [&](const Rational& u, const Rational& v, const Rational& w) {
        return u * v * w - third * (u + v + w);
      };
      const Patch strip = strip_over(
          {square(s0, s0, s0), square(s0, s0, s1), square(s0, s1, s1), square(s1, s1, s1)},
          {cubic(s0, s0, s0), cubic(s0, s0, s1), cubic(s0, s1, s1), cubic(s1, s1, s1)});
      const PatchComplex complex = complex_of({strip});
      const Patch& kept = complex.patch(0);
      for (const std::uint64_t at : {a, b}) {
        // Within 1 / 32 of the node, and of a place 1 / 32 further on.
        const DyadicInterval arc{5, 2 * at - 1, 2 * at + 1}, next{6, 4 * at + 1, 4 * at + 3};
        EXPECT_EQ(best(complex, on_curve(kept, arc, 4, at)), SideCondition::kD4);
        EXPECT_EQ(best(complex, on_curve(kept, next, 5, 2 * at + 1)), std::nullopt);
      }
    }
}

// x = t / (1 + 4 t^2) rises up to t = 1/2 and falls from there, though t and 1 + 4 t^2 rise: all
// but one of its points are passed twice.
TEST(SideWitness, ARationalCurveIsMonotoneAsAQuotient) {
  const Rational half = Rational(1) / Rational(2);
  std::vector<Rational> c;
  for (const Rational& x : {Rational(0), half, Rational(1)}) c.insert(c.end(), 2, x);
  c.insert(c.end(), 6, Rational(0));
  for (const int w : {1, 1, 5}) c.push_back(Rational(0)), c.push_back(Rational(5 * w));
  for (const int w : {1, 1, 5}) c.insert(c.end(), 2, Rational(w));
  const PatchComplex complex =
      complex_of({make_patch(BezierSurface<Rational>({2, 1}, 4, true, c)).value()});
  const Patch& kept = complex.patch(0);
  EXPECT_EQ(best(complex, on_curve(kept, DyadicInterval::whole(), 3, 3)), SideCondition::kD3);
  EXPECT_EQ(best(complex, on_curve(kept, {4, 4, 7}, 3, 3)), SideCondition::kD4);
}

// Some of the patches may be reversed, not all: sides and arcs of the others stay, and the point belongs to the first arc.
TEST(SideWitness, SidesOfReversedPatchesChangeAlone) {
  const PatchComplex complex = complex_of(without(unit_box(), 5));
  SideWitness w;
  w.arcs = {{{0, 1}, {3, 1, 4}}, {{1, 2}, {2, 0, 3}}};
  w.point_bits = 3, w.point = 3;
  const SideArc first{{0, 2}, {3, 4, 7}}, second{{1, 1}, {2, 1, 4}};
  for (const bool a : {false, true})
    for (const bool b : {false, true}) {
      const SideWitness r = with_reversed(complex, {a, b, false, false, false}, w);
      EXPECT_EQ(r.arcs[0], a ? first : w.arcs[0]);
      EXPECT_EQ(r.arcs[1], b ? second : w.arcs[1]);
      EXPECT_EQ(r.point, a ? 5u : 3u);
      EXPECT_EQ(r.point_bits, 3u);
    }
}

// The finest arcs that a certificate can name.
TEST(SideWitness, ArcsOfSixtyTwoBitsAreProofs) {
  const PatchComplex complex = complex_of({strip_over({0, 1}, {0, 0})});
  const Patch& kept = complex.patch(0);
  const std::uint64_t most = std::uint64_t{1} << 61;
  EXPECT_EQ(best(complex, on_curve(kept, {61, 0, 1}, 62, 1)), std::nullopt);
  EXPECT_EQ(best(complex, on_curve(kept, {61, most - 1, most}, 62, 2 * most - 1)), std::nullopt);
  EXPECT_EQ(best(complex, on_curve(kept, DyadicInterval::whole(), 62, most)), std::nullopt);
  EXPECT_EQ(best(complex, on_curve(kept, {62, most - 1, most + 1}, 62, most)), std::nullopt);
  EXPECT_EQ(best(complex, on_curve(kept, {63, 2 * most - 1, 2 * most + 1}, 62, most)),
            SideCondition::kD1);
  EXPECT_EQ(best(complex, on_curve(kept, DyadicInterval::whole(), 63, most)), SideCondition::kD1);
}

// Arcs of one side may have an end in common; D1 asks for inner points that no two share.
TEST(SideWitness, ArcsThatTouchAreTwoArcs) {
  const PatchComplex complex = complex_of({strip_over({0, 1}, {0, 0})});
  SideWitness w = on_curve(complex.patch(0), {1, 0, 1}, 2, 1);
  const PatchSide side = w.arcs[0].side;
  w.same = 2;
  w.arcs.push_back({side, {1, 1, 2}});
  EXPECT_EQ(broken_condition(complex, {}, w), SideCondition::kD2);
  std::swap(w.arcs[0], w.arcs[1]);
  w.point = 3;
  EXPECT_EQ(broken_condition(complex, {}, w), SideCondition::kD2);
  w.arcs[1].at = {2, 1, 3};
  EXPECT_EQ(broken_condition(complex, {}, w), SideCondition::kD1);
}

// Arcs of another side that begin in between hide no overlap.
TEST(SideWitness, ArcsThatOverlapAreFoundAmongThoseOfOtherSides) {
  const PatchComplex complex =
      complex_of({strip_over({0, 1}, {0, 0}), strip_over({0, 1}, {0, 0}, 6)});
  SideWitness w = on_strips(complex, {0, 1, 0}, 3, 0);
  w.arcs[1].at = {2, 1, 3};
  w.arcs[2].at = {1, 1, 2};
  EXPECT_EQ(broken_condition(complex, {}, w), SideCondition::kD1);
}

TEST(SideWitness, ThousandsOfEqualArcsAreFoundToOverlap) {
  const PatchComplex complex = complex_of({strip_over({0, 1}, {0, 0})});
  const SideWitness w = on_strips(complex, std::vector<std::uint32_t>(5000, 0), 5000, 0);
  EXPECT_EQ(broken_condition(complex, {}, w), SideCondition::kD1);
}

TEST(SideWitness, ArcsOfSeveralSidesAreAProofInAnyOrder) {
  const PatchComplex complex =
      complex_of({strip_over({0, 1}, {0, 0}, 5), strip_over({0, 1}, {0, 0}, 6),
                  strip_over({0, 1}, {0, 0}, 7)});
  std::vector<std::uint32_t> order{0, 1, 2};
  do {
    EXPECT_EQ(best(complex, on_strips(complex, order, 3, 0)), std::nullopt)
        << order[0] << " " << order[1] << " " << order[2];
  } while (std::next_permutation(order.begin(), order.end()));
}

// The second of two sides that run alike passes every point of the first one's arc.
TEST(SideWitness, AnArcOfOneSideCoversNoOtherSideOfItsEdge) {
  const PatchComplex complex =
      complex_of({strip_over({0, 1}, {0, 0}), strip_over({0, 1}, {0, 0}, 6)});
  for (const DyadicInterval& part : {DyadicInterval{2, 1, 3}, DyadicInterval::whole()}) {
    SideWitness w = on_strips(complex, {0, 1}, 2, 0);
    for (SideArc& arc : w.arcs) arc.at = part;
    EXPECT_EQ(best(complex, w), std::nullopt);
    w.same = 1;
    const SideArc second = w.arcs.back();
    w.arcs.pop_back();
    EXPECT_EQ(best(complex, w), SideCondition::kD4);
    w.arcs = {second};
    EXPECT_EQ(best(complex, w), SideCondition::kD4);
  }
}

TEST(SideWitness, ACurveIsCountedInAnyDegree) {
  const Rational half = Rational(1) / Rational(2);
  const PatchComplex complex =
      complex_of({strip_over({0, 1}, {0, 0}), strip_over({0, half, 1}, {0, 0, 0}, 6),
                  strip_over({1, half, 0}, {0, 0, 0}, 7)});
  EXPECT_EQ(best(complex, on_strips(complex, {0, 1, 2}, 2, 1)), std::nullopt);
  EXPECT_EQ(best(complex, on_strips(complex, {0, 1, 2}, 3, 0)), SideCondition::kD2);
}

// The others share some numbers with the first curve, all but the weights, or no number.
TEST(SideWitness, ACurveThatSharesNumbersWithTheFirstIsAnotherCurve) {
  const Patch line = strip_over({0, 1}, {0, 0});
  const Patch far = bilinear({PatchPoint{7, 8, 9}, {7, 9, 9}, {8, 8, 10}, {8, 9, 9}});
  for (const Patch& other : {strip_over({0, 1, 5}, {0, 0, 0}), strip_over({5, 0, 1}, {0, 0, 0}),
                             strip_over({1, 0, 5}, {0, 0, 0}), strip_over({5, 1, 0}, {0, 0, 0}),
                             strip_over({0, 1}, {0, 0}, 5, {1, 2}), far}) {
    const PatchComplex complex = complex_of({line, other});
    for (std::uint32_t side = 0; side < 4; ++side)
      for (const bool is_first : {false, true}) {
        SideWitness w = on_strips(complex, {0}, 2, 0);
        w.arcs.push_back({{1, side}, DyadicInterval::whole()});
        if (is_first) std::swap(w.arcs[0], w.arcs[1]);
        EXPECT_EQ(broken_condition(complex, {}, w), SideCondition::kD2);
      }
  }
}

// D4's hulls say nothing about a curve with a weight that is not positive.
TEST(SideWitness, NoneOfModelsWithWeightsThatAreNotPositive) {
  for (const int weight : {0, -1}) {
    Patches patches = without(unit_box(), 5);
    std::vector<Rational> c;
    for (const int v : {7, 7, 9, 9 * weight, 0, 1, 0, weight, 0, 0, 0, 0, 1, 1, 1, weight})
      c.push_back(Rational(v));
    patches.push_back(make_patch(BezierSurface<Rational>({1, 1}, 4, true, c)).value());
    const PatchComplex complex = complex_of(patches);
    ASSERT_EQ(complex.count(PatchDefect::kWeight), 1u);
    EXPECT_FALSE(find_side_witness(complex, {})) << weight;
  }
}

// The search takes the widest arc: the whole side if a coordinate is monotone along it.
TEST(SideWitness, ArcsAreAsWideAsACoordinateIsMonotone) {
  const auto straight = find_side_witness(complex_of(without(unit_box(), 5)), {});
  ASSERT_TRUE(straight);
  EXPECT_EQ(straight->arcs[0].at, DyadicInterval::whole());
  // The curve (t (1 - t), t^2 (1 - t)) returns to its origin: no coordinate is monotone along all of it.
  const Rational third = Rational(1) / Rational(3);
  const PatchComplex loop = complex_of({strip_over({0, third, third, 0}, {0, 0, third, 0})});
  const auto bent = find_side_witness(loop, {});
  ASSERT_TRUE(bent);
  EXPECT_EQ(bent->arcs[0].at, (DyadicInterval{3, 3, 5}));
}

// Findings of other kinds name whole patches, or nothing.
TEST(SideWitness, OtherFindingsArePassedOver) {
  Patches twice = unit_box();
  twice.push_back(twice[0]);
  const auto w = find_side_witness(complex_of(twice), {});
  ASSERT_TRUE(w);
  EXPECT_EQ(w->arcs.size(), 3u);
  PatchInput input;
  input.patches = unit_box();
  input.findings.emplace_back().defect = PatchDefect::kNotFinite;  // it names no patch
  EXPECT_FALSE(find_side_witness(make_patch_complex(std::move(input)).value(), {}));
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

TEST(DyadicInterval, APartOfTheUnitIntervalMayBeOnePoint) {
  const std::uint64_t most = std::uint64_t{1} << 62;
  for (const DyadicInterval& part : {DyadicInterval{0, 0, 1}, {0, 1, 1}, {3, 5, 5}, {62, 0, most}})
    EXPECT_TRUE(part.is_part_of_unit()) << part.bits << " " << part.lo << " " << part.hi;
  for (const DyadicInterval& other :
       {DyadicInterval{0, 0, 2}, {3, 5, 4}, {62, 0, most + 1}, {63, 0, 1}})
    EXPECT_FALSE(other.is_part_of_unit()) << other.bits << " " << other.lo << " " << other.hi;
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
  // Two more that would do as numbers, if they were the first curve run backwards.
  w = good;
  for (std::uint32_t p = 0; p < complex.patches().size(); ++p)
    for (std::uint32_t side = 0; side < 4; ++side)
      if (!complex.mate({p, side}) && PatchSide{p, side} != good.arcs[0].side && w.arcs.size() < 3)
        w.arcs.push_back({{p, side}, DyadicInterval::whole()});
  ASSERT_EQ(w.arcs.size(), 3u);
  w.same = 1, w.opposite = 2;
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
    // Both: once in each direction is not a defect.
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
    // The witness also proves it for the reversed patches, whose sides have other numbers and directions.
    Patches changed;
    for (const Patch& p : complex.patches()) changed.push_back(reversed(p));
    const SideWitness r = with_reversed(complex, std::vector<bool>(patches.size(), true), *w);
    EXPECT_EQ(broken_condition(complex_of(changed), {}, r), std::nullopt);
  }
}

}  // namespace
}  // namespace veritope
