// SPDX-License-Identifier: LGPL-3.0-or-later
#include "splines/composition_span.h"

#include <gtest/gtest.h>

#include "tests/splines/composition_draw.h"

namespace veritope {
namespace {

Rational ratio(int p, int q) { return Rational(p) / Rational(q); }

KnotAxis<Rational> axis(int degree, std::vector<int> knots) {
  return {degree, {knots.begin(), knots.end()}, false};
}

// Knots 0 0 0 2 2 3 5 5 5 and 0 1 2 3 4 (unclamped, domain [1, 3]).
BSpline<Rational, 2> draw_surface(Random& random, bool is_rational) {
  const std::array<KnotAxis<Rational>, 2> axes{axis(2, {0, 0, 0, 2, 2, 3, 5, 5, 5}),
                                               axis(1, {0, 1, 2, 3, 4})};
  std::vector<Rational> c;
  for (int i = 0; i < (2 + is_rational) * 6 * 3; ++i)
    c.push_back(i < 2 * 6 * 3 ? draw_rational(random)
                              : ratio(1 + static_cast<int>(random.below(9)), 4));
  return BSpline<Rational, 2>(axes, 2 + is_rational, is_rational, c);
}

// At a point, by the pieces of the whole map.
std::vector<Rational> value(const BSpline<Rational, 2>& map, const std::array<Rational, 2>& at) {
  const auto pieces = bezier_pieces(map);
  std::array<std::size_t, 2> cell{};
  std::array<Rational, 2> local;
  for (std::size_t a = 0; a < 2; ++a) {
    const auto& b = pieces.breaks[a];
    while (cell[a] + 2 < b.size() && b[cell[a] + 1] <= at[a]) ++cell[a];
    local[a] = (at[a] - b[cell[a]]) / (b[cell[a] + 1] - b[cell[a]]);
  }
  return evaluate(pieces.at(cell), local);
}

TEST(BezierPiece, IsThePieceThatTheWholeMapHas) {
  Random random(1);
  const auto map = draw_surface(random, true);
  const auto pieces = bezier_pieces(map);
  const std::size_t spans_u[] = {2, 4, 5}, spans_v[] = {1, 2};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 2; ++j)
      EXPECT_EQ(bezier_piece(map, {spans_u[i], spans_v[j]}), pieces.at({i, j}));
}

TEST(ComposeOnSpan, AgreesWithEvaluation) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const bool is_rational = seed % 2 == 1, inner_is_rational = seed % 4 >= 2;
    const auto outer = draw_surface(random, is_rational);
    // In [3, 5] x [2, 3], its ends included.
    Bezier<Rational, 1> curve({3}, 2 + inner_is_rational, inner_is_rational);
    for (std::size_t i = 0; i < 4; ++i) {
      const Rational w = inner_is_rational ? ratio(1 + static_cast<int>(random.below(5)), 3) : 1;
      curve.component(0)[i] = ratio(30 + static_cast<int>(random.below(21)), 10) * w;
      curve.component(1)[i] = ratio(20 + static_cast<int>(random.below(11)), 10) * w;
      if (inner_is_rational) curve.component(2)[i] = w;
    }
    const auto composed = compose_on_span(outer, curve);
    ASSERT_TRUE(composed) << to_string(composed.error());
    EXPECT_EQ(composed->degree(0), 9);
    for (int k = 0; k <= 4; ++k) {
      const auto p = evaluate(curve, {ratio(k, 4)});
      const Rational w = inner_is_rational ? p[2] : Rational(1);
      auto expected = value(outer, {p[0] / w, p[1] / w});
      if (inner_is_rational && !is_rational) expected.push_back(1);
      for (Rational& v : expected) v *= w * w * w;
      EXPECT_EQ(evaluate(*composed, {ratio(k, 4)}), expected);
    }
  }
}

Bezier<Rational, 1> segment(Rational u0, Rational v0, Rational u1, Rational v1) {
  return Bezier<Rational, 1>({1}, 2, false, {u0, u1, v0, v1});
}

TEST(ContainingSpan, ClosesTheSpansAndSkipsEmptyOnes) {
  Random random(2);
  const auto outer = draw_surface(random, false);
  using Spans = std::array<std::size_t, 2>;
  EXPECT_EQ(*containing_span(outer, segment(0, 1, 2, 2)), (Spans{2, 1}));
  EXPECT_EQ(*containing_span(outer, segment(2, 3, 3, 2)), (Spans{4, 2}));
  EXPECT_EQ(*containing_span(outer, segment(5, 3, 5, 3)), (Spans{5, 2}));
  EXPECT_EQ(*containing_span(outer, segment(2, 2, 2, 2)), (Spans{2, 1}));
}

TEST(ContainingSpan, RefusesAMapThatLeavesItsSpan) {
  Random random(3);
  const auto outer = draw_surface(random, false);
  const auto across = containing_span(outer, segment(1, 1, ratio(5, 2), 1));
  ASSERT_FALSE(across);
  EXPECT_EQ(across.error().code, Code::kBadArgument);
  EXPECT_EQ(across.error().message,
            "coordinate 0 of the inner map's control points, from 1 to 5/2, is in no knot span of "
            "the outer map");
  EXPECT_FALSE(
      containing_span(outer, segment(0, 0, 1, 1)));  // before the domain of the second axis
  EXPECT_FALSE(compose_on_span(outer, segment(4, 2, 6, 2)));
}

// A millionth of an ulp would not be seen in doubles; here the weights make 2 + 2^-60 of numbers that are doubles.
TEST(ContainingSpan, ComparesExactly) {
  const BSpline<double, 1> outer({KnotAxis<double>{1, {0, 0, 2, 3, 3}, false}}, 1, false,
                                 {0, 1, 2});
  const double tiny = 0x1p-60;
  EXPECT_TRUE(containing_span(outer, Bezier<double, 1>({1}, 2, true, {0, 2, 1, 1})));
  EXPECT_FALSE(
      containing_span(outer, Bezier<double, 1>({1}, 2, true, {0, 2, 1, 1 - tiny * 0x1p7})));
  EXPECT_FALSE(containing_span(outer, Bezier<double, 1>({1}, 2, true, {-tiny, 2, 1, 1})));
}

TEST(ContainingSpan, RefusesWeightsThatAreNotPositive) {
  const BSpline<double, 1> outer({KnotAxis<double>{1, {0, 0, 1, 1}, false}}, 1, false, {0, 1});
  const auto zero = containing_span(outer, Bezier<double, 1>({1}, 2, true, {0, 0.5, 1, 0}));
  ASSERT_FALSE(zero);
  EXPECT_EQ(zero.error().message, "control point 1 of the inner map has the weight 0");
}

TEST(ContainingSpan, RefusesTheWrongNumberOfCoordinates) {
  Random random(4);
  EXPECT_FALSE(compose_on_span(draw_surface(random, false), draw_map<1>(random, {1}, 3, false)));
}

TEST(ComposeOnSpan, OfDoublesIsNearTheExactMap) {
  const KnotAxis<double> knots{2, {0, 0, 0, 0.5, 1, 1, 1}, false};
  const BSpline<double, 1> outer({knots}, 1, false, {1, -1, 2, 0.5});
  const Bezier<double, 1> inner({2}, 1, false, {0.5, 0.625, 1});
  const auto composed = compose_on_span(outer, inner);
  ASSERT_TRUE(composed);
  const auto exact = compose(Bezier<Rational, 1>({2}, 1, false, {ratio(1, 2), 2, ratio(1, 2)}),
                             Bezier<Rational, 1>({2}, 1, false, {0, ratio(1, 4), 1}));
  for (std::size_t i = 0; i < 5; ++i)
    EXPECT_NEAR(composed->coefficients()[i], nearest_double(exact->coefficients()[i]), 1e-15);
}

}  // namespace
}  // namespace veritope
