// SPDX-License-Identifier: LGPL-3.0-or-later
#include <gtest/gtest.h>

#include "solids/chain/integer_net_internal.h"
#include "solids/chain/literal_regions_internal.h"
#include "tests/solids/literal_support.h"

namespace veritope::internal {
namespace {

using literal::fraction;
using literal::monomial;
using literal::Poly;

BezierTriangle<Rational> some_net(int degree) {
  BezierTriangle<Rational> out(degree, 2, false);
  std::int64_t n = 17;
  for (Rational& x : out.coefficients()) {
    n = n * 31 % 1009;
    x = fraction(n - 500, 1 + n % 7);
  }
  return out;
}

TEST(IntegerNet, QuartersAreThoseOfSplitInFourTimesAFactor) {
  for (const int degree : {1, 2, 3, 6}) {
    const auto net = some_net(degree);
    const IntegerNet scaled = integer_net(net);
    const Rational factor =
        Rational(scaled.coefficients()[0]) / net.coefficients()[0] * Rational::power_of_two(degree);
    EXPECT_TRUE(factor.sign() > 0);
    const auto expected = split_in_four(net);
    const auto quarters = quarters_of(scaled);
    for (std::size_t q = 0; q < 4; ++q)
      for (std::size_t i = 0; i < net.coefficients().size(); ++i)
        EXPECT_EQ(Rational(quarters[q].coefficients()[i]), factor * expected[q].coefficients()[i])
            << degree << " " << q << " " << i;
  }
}

BezierTriangle<Rational> form(const Poly& p) {
  BezierTriangle<Rational> out(p.degree, 1, false);
  for_each_triangle_index(p.degree, [&](int i, int j, int k) {
    out.component(0)[triangle_index(j, k)] = literal::bernstein(p, i, j, k);
  });
  return out;
}

TEST(PositiveRegion, IsConnectedOrNot) {
  const Poly u = monomial({1, 0, 0}), v = monomial({0, 1, 0}), w = monomial({0, 0, 1});
  const auto minus = [](const Poly& p) { return p * Poly{0, {{{0, 0, 0}, Rational(-1)}}}; };
  EXPECT_EQ(positive_region(form(u)).decision, Decision::kHolds);
  EXPECT_EQ(positive_region(form(u + minus(v))).decision, Decision::kHolds);
  EXPECT_EQ(positive_region(form(u * v * w * (u + minus(v)))).decision, Decision::kHolds);
  // The outside of a circle around the middle, in the triangle: three corners.
  const Poly third = literal::unit() * Poly{0, {{{0, 0, 0}, fraction(1, 3)}}};
  const Poly du = u + minus(third), dv = v + minus(third), dw = w + minus(third);
  const Poly square = literal::unit() * literal::unit();
  const auto circle = [&](const Rational& r) {
    return du * du + dv * dv + dw * dw + minus(square * Poly{0, {{{0, 0, 0}, r}}});
  };
  const PositiveRegion corners = positive_region(form(circle(fraction(1, 4))));
  EXPECT_EQ(corners.decision, Decision::kViolated);
  EXPECT_NE(corners.where[0], corners.where[1]);
  // A circle that does not reach the sides, and its inside.
  EXPECT_EQ(positive_region(form(circle(fraction(1, 8)))).decision, Decision::kHolds);
  EXPECT_EQ(positive_region(form(minus(circle(fraction(1, 8))))).decision, Decision::kHolds);
  // Two quadrants that meet in a point: their closures do.
  EXPECT_NE(positive_region(form((u + minus(v)) * (third + minus(w)))).decision,
            Decision::kViolated);
}

}  // namespace
}  // namespace veritope::internal
