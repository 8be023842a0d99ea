// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/patches/side_overlaps.h"

#include <gtest/gtest.h>

#include "tests/solids/patch_support.h"
#include "splines/bezier_degree.h"
#include "splines/bezier_domain.h"

namespace veritope {
namespace {

Rational q(int n, int d = 1) { return Rational(Integer(n), Integer(d)); }

// A ruled patch from the curve down to the curve moved by -1 along z; its side 2 is the curve run backwards.
Patch ruled(const Patch::Curve& curve) {
  const int n = curve.degree(0);
  Patch::Tensor map({n, 1}, curve.num_components(), curve.is_rational());
  for (int c = 0; c < curve.num_components(); ++c)
    for (std::size_t i = 0; i <= static_cast<std::size_t>(n); ++i) {
      const Rational weight = curve.is_rational() ? curve.component(3)[i] : Rational(1);
      map.component(c)[2 * i + 1] = curve.component(c)[i];
      map.component(c)[2 * i] = curve.component(c)[i] - (c == 2 ? weight : Rational(0));
    }
  return make_patch(std::move(map)).value();
}
Patch::Curve curve_of(std::vector<std::array<int, 3>> points) {
  Patch::Curve out({static_cast<int>(points.size()) - 1}, 3, false);
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t c = 0; c < 3; ++c)
      out.component(static_cast<int>(c))[i] = Rational(points[i][c]);
  return out;
}
// The curve after t -> q t / (1 - t + q t), as a rational curve.
Patch::Curve projectively_changed(const Patch::Curve& curve, const Rational& factor) {
  Patch::Curve out(curve.degrees(), 4, true);
  Rational weight(1);
  for (std::size_t i = 0; i <= static_cast<std::size_t>(curve.degree(0)); ++i) {
    for (int c = 0; c < 3; ++c) out.component(c)[i] = curve.component(c)[i] * weight;
    out.component(3)[i] = weight;
    weight *= factor;
  }
  return out;
}

const Patch::Curve kCubic = curve_of({{0, 0, 0}, {1, 2, 0}, {3, -1, 0}, {4, 1, 0}});
// The cubic and its first third.
Patches with_part() { return {ruled(kCubic), ruled(restricted(kCubic, 0, q(0), q(1, 3)))}; }
constexpr std::uint32_t kTop = 2;  // the side of a ruled patch that is its curve

// The overlap of the upper sides of two ruled patches.
std::vector<SideOverlap> overlaps_of(const Patch::Curve& a, const Patch::Curve& b) {
  const PatchComplex complex = complex_of({ruled(a), ruled(b)});
  std::vector<SideOverlap> out = find_side_overlaps(complex).found;
  std::erase_if(
      out, [](const SideOverlap& o) { return o.sides[0].side != kTop || o.sides[1].side != kTop; });
  return out;
}

TEST(SideOverlaps, APartOfASideIsAffineAndItsInnerEndIsATJunction) {
  const PatchComplex complex = complex_of(with_part());
  const SideOverlaps overlaps = find_side_overlaps(complex);
  EXPECT_TRUE(overlaps.is_complete);
  EXPECT_TRUE(overlaps.undecided.empty());
  const auto junctions = t_junctions_of(complex, overlaps.found);
  ASSERT_EQ(junctions.size(), 2u);  // the lower sides have one, too
  const TJunction& top = junctions[0].side.side == kTop ? junctions[0] : junctions[1];
  EXPECT_EQ(top.side, (PatchSide{0, kTop}));
  EXPECT_EQ(top.at, q(2, 3));  // the side runs against the curve
  EXPECT_EQ(top.neighbour, (PatchSide{1, kTop}));
  EXPECT_EQ(top.corner, (PatchCorner{1, 2}));
}

TEST(SideOverlaps, SidesThatOverlapInTheMiddleHaveATJunctionEach) {
  const auto a = restricted(kCubic, 0, q(0), q(2, 3)),
             b = reversed(restricted(kCubic, 0, q(1, 3), q(1)), 0);
  const auto found = overlaps_of(a, b);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].agreement, CurveAgreement::kAffine);
  EXPECT_EQ(found[0].at[0], (std::array{q(0), q(1, 2)}));
  EXPECT_EQ(found[0].at[1], (std::array{q(1, 2), q(0)}));
}

TEST(SideOverlaps, DegreesAndFactorsOfWeightsDoNotMatter) {
  const auto part = restricted(kCubic, 0, q(1, 4), q(3, 4));
  const auto raised = elevate(part, 0, 2);
  Patch::Curve rational(raised.degrees(), 4, true);
  for (std::size_t i = 0; i < 6; ++i) {
    for (int c = 0; c < 3; ++c) rational.component(c)[i] = raised.component(c)[i] * q(3);
    rational.component(3)[i] = q(3);
  }
  const auto found = overlaps_of(kCubic, rational);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].agreement, CurveAgreement::kAffine);
  EXPECT_EQ(found[0].at[0], (std::array{q(1, 4), q(3, 4)}));
}

TEST(SideOverlaps, OtherSpeedsAreToldApart) {
  const auto projective = overlaps_of(kCubic, projectively_changed(kCubic, q(2)));
  ASSERT_EQ(projective.size(), 1u);
  EXPECT_EQ(projective[0].agreement, CurveAgreement::kProjective);
  const auto line = curve_of({{0, 0, 0}, {4, 4, 0}}),
             uneven = curve_of({{0, 0, 0}, {1, 1, 0}, {4, 4, 0}});
  const auto one_curve = overlaps_of(line, uneven);
  ASSERT_EQ(one_curve.size(), 1u);
  EXPECT_EQ(one_curve[0].agreement, CurveAgreement::kOneCurve);
  const PatchComplex complex = complex_of({ruled(line), ruled(uneven)});
  EXPECT_TRUE(t_junctions_of(complex, find_side_overlaps(complex).found).empty());
}

TEST(SideOverlaps, CurvesThatShareEndsOnlyDoNotOverlap) {
  EXPECT_TRUE(overlaps_of(kCubic, curve_of({{0, 0, 0}, {4, 1, 0}})).empty());
  EXPECT_TRUE(overlaps_of(kCubic, curve_of({{0, 0, 0}, {1, 2, 1}, {3, -1, 0}, {4, 1, 0}})).empty());
}

// The halves of a circle lie on one algebraic curve and have their ends in common: (1, 0) and (-1, 0).
TEST(SideOverlaps, TwoArcsOfOneCircleDoNotOverlap) {
  const auto half = [](int sign) {
    Patch::Curve out({4}, 4, true);
    const Rational x[] = {q(1), q(1), q(0), q(-2), q(-4)}, y[] = {q(0), q(1), q(2), q(2), q(0)},
                   w[] = {q(1), q(1), q(4, 3), q(2), q(4)};
    for (std::size_t i = 0; i < 5; ++i) {
      out.component(0)[i] = x[i], out.component(1)[i] = y[i] * q(sign);
      out.component(3)[i] = w[i];
    }
    return out;
  };
  EXPECT_TRUE(overlaps_of(half(1), half(-1)).empty());
  EXPECT_EQ(overlaps_of(half(1), restricted(half(1), 0, q(1, 4), q(1))).size(), 1u);
}

// A corner on a straight side whose parameter is the root of 2 t^2 = 1: the side's own points are uneven.
TEST(SideOverlaps, AnIrrationalParameterIsNotDecided) {
  const auto uneven = curve_of({{0, 0, 0}, {0, 0, 0}, {2, 0, 0}}),
             half = curve_of({{0, 0, 0}, {1, 0, 0}});
  const PatchComplex complex = complex_of({ruled(uneven), ruled(half)});
  const SideOverlaps overlaps = find_side_overlaps(complex);
  EXPECT_TRUE(overlaps.found.empty());
  EXPECT_FALSE(overlaps.undecided.empty());
}

TEST(SideOverlaps, TheNumberOfPairsIsBounded) {
  const PatchComplex complex = complex_of(with_part());
  EXPECT_FALSE(find_side_overlaps(complex, 1).is_complete);
}

}  // namespace
}  // namespace veritope
