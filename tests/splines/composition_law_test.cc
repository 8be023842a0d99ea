// SPDX-License-Identifier: LGPL-3.0-or-later
// Composition agrees with evaluation, exactly, for every number of variables, polynomial and rational.
#include <gtest/gtest.h>

#include "splines/composition.h"
#include "tests/splines/composition_draw.h"

namespace veritope {
namespace {

template <std::size_t M, std::size_t N>
void check_at_points(Random& random, const Bezier<Rational, M>& outer,
                     const Bezier<Rational, N>& inner) {
  const auto composed = compose(outer, inner);
  ASSERT_TRUE(composed) << to_string(composed.error());
  ASSERT_EQ(composed->degrees(), composed_degrees(outer.degrees(), inner.degrees()));
  ASSERT_EQ(composed->is_rational(), outer.is_rational() || inner.is_rational());
  ASSERT_EQ(composed->dimension(), outer.dimension());
  for (int k = 0; k < 3; ++k) {
    std::array<Rational, N> at;
    for (Rational& t : at) t = draw_rational(random);
    auto through = evaluate(inner, at);
    const Rational w = inner.is_rational() ? through[M] : Rational(1);
    if (w.sign() == Sign::kZero) continue;
    std::array<Rational, M> point;
    for (std::size_t m = 0; m < M; ++m) point[m] = through[m] / w;
    auto expected = evaluate(outer, point);
    if (inner.is_rational() && !outer.is_rational()) expected.push_back(Rational(1));
    Rational power(1);
    for (const int a : outer.degrees())
      for (int i = 0; i < a; ++i) power *= w;
    for (Rational& v : expected) v *= power;
    EXPECT_EQ(evaluate(*composed, at), expected)
        << "outer " << text_of(outer) << "\ninner " << text_of(inner);
  }
}

template <std::size_t M, std::size_t N>
void check_agreement() {
  for (std::uint64_t seed = 0; seed < 12; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const bool outer_is_rational = random.below(2) == 1, inner_is_rational = random.below(2) == 1;
    const auto outer = draw_map<M>(random, draw_degrees<M>(random, M == 3 ? 2 : 3),
                                   static_cast<int>(random.between(1, 3)), outer_is_rational);
    const auto inner = draw_map<N>(random, draw_degrees<N>(random, N == 3 ? 1 : 2),
                                   static_cast<int>(M), inner_is_rational);
    check_at_points(random, outer, inner);
  }
}

TEST(Composition, OfCurvesAgreesWithEvaluation) {
  check_agreement<1, 1>();
  check_agreement<2, 1>();
  check_agreement<3, 1>();
}
TEST(Composition, OfSurfacesAgreesWithEvaluation) {
  check_agreement<1, 2>();
  check_agreement<2, 2>();
  check_agreement<3, 2>();
}
TEST(Composition, OfVolumesAgreesWithEvaluation) {
  check_agreement<1, 3>();
  check_agreement<2, 3>();
  check_agreement<3, 3>();
}

// The identity in Bernstein form leaves the map as it is.
TEST(Composition, WithTheIdentityChangesNothing) {
  Random random(5);
  const auto outer = draw_map<3>(random, {2, 3, 1}, 2, true);
  Bezier<Rational, 3> identity({1, 1, 1}, 3, false);
  for (std::size_t i = 0; i < 8; ++i)
    for (std::size_t m = 0; m < 3; ++m)
      identity.component(static_cast<int>(m))[i] = Rational(static_cast<int>(i >> (2 - m) & 1));
  const auto composed = compose(outer, identity);
  ASSERT_TRUE(composed);
  EXPECT_EQ(composed->degrees(), (std::array<int, 3>{6, 6, 6}));
  for (int k = 0; k < 10; ++k) {
    const std::array<Rational, 3> at{draw_rational(random), draw_rational(random),
                                     draw_rational(random)};
    EXPECT_EQ(evaluate(*composed, at), evaluate(outer, at));
  }
}

TEST(Composition, IsAssociative) {
  Random random(6);
  const auto f = draw_map<2>(random, {2, 1}, 3, false), g = draw_map<2>(random, {1, 2}, 2, false);
  const auto h = draw_map<1>(random, {2}, 2, false);
  EXPECT_EQ(*compose(*compose(f, g), h), *compose(f, *compose(g, h)));
}

TEST(Composition, RefusesTheWrongNumberOfCoordinates) {
  Random random(7);
  const auto composed =
      compose(draw_map<3>(random, {1, 1, 1}, 1, false), draw_map<1>(random, {1}, 2, false));
  ASSERT_FALSE(composed);
  EXPECT_EQ(composed.error().code, Code::kBadArgument);
  EXPECT_EQ(composed.error().message,
            "the points of the inner map have 2 coordinates, the outer map has 3 variables");
}

TEST(Composition, RefusesMoreCoefficientsThanTheLimit) {
  const Bezier<Rational, 3> outer({15, 15, 15}, 1, false), inner({15, 15, 15}, 3, false);
  const auto composed = compose(outer, inner);
  ASSERT_FALSE(composed);
  EXPECT_EQ(composed.error().code, Code::kOverLimit);
}

// A rational inner map has a component more than coordinates: its weight does not count as one.
TEST(Composition, CountsTheWeightAsNoCoordinate) {
  Random random(8);
  EXPECT_FALSE(compose(draw_map<2>(random, {1, 1}, 1, false), draw_map<1>(random, {1}, 1, true)));
  EXPECT_TRUE(compose(draw_map<2>(random, {1, 1}, 1, false), draw_map<1>(random, {1}, 2, true)));
}

}  // namespace
}  // namespace veritope
