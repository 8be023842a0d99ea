// SPDX-License-Identifier: LGPL-3.0-or-later
// The algebra of splines/ over Interval: every coefficient of a result contains that of the result over the rationals, whichever
// members of the operands are taken, and is not much wider than rounding makes it.
#include <gtest/gtest.h>

#include "interval/interval.h"
#include "interval/numeric.h"
#include "interval/ring_numbers.h"
#include "interval/upward.h"
#include "splines/affine_map.h"
#include "splines/bezier_calculus.h"
#include "splines/bezier_domain.h"
#include "splines/bezier_product.h"
#include "splines/blossom.h"
#include "splines/bspline_degree.h"
#include "splines/bspline_derivative.h"
#include "splines/bspline_domain.h"
#include "splines/bspline_pieces.h"
#include "splines/de_boor.h"
#include "tests/splines/draw.h"

namespace veritope {
namespace {

// Around x: tight, or wider by up to `width` on either side.
Interval around(Random& random, const Rational& x, const Rational& width) {
  const Rational low = x - width * draw_parameter(random),
                 high = x + width * draw_parameter(random);
  return Interval::from_bounds(round_down(low), round_up(high));
}
std::vector<Interval> around(Random& random, std::span<const Rational> values,
                             const Rational& width) {
  std::vector<Interval> out;
  for (const Rational& v : values) out.push_back(around(random, v, width));
  return out;
}
template <std::size_t N>
Bezier<Interval, N> around(Random& random, const Bezier<Rational, N>& map, const Rational& width) {
  return {map.degrees(), map.num_components(), map.is_rational(),
          around(random, map.coefficients(), width)};
}
template <std::size_t N>
BSpline<Interval, N> around(Random& random, const BSpline<Rational, N>& map,
                            const Rational& width) {
  return {map.axes(), map.num_components(), map.is_rational(),
          around(random, map.coefficients(), width)};
}

// `most` bounds the widths.
void expect_members(std::span<const Interval> in, std::span<const Rational> values, double most) {
  ASSERT_EQ(in.size(), values.size());
  for (std::size_t i = 0; i < in.size(); ++i) {
    ASSERT_TRUE(contains(in[i], values[i]))
        << "number " << i << ", " << values[i].to_string() << ", not in " << to_string(in[i]);
    ASSERT_LE(wid(in[i]), most) << "number " << i;
  }
}
template <typename Map, typename ExactMap>
void expect_contains(const Map& map, const ExactMap& exact, double most) {
  expect_members(map.coefficients(), exact.coefficients(), most);
}

// Laws for tight operands (widths by rounding only) and for wide ones (no bound of the widths).
template <typename Law>
void for_widths(std::uint64_t seed, int loops, Law law) {
  for_all_dimensions(seed, loops, [&](Random& random, auto n) {
    const ScopedUpward upward;
    law(random, n, Rational(0), 0x1p-30);
  });
  for_all_dimensions(seed + 10, loops, [&](Random& random, auto n) {
    const ScopedUpward upward;
    law(random, n, Rational(2), 0x1p40);
  });
}

TEST(BezierOverInterval, ContainsTheMapOverTheRationals) {
  for_widths(500, 20, [](Random& random, auto n, const Rational& width, double most) {
    const auto x = draw_bezier<n>(random, 4, 3), y = draw_bezier<n>(random, 4, 3);
    SCOPED_TRACE(text_of(x) + " | " + text_of(y));
    const auto f = around(random, x, width), g = around(random, y, width);
    const std::size_t a = random.below(n);
    expect_contains(elevate(f, a, 3), elevate(x, a, 3), most);
    expect_contains(derivative(f, a), derivative(x, a), most);
    expect_contains(antiderivative(f, a), antiderivative(x, a), most);
    expect_members(integral(f), integral(x), most);
    expect_contains(componentwise_product(f, g), componentwise_product(x, y), most);
    expect_contains(dot(f, g), dot(x, y), most);
    expect_contains(cross(f, g), cross(x, y), most);
    expect_contains(sum(f, g), sum(x, y), most);
    expect_contains(difference(f, g), difference(x, y), most);
    expect_contains(reversed(f, a), reversed(x, a), most);
    const Rational low = fraction(random.between(0, 6), 14),
                   high = fraction(random.between(7, 14), 14);
    expect_contains(restricted(f, a, low, high), restricted(x, a, low, high), most);
    const AffineMap affine{2, 3, draw_coefficients(random, 6, 1, false),
                           draw_coefficients(random, 2, 1, false)};
    expect_contains(transformed(f, affine), transformed(x, affine), most);
    const auto at = draw_point<n>(random);
    std::array<Interval, n> in;
    std::array<std::vector<Rational>, n> arguments;
    std::array<std::vector<Interval>, n> interval_arguments;
    for (std::size_t i = 0; i < n; ++i) {
      in[i] = around(random, at[i], Rational(0));
      arguments[i] = draw_coefficients(random, static_cast<std::size_t>(x.degree(i)), 1, false);
      interval_arguments[i] = around(random, arguments[i], width);
    }
    expect_members(evaluate(f, in), evaluate(x, at), most);
    const auto blossoms = blossom(f, interval_arguments);
    const auto exact_blossoms = blossom(x, arguments);
    for (std::size_t c = 0; c < 3; ++c) EXPECT_TRUE(contains(blossoms[c], exact_blossoms[c]));
    if constexpr (n > 1)
      expect_contains(isoparametric(f, a, in[a]), isoparametric(x, a, at[a]), most);
  });
}

TEST(RationalBezierOverInterval, ContainsTheMapOverTheRationals) {
  for_widths(530, 12, [](Random& random, auto n, const Rational& width, double) {
    const auto x = draw_bezier<n>(random, 3, 3, true), y = draw_bezier<n>(random, 3, 3, true);
    SCOPED_TRACE(text_of(x) + " | " + text_of(y));
    const auto f = around(random, x, width), g = around(random, y, width);
    const std::size_t a = random.below(n);
    const double any = 0x1p1000;
    expect_contains(derivative(f, a), derivative(x, a), any);
    expect_contains(sum(f, g), sum(x, y), any);
    expect_contains(multiplied(components(f, 0, 1), g), multiplied(components(x, 0, 1), y), any);
  });
}

TEST(BSplineOverInterval, ContainsTheMapOverTheRationals) {
  for_widths(560, 24, [](Random& random, auto n, const Rational& width, double most) {
    const auto x = draw_bspline<n>(random, 3, 2);
    SCOPED_TRACE(text_of(x));
    const auto f = around(random, x, width);
    const std::size_t a = random.below(n);
    expect_contains(elevate(f, a, 2), elevate(x, a, 2), most);
    expect_contains(derivative(f, a), derivative(x, a), most);
    expect_contains(clamped(f, a), clamped(x, a), most);
    expect_contains(reversed(f, a), reversed(x, a), most);
    expect_contains(joined(bezier_pieces(f)), joined(bezier_pieces(x)), most);
    const auto low = draw_point(random, x), high = draw_point(random, x);
    const auto part = restricted(f, low, high);
    const auto exact_part = restricted(x, low, high);
    ASSERT_EQ(part.has_value(), exact_part.has_value());
    if (part) expect_contains(part.value(), exact_part.value(), most);
    expect_members(evaluate(f, low).value(), evaluate(x, low).value(), most);
    if constexpr (n > 1)
      expect_contains(isoparametric(f, a, low[a]).value(), isoparametric(x, a, low[a]).value(),
                      most);
  });
}

TEST(BSplineOverInterval, ContainsDerivativesAndPointsOfRationalMaps) {
  for_widths(590, 8, [](Random& random, auto n, const Rational& width, double) {
    const auto x = draw_bspline<n>(random, 2, 3, true);
    SCOPED_TRACE(text_of(x));
    const auto f = around(random, x, width);
    const std::size_t a = random.below(n);
    expect_contains(derivative(f, a), derivative(x, a), 0x1p1000);
    const auto at = draw_point(random, x);
    const auto points = point(f, at).value();
    const auto exact_points = point(x, at).value();
    for (std::size_t c = 0; c < 2; ++c) EXPECT_TRUE(contains(points[c], exact_points[c]));
  });
}

}  // namespace
}  // namespace veritope
