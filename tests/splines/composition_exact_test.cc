// SPDX-License-Identifier: LGPL-3.0-or-later
// By remainders, by integers and over Rational: the same map, bit for bit.
#include <gtest/gtest.h>

#include <cmath>

#include "splines/composition.h"
#include "splines/composition_exact.h"
#include "tests/splines/composition_draw.h"

namespace veritope {
namespace {

using internal::compose_exact_by;
using internal::ExactWay;

// Numbers of few bits, of all 53 and one magnitude, with exponents far apart, zeros among them.
double draw(Random& random, std::uint64_t kind) {
  const double v = 2 * random.unit() - 1;
  if (random.below(8) == 0) return 0;
  switch (kind) {
    case 0: return static_cast<double>(random.between(-8, 8)) * 0.25;
    case 1: return v;
    default: return std::ldexp(v, static_cast<int>(random.between(-1074, 1023)));
  }
}

template <std::size_t M, std::size_t N>
void check(std::uint64_t seeds) {
  for (std::uint64_t seed = 0; seed < seeds; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const auto [outer, inner] = draw_composable<M, N>(
        random, 2, N == 3 ? 1 : 2, [&] { return draw(random, seed % 3); },
        [&] { return draw(random, seed / 3 % 3); });
    const auto expected = compose(exact_map(outer), exact_map(inner));
    ASSERT_TRUE(expected);
    for (const ExactWay way : {ExactWay::kRemainders, ExactWay::kIntegers}) {
      const auto exact = compose_exact_by(way, outer, inner);
      ASSERT_TRUE(exact) << to_string(exact.error());
      EXPECT_EQ(exact->to_rational(), *expected)
          << "outer " << text_of(outer) << "\ninner " << text_of(inner);
    }
  }
}

TEST(CompositionExact, IsThatOfRationalsOnCurves) {
  check<1, 1>(45);
  check<2, 1>(27);
  check<3, 1>(18);
}
TEST(CompositionExact, IsThatOfRationalsOnSurfaces) {
  check<1, 2>(27);
  check<2, 2>(18);
  check<3, 2>(9);
}
TEST(CompositionExact, IsThatOfRationalsOnVolumes) {
  check<1, 3>(18);
  check<2, 3>(9);
  check<3, 3>(9);
}

Bezier<double, 3> draw_volume(Random& random, std::array<int, 3> degrees) {
  Bezier<double, 3> map(degrees, 3, false);
  for (double& v : map.coefficients()) v = random.unit();
  return map;
}

TEST(CompositionExact, OfTricubicVolumesIsThatOfIntegers) {
  Random random(1);
  const auto outer = draw_volume(random, {3, 3, 3}), inner = draw_volume(random, {2, 3, 3});
  const auto a = compose_exact(outer, inner),
             b = compose_exact_by(ExactWay::kIntegers, outer, inner);
  ASSERT_TRUE(a);
  EXPECT_EQ(a->scaled.size(), 3u * 19 * 28 * 28);
  EXPECT_EQ(a->exponent, b->exponent);
  EXPECT_EQ(a->scaled, b->scaled);
}

// A degree over 63 in one axis: sums of products of remainders are reduced in between.
TEST(CompositionExact, OfHighDegreeIsThatOfIntegers) {
  Random random(2);
  Bezier<double, 1> outer({15}, 2, false), inner({11}, 1, false);
  for (double& v : outer.coefficients()) v = random.unit();
  for (double& v : inner.coefficients()) v = random.unit();
  const auto a = compose_exact_by(ExactWay::kRemainders, outer, inner),
             b = compose_exact_by(ExactWay::kIntegers, outer, inner);
  ASSERT_EQ(a->degrees[0], 165);
  EXPECT_EQ(a->scaled, b->scaled);
  EXPECT_EQ(a->to_rational(), *compose(exact_map(outer), exact_map(inner)));
}

TEST(CompositionExact, TakesEveryFiniteDouble) {
  const Bezier<double, 1> outer({2}, 1, false, {0x1p-1074, -0x1.fffffffffffffp+1023, 1});
  const Bezier<double, 1> inner({1}, 1, false, {0x1p-1074, 0x1.fffffffffffffp+1023});
  const auto exact = compose_exact(outer, inner);
  ASSERT_TRUE(exact);
  EXPECT_EQ(exact->to_rational(), *compose(exact_map(outer), exact_map(inner)));
}

TEST(CompositionExact, ComputesWithIntegersWhatIsTooLongForRemainders) {
  Bezier<double, 1> outer({15}, 1, false), inner({1}, 1, false, {0x1p-1074, 0x1.8p+1023});
  outer.coefficients()[3] = 1;
  const auto exact = compose_exact(outer, inner);
  ASSERT_TRUE(exact);
  EXPECT_EQ(*exact->to_rational().coefficients().begin(),
            compose(exact_map(outer), exact_map(inner))->coefficients()[0]);
}

TEST(CompositionExact, OfZeroIsZero) {
  const Bezier<double, 2> outer({2, 1}, 2, false);
  const Bezier<double, 1> inner({2}, 2, false);
  const auto exact = compose_exact(outer, inner);
  ASSERT_TRUE(exact);
  EXPECT_EQ(exact->to_rational(), (Bezier<Rational, 1>({6}, 2, false)));
}

TEST(CompositionExact, RefusesWhatIsNotFinite) {
  const Bezier<double, 1> outer({1}, 1, false, {0, std::nan("")}), inner({1}, 1, false, {0, 1});
  EXPECT_EQ(compose_exact(outer, inner).error().code, Code::kNotFinite);
  EXPECT_EQ(compose_exact(inner, outer).error().message,
            "coefficient 1 of the inner map is not finite");
}

TEST(CompositionExact, RefusesMoreBitsThanTheLimit) {
  Bezier<double, 3> outer({9, 9, 9}, 3, false), inner({3, 3, 3}, 3, false);
  for (double& v : outer.coefficients()) v = 1;
  for (double& v : inner.coefficients()) v = 0x1p-1074;
  inner.coefficients()[0] = 0x1p1000;
  const auto exact = compose_exact(outer, inner);
  ASSERT_FALSE(exact);
  EXPECT_EQ(exact.error().code, Code::kOverLimit);
}

}  // namespace
}  // namespace veritope
