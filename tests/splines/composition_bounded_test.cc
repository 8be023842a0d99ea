// SPDX-License-Identifier: LGPL-3.0-or-later
// No coefficient is farther from the exact one than its bound says. The oracle is compose_exact, which composition_exact_test.cc
// compares with Rational.
#include <gtest/gtest.h>

#include <cfenv>
#include <cmath>
#include <limits>

#include "splines/composition.h"
#include "splines/composition_bounded.h"
#include "splines/composition_exact.h"
#include "tests/splines/composition_draw.h"

namespace veritope {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

template <std::size_t M, std::size_t N>
void expect_within_bounds(const Bezier<double, M>& outer, const Bezier<double, N>& inner) {
  const auto bounded = compose_bounded(outer, inner);
  ASSERT_TRUE(bounded) << to_string(bounded.error());
  const auto scaled = compose_exact(outer, inner);
  ASSERT_TRUE(scaled);
  const auto exact = scaled->to_rational();
  ASSERT_EQ(bounded->map.degrees(), exact.degrees());
  ASSERT_EQ(bounded->error.size(), exact.coefficients().size());
  for (std::size_t i = 0; i < exact.coefficients().size(); ++i) {
    if (bounded->error[i] == kInfinity) continue;
    const double v = bounded->map.coefficients()[i];
    ASSERT_TRUE(abs(Rational::from_double(v) - exact.coefficients()[i]) <=
                Rational::from_double(bounded->error[i]))
        << "coefficient " << i << " is " << v << ", its bound " << bounded->error[i] << "\nouter "
        << text_of(outer) << "\ninner " << text_of(inner);
  }
}

enum class Kind { kUnitCube, kWild, kTiny, kHuge, kCancelling };

double draw(Random& random, Kind kind) {
  const double v = 2 * random.unit() - 1;
  switch (kind) {
    case Kind::kUnitCube: return random.unit();
    case Kind::kWild: return std::ldexp(v, static_cast<int>(random.between(-60, 60)));
    case Kind::kTiny: return std::ldexp(v, static_cast<int>(random.between(-1074, -1000)));
    case Kind::kHuge: return std::ldexp(v, static_cast<int>(random.between(900, 1023)));
    case Kind::kCancelling: return 1e6 + v;
  }
  return v;
}

template <std::size_t M, std::size_t N>
void check(std::uint64_t seeds) {
  constexpr Kind kKinds[] = {Kind::kUnitCube, Kind::kWild, Kind::kTiny, Kind::kHuge,
                             Kind::kCancelling};
  for (std::uint64_t seed = 0; seed < seeds; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const auto [outer, inner] = draw_composable<M, N>(
        random, 3, N == 3 ? 2 : 3, [&] { return draw(random, kKinds[seed % 5]); },
        [&] { return draw(random, kKinds[seed / 5 % 5]); });
    expect_within_bounds(outer, inner);
  }
}

TEST(CompositionBounded, NeverLeavesItsBoundOnCurves) {
  check<1, 1>(100);
  check<2, 1>(100);
  check<3, 1>(50);
}
TEST(CompositionBounded, NeverLeavesItsBoundOnSurfaces) {
  check<1, 2>(50);
  check<2, 2>(50);
  check<3, 2>(25);
}
TEST(CompositionBounded, NeverLeavesItsBoundOnVolumes) {
  check<1, 3>(25);
  check<2, 3>(25);
  check<3, 3>(25);
}

Bezier<double, 3> draw_volume(Random& random, int degree) {
  Bezier<double, 3> map({degree, degree, degree}, 3, false);
  for (double& v : map.coefficients()) v = random.unit();
  return map;
}

TEST(CompositionBounded, IsSharpForATricubicVolumeInAnother) {
  Random random(1);
  Bezier<double, 3> outer = draw_volume(random, 3);
  for (double& v : outer.coefficients()) v = 2 * v - 1;
  const Bezier<double, 3> inner = draw_volume(random, 3);
  expect_within_bounds(outer, inner);
  const auto bounded = compose_bounded(outer, inner);
  for (const double e : bounded->error) EXPECT_LT(e, 151 * 0x1p-53);
}

// One component of one sign is its own majorant: the bound must be what it is beside a component of both signs.
TEST(CompositionBounded, BoundsComponentsOfOneSignByThemselves) {
  Random random(2);
  const Bezier<double, 2> inner({2, 2}, 3, false, [&] {
    std::vector<double> c(27);
    for (double& v : c) v = random.unit();
    return c;
  }());
  Bezier<double, 3> outer = draw_volume(random, 2);
  for (double& v : outer.component(1)) v = -v;
  const auto bounded = compose_bounded(outer, inner);
  ASSERT_TRUE(bounded);
  const double relative = 101 * 0x1p-53;
  for (int c = 0; c < 2; ++c)
    for (std::size_t i = 0; i < bounded->map.grid().count(); ++i) {
      const double e =
          bounded->error[static_cast<std::size_t>(c) * bounded->map.grid().count() + i];
      EXPECT_GT(e, 0);
      EXPECT_LE(e, relative * std::abs(bounded->map.component(c)[i]));
    }
  expect_within_bounds(outer, inner);
}

TEST(CompositionBounded, DoesNotDependOnTheCallersRoundingMode) {
  Random random(3);
  const Bezier<double, 3> outer = draw_volume(random, 2), inner = draw_volume(random, 1);
  const auto expected = compose_bounded(outer, inner);
  for (const int mode : {FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO}) {
    std::fesetround(mode);
    const auto bounded = compose_bounded(outer, inner);
    EXPECT_EQ(std::fegetround(), mode);
    std::fesetround(FE_TONEAREST);
    EXPECT_EQ(bounded->map, expected->map);
    EXPECT_EQ(bounded->error, expected->error);
  }
}

TEST(CompositionBounded, SaysInfinityWhereNumbersOverflow) {
  const Bezier<double, 1> outer({2}, 1, false, {1e300, -1e300, 1e300});
  const Bezier<double, 1> inner({1}, 1, false, {-1e10, 1e10});
  const auto bounded = compose_bounded(outer, inner);
  ASSERT_TRUE(bounded);
  for (const double e : bounded->error) EXPECT_EQ(e, kInfinity);
}

TEST(CompositionBounded, RefusesWhatIsNotFinite) {
  Bezier<double, 1> outer({2}, 1, false, {0, 1, 2}), inner({1}, 1, false, {0, 1});
  inner.coefficients()[1] = std::nan("");
  EXPECT_EQ(compose_bounded(outer, inner).error().code, Code::kNotFinite);
  EXPECT_EQ(compose_bounded(outer, inner).error().message,
            "coefficient 1 of the inner map is not finite");
  outer.coefficients()[2] = kInfinity;
  EXPECT_EQ(compose_bounded(outer, inner).error().message,
            "coefficient 2 of the outer map is not finite");
}

TEST(CompositionBounded, RefusesTheWrongNumberOfCoordinates) {
  const Bezier<double, 2> outer({1, 1}, 1, false);
  const Bezier<double, 1> inner({1}, 3, false);
  EXPECT_EQ(compose_bounded(outer, inner).error().code, Code::kBadArgument);
}

}  // namespace
}  // namespace veritope
