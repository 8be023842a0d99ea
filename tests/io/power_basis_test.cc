// SPDX-License-Identifier: LGPL-3.0-or-later
#include "io/splines/spline_builder.h"

#include <gtest/gtest.h>

#include "robust/base/random.h"
#include "tests/io/spline_test_util.h"

namespace veritope {
namespace {

constexpr std::uint64_t kSeed = 20251122;

Rational random_fraction(Random& random) {
  return {Integer(static_cast<std::int64_t>(random.next() % 2001) - 1000),
          Integer(1 + static_cast<std::int64_t>(random.next() % 30))};
}

Rational power(const Rational& t, std::uint64_t n) {
  Rational out(1);
  for (std::uint64_t i = 0; i < n; ++i) out *= t;
  return out;
}

template <std::size_t N>
RawSpline<N> random_spline(Random& random, const std::array<int, N>& degrees, int components) {
  RawSpline<N> raw;
  raw.degrees = degrees;
  raw.num_components = components;
  std::size_t count = static_cast<std::size_t>(components);
  for (std::size_t a = 0; a < N; ++a) {
    raw.num_control[a] = static_cast<std::uint64_t>(degrees[a]) + 1;
    raw.knots[a] = bezier_knots(degrees[a]);
    count *= static_cast<std::size_t>(raw.num_control[a]);
  }
  for (std::size_t i = 0; i < count; ++i) raw.points.push_back(random_fraction(random));
  return raw;
}

// The sum of the coefficients times the powers, as the file lists them: the first axis fastest.
template <std::size_t N>
std::string value_in_powers(const RawSpline<N>& raw, const std::array<Rational, N>& t) {
  std::string text;
  for (int c = 0; c < raw.num_components; ++c) {
    Rational sum;
    for (std::size_t i = static_cast<std::size_t>(c); i < raw.points.size();
         i += static_cast<std::size_t>(raw.num_components)) {
      Rational term = raw.points[i];
      std::size_t rest = i / static_cast<std::size_t>(raw.num_components);
      for (std::size_t a = 0; a < N; rest /= raw.num_control[a], ++a)
        term *= power(t[a], rest % raw.num_control[a]);
      sum += term;
    }
    text += (c == 0 ? "" : " ") + sum.to_string();
  }
  return text;
}

template <std::size_t N>
void check_values(Random& random, const std::array<int, N>& degrees, int components) {
  RawSpline<N> raw = random_spline(random, degrees, components);
  std::array<Rational, N> t;
  for (Rational& x : t) x = Rational(Integer(random.next() % 8), Integer(7));
  const std::string expected = value_in_powers(raw, t);
  NumberBudget budget(0);
  ASSERT_TRUE(power_to_bernstein(raw, budget));
  const auto spline = build_spline(std::move(raw));
  ASSERT_TRUE(spline);
  EXPECT_EQ(io_test::exact_value(*spline, t), expected) << "seed " << kSeed;
}

TEST(PowerBasis, BernsteinCoefficientsHaveTheSameValues) {
  Random random(kSeed);
  for (int p = 1; p <= 12; ++p) check_values<1>(random, {p}, 2);
  for (int i = 0; i < 20; ++i)
    check_values<2>(random, {1 + static_cast<int>(random.next() % 5), 1 + i % 5}, 3);
  for (int i = 0; i < 8; ++i) check_values<3>(random, {1 + i % 3, 1 + i / 3, 2}, 1);
  check_values<2>(random, {63, 2}, 1);
}

TEST(PowerBasis, WhatTheBudgetDoesNotAllowIsLeftAsItIs) {
  Random random(kSeed);
  RawSpline<3> raw = random_spline<3>(random, {63, 63, 63}, 1);
  raw.points[0] = Rational(power(Rational(10), 4096));  // a part of every coefficient: 446 MB
  const std::vector<Rational> before = raw.points;
  NumberBudget budget(1'000'000);
  EXPECT_FALSE(power_to_bernstein(raw, budget));
  EXPECT_EQ(raw.points, before);
}

}  // namespace
}  // namespace veritope
