// SPDX-License-Identifier: LGPL-3.0-or-later
#include "splines/composition_integer.h"

#include <gtest/gtest.h>

#include <string>

#include "tests/splines/composition_draw.h"

namespace veritope {
namespace {

template <std::size_t M, std::size_t N>
void check_equality() {
  for (std::uint64_t seed = 0; seed < 24; ++seed) {
    Random random(seed);
    const auto outer = draw_map<M>(random, draw_degrees<M>(random, M == 3 ? 2 : 3),
                                   static_cast<int>(random.between(1, 3)), random.below(2) == 1);
    const auto inner =
        draw_map<N>(random, draw_degrees<N>(random, N == 3 ? 1 : 2), static_cast<int>(M), false);
    const auto direct = compose(outer, inner), cleared = compose_by_integers(outer, inner);
    ASSERT_TRUE(direct.has_value() && cleared.has_value());
    EXPECT_EQ(*direct, *cleared) << "seed " << seed << "\nouter " << text_of(outer) << "\ninner "
                                 << text_of(inner);
  }
}

TEST(CompositionByIntegers, IsTheCompositionOverRationals) {
  check_equality<1, 1>();
  check_equality<2, 1>();
  check_equality<3, 1>();
  check_equality<2, 2>();
  check_equality<3, 2>();
  check_equality<3, 3>();
}

TEST(CompositionByIntegers, LeavesZerosAndConstantsAsTheyAre) {
  Bezier<Rational, 3> outer({1, 1, 1}, 1, false);
  const Bezier<Rational, 1> inner({2}, 3, false);
  EXPECT_EQ(*compose_by_integers(outer, inner), *compose(outer, inner));
  for (Rational& x : outer.coefficients()) x = Rational(7) / Rational(3);
  const auto constant = compose_by_integers(outer, inner);
  for (const Rational& x : constant->coefficients()) EXPECT_EQ(x, Rational(7) / Rational(3));
}

TEST(CompositionByIntegers, RefusesWhatComposeRefuses) {
  const Bezier<Rational, 3> outer({1, 1, 1}, 1, false);
  EXPECT_EQ(compose_by_integers(outer, Bezier<Rational, 1>({1}, 2, false)).error().code,
            Code::kBadArgument);
  const Bezier<Rational, 3> high({63, 63, 63}, 1, false);
  EXPECT_EQ(compose_by_integers(high, Bezier<Rational, 3>({9, 9, 9}, 3, false)).error().code,
            Code::kOverLimit);
}

}  // namespace
}  // namespace veritope
