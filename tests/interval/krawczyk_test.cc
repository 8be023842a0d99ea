// SPDX-License-Identifier: LGPL-3.0-or-later
#include "interval/solvers/krawczyk.h"

#include <gtest/gtest.h>

#include <cmath>

#include "interval/solvers/bernstein_system.h"
#include "interval/upward.h"
#include "robust/base/random.h"
#include "splines/de_casteljau.h"

namespace veritope {
namespace {

Interval around(double m, double r) { return Interval::from_bounds(m - r, m + r); }

// PROVES ROOT-1
TEST(Krawczyk, ProvesTheRootOfAContraction) {
  const ScopedUpward upward;
  const auto k = krawczyk<1>({Interval(0.25)}, {{{around(1, 0.5)}}});
  ASSERT_TRUE(k.has_value());
  EXPECT_EQ((*k)[0], Interval::from_bounds(-0.75, 0.25));
}

// PROVES ROOT-1, ROOT-1.INSIDE
TEST(Krawczyk, RefusesARootOnTheEdgeAndASlopeThatMayVanish) {
  const ScopedUpward upward;
  EXPECT_FALSE(krawczyk<1>({Interval(0.5)}, {{{around(1, 0.5)}}}).has_value());
  EXPECT_FALSE(krawczyk<1>({Interval(0)}, {{{around(1, 1)}}}).has_value());
  EXPECT_FALSE(krawczyk<1>({Interval(0)}, {{{Interval::entire()}}}).has_value());
}

TEST(Eliminate, InvertsAndFindsTheCombinationOfNoGradient) {
  Random random(1);
  for (int loop = 0; loop < 100; ++loop) {
    ApproxMatrix<3> m;
    for (auto& row : m)
      for (double& v : row) v = 2 * random.unit() - 1;
    if (loop % 2 == 0)
      for (std::size_t j = 0; j < 3; ++j) m[2][j] = m[0][j] + 2 * m[1][j];  // dependent
    const auto e = eliminate(m);
    double residue = 0;
    for (std::size_t j = 0; j < 3; ++j) {
      double sum = 0;
      for (std::size_t i = 0; i < 3; ++i) sum += e.combination[2][i] * m[i][j];
      residue += std::abs(sum);
    }
    EXPECT_LT(residue, loop % 2 == 0 ? 1e-12 : 100.0) << loop;
    if (loop % 2 == 0 || !e.inverse) continue;
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j) {
        double sum = 0;
        for (std::size_t k = 0; k < 3; ++k) sum += (*e.inverse)[i][k] * m[k][j];
        EXPECT_NEAR(sum, i == j ? 1 : 0, 1e-9) << loop;
      }
  }
  EXPECT_FALSE(eliminate<2>({{{1, 2}, {2, 4}}}).inverse.has_value());
  EXPECT_FALSE(eliminate<2>({{{0, 0}, {0, 0}}}).inverse.has_value());
}

Bezier<Interval, 2> random_system(Random& random) {
  Bezier<Interval, 2> s({2, 3}, 2, false);
  for (Interval& c : s.coefficients()) c = Interval(static_cast<double>(random.between(-8, 8)));
  return s;
}

TEST(BernsteinSystem, HalvesAreSplitsAtOneHalf) {
  const ScopedUpward upward;
  Random random(2);
  const auto s = random_system(random);
  for (std::size_t axis = 0; axis < 2; ++axis)
    EXPECT_EQ(halves(s, axis), split(s, axis, Interval(0.5)));  // small integers: exact
}

TEST(BernsteinSystem, DerivativeHullsHoldDifferenceQuotients) {
  const ScopedUpward upward;
  Random random(3);
  for (int loop = 0; loop < 50; ++loop) {
    const auto s = random_system(random);
    const auto hulls = derivative_hulls(s);
    const double y = random.unit(), a = 0.25 * random.unit(), b = 0.5 + 0.5 * random.unit();
    const auto at_a = evaluate(s, {Interval(a), Interval(y)});
    const auto at_b = evaluate(s, {Interval(b), Interval(y)});
    for (std::size_t c = 0; c < 2; ++c) {
      const Interval quotient = (at_b[c] - at_a[c]) / (Interval(b) - Interval(a));
      EXPECT_FALSE(is_disjoint(quotient, hulls[c][0])) << loop;
    }
  }
}

TEST(BernsteinSystem, CombinedIsTheMatrixTimesTheValues) {
  const ScopedUpward upward;
  Random random(4);
  const auto s = random_system(random);
  const auto t = combined<2>({{{2, -1}, {0, 0.5}}}, s);
  const auto before = evaluate(s, {Interval(0.5), Interval(0.25)});
  const auto after = evaluate(t, {Interval(0.5), Interval(0.25)});
  EXPECT_EQ(after[0], Interval(2) * before[0] - before[1]);
  EXPECT_EQ(after[1], Interval(0.5) * before[1]);
}

// PROVES ROOT-2.NONE
TEST(BernsteinSystem, ExamineProvesExcludesOrSaysWhereToCut) {
  const ScopedUpward upward;
  using Kind = Examination<1>::Kind;
  const auto look = [](std::vector<Interval> c) {
    const int degree = static_cast<int>(c.size()) - 1;
    return examine(Bezier<Interval, 1>({degree}, 1, false, std::move(c)));
  };
  EXPECT_EQ(look({Interval(1), Interval(2)}).kind, Kind::kNoRoot);
  EXPECT_EQ(look({Interval(-1), Interval(2)}).kind, Kind::kOneRoot);
  EXPECT_EQ(look({Interval(-1), Interval(4), Interval(-1)}).kind, Kind::kUnknown);
  EXPECT_FALSE(look({Interval(-1), Interval(4), Interval(-1)}).is_exhausted);
  EXPECT_TRUE(look({around(0, 1), around(0, 1)}).is_exhausted);
  EXPECT_TRUE(look({Interval(0), Interval(0)}).is_exhausted);
}

}  // namespace
}  // namespace veritope
