// SPDX-License-Identifier: LGPL-3.0-or-later
#include "predicates/sign_over_patch.h"

#include <gtest/gtest.h>

#include "robust/base/random.h"
#include "splines/de_casteljau.h"

namespace veritope {
namespace {

Rational ratio(long p, long q) { return Rational(p) / Rational(q); }

// The Bernstein form of a product, by values at n + 1 points and exact interpolation: no line in common with the subject.
Bezier<Rational, 1> squared_plus(const Bezier<Rational, 1>& f, const Rational& c) {
  const auto n = static_cast<std::size_t>(f.degree(0));
  std::vector<Rational> product(2 * n + 1);
  const auto choose = [](std::size_t m, std::size_t k) {
    Rational out(1);
    for (std::size_t i = 0; i < k; ++i) out *= Rational(m - i) / Rational(i + 1);
    return out;
  };
  for (std::size_t i = 0; i <= n; ++i)
    for (std::size_t j = 0; j <= n; ++j)
      product[i + j] += choose(n, i) * choose(n, j) / choose(2 * n, i + j) * f.coefficients()[i] *
                        f.coefficients()[j];
  for (Rational& v : product) v += c;
  return {{static_cast<int>(2 * n)}, 1, false, product};
}

template <std::size_t N>
void expect_true_witnesses(const Bezier<Rational, N>& map, const BoxSign<N>& report) {
  EXPECT_NE(report.witnesses[0].sign, report.witnesses[1].sign);
  for (const auto& w : report.witnesses) {
    for (const Rational& u : w.at) {
      EXPECT_LE(Rational(), u);
      EXPECT_LE(u, Rational(1));
    }
    EXPECT_EQ(evaluate(map, w.at)[0].sign(), w.sign);
  }
}

template <std::size_t N>
void try_random(std::uint64_t seed, int loops) {
  Random random(seed);
  int counts[5] = {};
  for (int loop = 0; loop < loops; ++loop) {
    std::array<int, N> degrees;
    for (int& d : degrees) d = static_cast<int>(random.below(N == 3 ? 3 : 5));
    Bezier<Rational, N> map(degrees, 1, false);
    const auto shift = random.between(-12, 12);
    for (Rational& v : map.coefficients()) v = ratio(random.between(-9, 9) + shift, 7);
    const auto report = sign_over_box(map);
    ++counts[static_cast<int>(report.answer)];
    if (report.answer == PatchSign::kMixed) {
      expect_true_witnesses(map, report);
      continue;
    }
    ASSERT_NE(report.answer, PatchSign::kUndecided) << "seed " << seed << " loop " << loop;
    const Sign sign = report.answer == PatchSign::kPositive   ? Sign::kPositive
                      : report.answer == PatchSign::kNegative ? Sign::kNegative
                                                              : Sign::kZero;
    for (int k = 0; k < 60; ++k) {
      std::array<Rational, N> u;
      for (Rational& x : u) x = ratio(random.between(0, 12), 12);
      EXPECT_EQ(evaluate(map, u)[0].sign(), sign) << "seed " << seed << " loop " << loop;
    }
  }
  for (const auto answer : {PatchSign::kPositive, PatchSign::kNegative, PatchSign::kMixed})
    EXPECT_GT(counts[static_cast<int>(answer)], 0);
}
TEST(SignOverBox, IsTheSignOfEveryPointOfCurves) { try_random<1>(1, 400); }
TEST(SignOverBox, IsTheSignOfEveryPointOfSurfaces) { try_random<2>(2, 200); }
TEST(SignOverBox, IsTheSignOfEveryPointOfVolumes) { try_random<3>(3, 100); }

TEST(SignOverBox, DecidesSquaresPlusALittle) {
  Random random(4);
  for (int loop = 0; loop < 30; ++loop) {
    Bezier<Rational, 1> f({1 + static_cast<int>(random.below(3))}, 1, false);
    for (Rational& v : f.coefficients()) v = ratio(random.between(-20, 20), 7);
    const Rational little = Rational::power_of_two(-static_cast<std::int64_t>(random.below(40)));
    EXPECT_EQ(sign_over_box(squared_plus(f, little)).answer, PatchSign::kPositive) << loop;
    auto negative = squared_plus(f, little);
    for (Rational& v : negative.coefficients()) v.negate();
    EXPECT_EQ(sign_over_box(negative).answer, PatchSign::kNegative) << loop;
  }
}

TEST(SignOverBox, FindsTheDipThatIntervalsCannotSee) {
  // (3 t - 1)^2 - 2^-120: two roots 2^-60 apart around 1/3; its least value is far below a rounding of its coefficients.
  const Bezier<Rational, 1> line({1}, 1, false, {-1, 2});
  const auto dip = squared_plus(line, -Rational::power_of_two(-120));
  const auto report = sign_over_box(dip);
  EXPECT_EQ(report.answer, PatchSign::kMixed);
  expect_true_witnesses(dip, report);
  EXPECT_GT(report.num_exact, 0u);
  const auto above = sign_over_box(squared_plus(line, Rational::power_of_two(-120)));
  EXPECT_EQ(above.answer, PatchSign::kPositive);
  EXPECT_GT(above.num_exact, 0u);
  EXPECT_EQ(sign_over_box(squared_plus(line, ratio(1, 10))).num_exact, 0u);  // the first tier
}

TEST(SignOverBox, SaysWhereItCouldNotDecide) {
  const Bezier<Rational, 1> line({1}, 1, false, {-1, 2});  // touches 0 at 1/3
  const auto report = sign_over_box(squared_plus(line, Rational()), 0, {100000, 50});
  EXPECT_EQ(report.answer, PatchSign::kUndecided);
  EXPECT_LE(report.place[0][0], ratio(1, 3));
  EXPECT_GE(report.place[1][0], ratio(1, 3));
  EXPECT_EQ(report.place[1][0] - report.place[0][0], Rational::power_of_two(-50));
  EXPECT_EQ(report.depth, 50);
  EXPECT_EQ(report.num_left, 1u);
  const auto few = sign_over_box(squared_plus(line, Rational()), 0, {3, 50});
  EXPECT_EQ(few.answer, PatchSign::kUndecided);
  EXPECT_EQ(few.num_pieces, 3u);
  EXPECT_GT(few.num_left, 0u);
}

TEST(SignOverBox, NamesZerosAtCornersAndZeroItself) {
  const auto corner = sign_over_box(Bezier<Rational, 2>({1, 1}, 1, false, {0, 1, 1, 1}));
  EXPECT_EQ(corner.answer, PatchSign::kMixed);
  EXPECT_EQ(corner.witnesses[1].sign, Sign::kZero);
  // u v (1 - u)(1 - v): zero at all corners and edges, positive inside.
  const Bezier<Rational, 2> bump({2, 2}, 1, false, {0, 0, 0, 0, 1, 0, 0, 0, 0});
  const auto edges = sign_over_box(bump);
  EXPECT_EQ(edges.answer, PatchSign::kMixed);
  expect_true_witnesses(bump, edges);
  EXPECT_EQ(sign_over_box(Bezier<Rational, 3>({1, 2, 0}, 1, false)).answer, PatchSign::kZero);
  // Zero inside of [0,1], at a dyadic point.
  const auto touch = squared_plus({{1}, 1, false, {-1, 1}}, Rational());
  const auto half = sign_over_box(touch);
  EXPECT_EQ(half.answer, PatchSign::kMixed);
  expect_true_witnesses(touch, half);
}

TEST(SignOverBox, LooksAtTheComponentAsked) {
  const Bezier<Rational, 1> map({1}, 2, false, {1, 2, -1, -2});
  EXPECT_EQ(sign_over_box(map, 0).answer, PatchSign::kPositive);
  EXPECT_EQ(sign_over_box(map, 1).answer, PatchSign::kNegative);
  EXPECT_THROW(sign_over_box(map, 2), InternalError);
  EXPECT_THROW(sign_over_box(map, 0, {0, 5}), InternalError);
}

// Values on the triangle from the definition.
Rational triangle_value(int n, const std::vector<Rational>& b, const std::array<Rational, 3>& u) {
  const auto power = [](const Rational& x, int k) {
    Rational out(1);
    for (int i = 0; i < k; ++i) out *= x;
    return out;
  };
  const auto factorial = [](int k) {
    Rational out(1);
    for (int i = 2; i <= k; ++i) out *= Rational(i);
    return out;
  };
  Rational sum;
  std::size_t at = 0;
  for (int row = 0; row <= n; ++row)
    for (int k = 0; k <= row; ++k)
      sum += factorial(n) / (factorial(n - row) * factorial(row - k) * factorial(k)) *
             power(u[0], n - row) * power(u[1], row - k) * power(u[2], k) * b[at++];
  return sum;
}

TEST(SignOverTriangle, IsTheSignOfEveryPoint) {
  Random random(5);
  int counts[5] = {};
  for (int loop = 0; loop < 200; ++loop) {
    const int n = static_cast<int>(random.below(5));
    std::vector<Rational> b;
    const auto shift = random.between(-12, 12);
    for (int i = 0; i < (n + 1) * (n + 2) / 2; ++i)
      b.push_back(ratio(random.between(-9, 9) + shift, 7));
    const auto report = sign_over_triangle(n, b);
    ++counts[static_cast<int>(report.answer)];
    if (report.answer == PatchSign::kMixed) {
      EXPECT_NE(report.witnesses[0].sign, report.witnesses[1].sign);
      for (const auto& w : report.witnesses) {
        EXPECT_EQ(w.at[0] + w.at[1] + w.at[2], Rational(1));
        EXPECT_EQ(triangle_value(n, b, w.at).sign(), w.sign) << loop;
      }
      continue;
    }
    ASSERT_NE(report.answer, PatchSign::kUndecided) << loop;
    const Sign sign = report.answer == PatchSign::kPositive   ? Sign::kPositive
                      : report.answer == PatchSign::kNegative ? Sign::kNegative
                                                              : Sign::kZero;
    for (int i = 0; i <= 8; ++i)
      for (int j = 0; i + j <= 8; ++j)
        EXPECT_EQ(triangle_value(n, b, {ratio(i, 8), ratio(j, 8), ratio(8 - i - j, 8)}).sign(),
                  sign)
            << loop;
  }
  for (const auto answer : {PatchSign::kPositive, PatchSign::kNegative, PatchSign::kMixed})
    EXPECT_GT(counts[static_cast<int>(answer)], 5);
}

TEST(SignOverTriangle, ReadsTheCoefficientsOfABezierTriangle) {
  Random random(6);
  int mixed = 0;
  for (int loop = 0; loop < 40; ++loop) {
    BezierTriangle<Rational> map(3, 2, false);
    for (Rational& v : map.coefficients()) v = ratio(random.between(-9, 20), 7);
    const auto report = sign_over_triangle(map, 1);
    if (report.answer != PatchSign::kMixed) continue;
    ++mixed;
    for (const auto& w : report.witnesses) {
      EXPECT_EQ(evaluate(map, w.at)[1].sign(), w.sign);
    }
  }
  EXPECT_GT(mixed, 5);
  EXPECT_THROW(sign_over_triangle(BezierTriangle<Rational>(1, 1, false), 1), InternalError);
}

TEST(SignOverTriangle, DecidesThinDipsZeroAndUndecided) {
  // (3 u - 1)^2 + c on u + v + w = 1, as a quadratic form of u, v, w with 1 = u + v + w: (2 u - v - w)^2.
  const auto form = [](const Rational& c) {
    return std::vector<Rational>{Rational(4) + c, Rational(-2) + c, Rational(-2) + c,
                                 Rational(1) + c, Rational(1) + c,  Rational(1) + c};
  };
  EXPECT_EQ(sign_over_triangle(2, form(ratio(1, 100)), {}).answer, PatchSign::kPositive);
  const auto dip = sign_over_triangle(2, form(-ratio(1, 100000)));
  EXPECT_EQ(dip.answer, PatchSign::kMixed);
  const auto touch = sign_over_triangle(2, form(Rational()), {2000, 40});
  EXPECT_EQ(touch.answer, PatchSign::kUndecided);
  Rational least(1), most;
  for (const auto& corner : touch.place) {
    EXPECT_EQ(corner[0] + corner[1] + corner[2], Rational(1));
    least = std::min(least, corner[0]), most = std::max(most, corner[0]);
  }
  EXPECT_LE(least, ratio(1, 3));
  EXPECT_GE(most, ratio(1, 3));
  EXPECT_EQ(sign_over_triangle(3, std::vector<Rational>(10)).answer, PatchSign::kZero);
  EXPECT_EQ(sign_over_triangle(0, {ratio(-1, 3)}).answer, PatchSign::kNegative);
  EXPECT_THROW(sign_over_triangle(2, std::vector<Rational>(5)), InternalError);
}

}  // namespace
}  // namespace veritope
