// SPDX-License-Identifier: LGPL-3.0-or-later
#include "splines/convert.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "splines/bezier_calculus.h"
#include "splines/bezier_domain.h"
#include "splines/blossom.h"
#include "splines/bspline_degree.h"
#include "splines/bspline_derivative.h"
#include "splines/bspline_domain.h"
#include "splines/de_boor.h"
#include "tests/splines/draw.h"

namespace veritope {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

KnotAxis<Rational> unit_axis() {
  return {1, {Rational(0), Rational(0), Rational(1), Rational(1)}, false};
}

TEST(Convert, DoublesAreKeptExactlyThereAndBack) {
  for_all_dimensions(400, 20, [](Random& random, auto n) {
    auto map = nearest_double(draw_bspline<n>(random, 3, 3, true)).value();
    const auto exact_map = exact(map);
    ASSERT_TRUE(exact_map) << exact_map.error().message;
    EXPECT_EQ(nearest_double(exact_map.value()).value(), map);
    const auto piece = nearest_double(draw_bezier<n>(random, 3, 2)).value();
    EXPECT_EQ(nearest_double(exact(piece).value()).value(), piece);
  });
}

TEST(Convert, RoundsToNearest) {
  const Bezier<Rational, 1> third({0}, 1, false, {fraction(1, 3)});
  EXPECT_EQ(nearest_double(third).value().coefficients()[0], 1.0 / 3);
}

TEST(Convert, KeepsThePeriodOnlyIfItIsExact) {
  const auto ring = [](const Rational& step) {
    KnotAxis<Rational> axis{2, {}, true};
    for (int i = -2; i <= 6; ++i) axis.knots.push_back(Rational(i) * step);
    return BSplineCurve<Rational>({axis}, 1, false, std::vector<Rational>(6));
  };
  EXPECT_TRUE(nearest_double(ring(fraction(1, 4))).value().axis(0).is_periodic);
  EXPECT_FALSE(nearest_double(ring(fraction(1, 10))).value().axis(0).is_periodic);
}

TEST(Convert, RefusesWhatDoublesCannotHold) {
  const Rational huge = Rational::power_of_two(1024), tiny = Rational::power_of_two(-1100);
  const auto big = nearest_double(Bezier<Rational, 1>({1}, 1, false, {Rational(1), huge}));
  ASSERT_FALSE(big);
  EXPECT_EQ(big.error().code, Code::kNotFinite);
  EXPECT_NE(big.error().message.find("coefficient 1, " + huge.to_string()), std::string::npos);
  EXPECT_TRUE(nearest_double(Bezier<Rational, 1>({1}, 2, false, {tiny, tiny, tiny, tiny})));
  const auto weightless =
      nearest_double(Bezier<Rational, 1>({1}, 2, true, {tiny, tiny, Rational(1), tiny}));
  ASSERT_FALSE(weightless);
  EXPECT_EQ(weightless.error().code, Code::kLossy);
  EXPECT_NE(weightless.error().message.find("coefficient 3"), std::string::npos);

  auto axis = unit_axis();
  axis.knots = {Rational(0), Rational(0), tiny, Rational(1), Rational(1)};
  const auto close = nearest_double(
      BSplineSurface<Rational>({unit_axis(), axis}, 1, false, std::vector<Rational>(6)));
  ASSERT_FALSE(close);
  EXPECT_EQ(close.error().code, Code::kLossy);
  EXPECT_EQ(close.error().message.substr(0, 17), "axis 1: knot 2, 1");
  axis.knots.back() = axis.knots[3] = huge;
  const auto far = nearest_double(
      BSplineSurface<Rational>({unit_axis(), axis}, 1, false, std::vector<Rational>(6)));
  ASSERT_FALSE(far);
  EXPECT_EQ(far.error().code, Code::kNotFinite);
  EXPECT_EQ(far.error().message.substr(0, 16), "axis 1: knot 3, ");
}

TEST(Convert, RefusesDoublesThatAreNoNumbersAndKnotsThatAreNone) {
  const auto nan = exact(Bezier<double, 1>({1}, 1, false, {0, std::nan("")}));
  ASSERT_FALSE(nan);
  EXPECT_EQ(nan.error().code, Code::kNotFinite);
  EXPECT_EQ(nan.error().message, "coefficient 1, nan, is no number");
  const auto curve = [](std::vector<double> knots, double c) {
    return exact(
        BSplineCurve<double>({KnotAxis<double>{1, std::move(knots), false}}, 1, false, {0, c}));
  };
  EXPECT_TRUE(curve({0, 0, 1, 1}, 1));
  EXPECT_EQ(curve({0, 0, 1, 1}, kInfinity).error().code, Code::kNotFinite);
  EXPECT_EQ(curve({0, 0, 1, kInfinity}, 1).error().message, "axis 0: knot 3, inf, is no number");
  EXPECT_EQ(curve({0, 0, 0, 0}, 1).error().code, Code::kBadArgument);
}

// The algebra over double, on data that double holds exactly, is that over the rationals up to rounding.
// The bound, 2^-43 of the greatest coefficient of the exact result and operands, leaves 2^10 roundings.
template <typename Map, typename ExactMap>
void expect_near(const Map& map, const ExactMap& exact_map, const Rational& scale) {
  ASSERT_EQ(map.coefficients().size(), exact_map.coefficients().size());
  for (std::size_t i = 0; i < map.coefficients().size(); ++i)
    ASSERT_LE(abs(Rational::from_double(map.coefficients()[i]) - exact_map.coefficients()[i]),
              scale * Rational::power_of_two(-43))
        << "coefficient " << i;
}
template <typename ExactMap>
Rational greatest(const ExactMap& map) {
  Rational most(1);
  for (const Rational& v : map.coefficients()) most = std::max(most, abs(v));
  return most;
}

TEST(AlgebraOverDouble, OfBezierMapsIsThatOverTheRationalsUpToRounding) {
  for_all_dimensions(410, 20, [](Random& random, auto n) {
    const auto f = nearest_double(draw_bezier<n>(random, 4, 3)).value();
    const auto g = nearest_double(draw_bezier<n>(random, 4, 3)).value();
    const auto x = exact(f).value(), y = exact(g).value();
    SCOPED_TRACE(text_of(x) + " | " + text_of(y));
    const std::size_t a = random.below(n);
    const Rational scale = greatest(x) * greatest(y) * Rational(16);
    expect_near(elevate(f, a, 3), elevate(x, a, 3), greatest(x));
    expect_near(derivative(f, a), derivative(x, a), scale);
    expect_near(antiderivative(f, a), antiderivative(x, a), greatest(x));
    expect_near(componentwise_product(f, g), componentwise_product(x, y), scale);
    expect_near(cross(f, g), cross(x, y), scale);
    expect_near(sum(f, g), sum(x, y), scale);
    expect_near(restricted(f, a, 0.125, 0.75), restricted(x, a, fraction(1, 8), fraction(3, 4)),
                greatest(x));
    EXPECT_EQ(reversed(f, a), nearest_double(reversed(x, a)).value());
  });
}

TEST(AlgebraOverDouble, OfBSplinesIsThatOverTheRationalsUpToRounding) {
  for_all_dimensions(420, 10, [](Random& random, auto n) {
    const auto f = nearest_double(draw_bspline<n>(random, n == 3 ? 2 : 3, 3, true)).value();
    const auto x = exact(f).value();
    SCOPED_TRACE(text_of(x));
    const std::size_t a = random.below(n);
    const Rational scale = greatest(x);
    const double begin = f.axis(a).domain_begin(), end = f.axis(a).domain_end();
    const double at = begin + 0.375 * (end - begin);
    expect_near(elevate(f, a, 2), elevate(x, a, 2), scale);
    expect_near(clamped(f, a), clamped(x, a), scale);
    expect_near(refine(f, a, {at, at}),
                refine(x, a, {Rational::from_double(at), Rational::from_double(at)}), scale);
    std::array<double, n> place;
    std::array<Rational, n> exact_place;
    for (std::size_t i = 0; i < n; ++i) {
      place[i] = i == a ? at : f.axis(i).domain_begin();
      exact_place[i] = Rational::from_double(place[i]);
    }
    const auto values = evaluate(f, place).value();
    const auto exact_values = evaluate(x, exact_place).value();
    for (std::size_t c = 0; c < 3; ++c)
      EXPECT_LE(abs(Rational::from_double(values[c]) - exact_values[c]),
                scale * Rational::power_of_two(-43));
    const auto df = derivative(f, a);
    const auto dx = derivative(x, a);
    expect_near(df, dx, greatest(dx) * scale * scale);
    EXPECT_EQ(mirrored(f, a), nearest_double(mirrored(x, a)).value());
  });
}

}  // namespace
}  // namespace veritope
