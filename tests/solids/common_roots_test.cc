// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/patches/common_roots.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "robust/base/random.h"

namespace veritope {
namespace {

Rational q(int n, int d = 1) { return Rational(Integer(n), Integer(d)); }

Polynomial times(const Polynomial& a, const Polynomial& b) {
  if (a.empty() || b.empty()) return {};
  Polynomial out(a.size() + b.size() - 1);
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t j = 0; j < b.size(); ++j) out[i + j] += a[i] * b[j];
  return out;
}
Polynomial with_root(const Rational& r) { return {-r, Rational(1)}; }

std::vector<std::array<Rational, 2>> roots_of(std::vector<Polynomial> polynomials) {
  return common_roots(polynomials).roots;
}
std::array<Rational, 2> point(const Rational& r) { return {r, r}; }

TEST(CommonRoots, ABernsteinFormBecomesItsPolynomial) {
  const std::vector<Rational> square{q(0), q(0), q(1)}, constant{q(5), q(5), q(5), q(5)},
      zero{q(0), q(0)};
  EXPECT_EQ(polynomial_of(square), (Polynomial{q(0), q(0), q(1)}));
  EXPECT_EQ(polynomial_of(constant), (Polynomial{q(5)}));
  EXPECT_TRUE(polynomial_of(zero).empty());
}

TEST(CommonRoots, RationalRootsAreExactAndThoseOutsideAreLeftOut) {
  const Polynomial p = times(times(with_root(q(1, 3)), with_root(q(5, 7))), with_root(q(4, 3)));
  EXPECT_EQ(roots_of({p}), (std::vector{point(q(1, 3)), point(q(5, 7))}));
  EXPECT_EQ(roots_of({times(with_root(q(0)), with_root(q(1)))}),
            (std::vector{point(q(0)), point(q(1))}));
}

TEST(CommonRoots, OnlyCommonOnesCountAndMultipleOnesOnce) {
  const Polynomial common = with_root(q(2, 5));
  const Polynomial a = times(times(common, common), with_root(q(1, 2))),
                   b = times(common, with_root(q(3, 4)));
  EXPECT_EQ(roots_of({a, b}), (std::vector{point(q(2, 5))}));
  EXPECT_EQ(roots_of({a, {}, b}), (std::vector{point(q(2, 5))}));
  EXPECT_TRUE(roots_of({with_root(q(1, 2)), with_root(q(3, 4))}).empty());
}

TEST(CommonRoots, AnIrrationalRootLiesInAnOpenIntervalAndAnIrrationalPairInTwo) {
  const auto one = roots_of({{q(-1), q(0), q(2)}});  // 2 t^2 = 1
  ASSERT_EQ(one.size(), 1u);
  EXPECT_LT(one[0][0], one[0][1]);
  EXPECT_LT(one[0][0] * one[0][0], q(1, 2));
  EXPECT_LT(q(1, 2), one[0][1] * one[0][1]);
  const auto two = roots_of({{q(1), q(-8), q(8)}});  // 8 t (1 - t) = 1
  ASSERT_EQ(two.size(), 2u);
  EXPECT_LT(two[0][1], two[1][0]);
  EXPECT_TRUE(roots_of({{q(1), q(0), q(1)}}).empty());
}

TEST(CommonRoots, ZeroPolynomialsVanishEverywhereAndConstantsNowhere) {
  const std::vector<Polynomial> zeros(3), mixed{{}, {q(7)}};
  EXPECT_TRUE(common_roots(zeros).is_everywhere);
  EXPECT_FALSE(common_roots(mixed).is_everywhere);
  EXPECT_TRUE(common_roots(mixed).roots.empty());
}

TEST(CommonRoots, RandomProductsHaveTheRootsTheyWereMadeOf) {
  Random random(20260720);
  for (int n = 0; n < 200; ++n) {
    const auto number = [&] {
      return q(static_cast<int>(random.below(41)) - 10, 1 + static_cast<int>(random.below(20)));
    };
    std::set<Rational> wanted;
    Polynomial p{q(1)}, other{q(1), q(0), q(1)};
    for (int k = 0; k < 4; ++k) {
      const Rational r = number();
      p = times(p, with_root(r)), other = times(other, with_root(r));
      if (q(0) <= r && r <= q(1)) wanted.insert(r);
    }
    p = times(p, with_root(q(1, 999983)));  // no root of the other one
    std::set<Rational> found;
    for (const auto& [lo, hi] : roots_of({p, other})) {
      EXPECT_EQ(lo, hi) << "case " << n << " of seed 20260720";
      found.insert(lo);
    }
    EXPECT_EQ(found, wanted) << "case " << n << " of seed 20260720";
  }
}

}  // namespace
}  // namespace veritope
