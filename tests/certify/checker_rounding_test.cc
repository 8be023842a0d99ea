// SPDX-License-Identifier: LGPL-3.0-or-later
// The C++ checker's rounded polynomials (star_rounded.h): their bounds hold on parts of parts, against exact values, and
// no sign is said that the bound leaves open.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <utility>
#include <vector>

#include "robust/base/random.h"
#include "robust/rational.h"
#include "verify/checker/patches/star_poly.h"
#include "verify/checker/patches/star_rounded.h"

namespace veritope {
namespace {

using Point = std::array<Rational, 3>;  // (u, v, -), or barycentric coordinates

std::vector<Rational> powers(const Rational& x, int n) {
  std::vector<Rational> out(1, Rational(1));
  for (int i = 0; i < n; ++i) out.push_back(out.back() * x);
  return out;
}

// The sum of coefficients times binomials times powers.
Rational value(const ::Shape& s, const std::vector<Rational>& c, const Point& x) {
  Rational out;
  const auto term = [&](std::size_t i, std::int64_t one, std::int64_t other, const Rational& monomial) {
    out += c[i] * Rational(one) * Rational(other) * monomial;
  };
  std::vector<std::pair<std::int64_t, std::int64_t>> binomials(c.size());
  ::each_pair_of_binomials(s, [&](std::size_t i, std::int64_t a, std::int64_t b) { binomials[i] = {a, b}; });
  if (s.is_triangle) {
    const auto p0 = powers(x[0], s.p), p1 = powers(x[1], s.p), p2 = powers(x[2], s.p);
    for (int j = 0; j <= s.p; ++j)
      for (int k = 0; j + k <= s.p; ++k) {
        const auto i = static_cast<std::size_t>(s.at3(j, k));
        term(i, binomials[i].first, binomials[i].second,
             p0[std::size_t(s.p - j - k)] * p1[std::size_t(j)] * p2[std::size_t(k)]);
      }
    return out;
  }
  const Rational one(1);
  const auto u = powers(x[0], s.p), v = powers(x[1], s.q), u1 = powers(one - x[0], s.p), v1 = powers(one - x[1], s.q);
  for (int j = 0; j <= s.p; ++j)
    for (int k = 0; k <= s.q; ++k) {
      const auto i = static_cast<std::size_t>(s.at(j, k));
      term(i, binomials[i].first, binomials[i].second,
           u[std::size_t(j)] * u1[std::size_t(s.p - j)] * v[std::size_t(k)] * v1[std::size_t(s.q - k)]);
    }
  return out;
}

// Where the point of a child lies in its parent.
Point in_parent(const ::Shape& s, int child, const Point& x) {
  const Rational half = Rational(1) / Rational(2);
  if (!s.is_triangle) return {(x[0] + Rational(child / 2)) * half, (x[1] + Rational(child % 2)) * half, Rational()};
  Point out;
  for (std::size_t i = 0; i < 3; ++i) {  // vertex i of the child, times x[i]
    const std::size_t a = child < 3 ? static_cast<std::size_t>(child) : (i + 1) % 3, b = child < 3 ? i : (i + 2) % 3;
    out[a] += x[i] * half;
    out[b] += x[i] * half;
  }
  return out;
}

Point random_point(const ::Shape& s, Random& random) {
  const Rational a = Rational(random.between(0, 64)) / Rational(64), b = Rational(random.between(0, 64)) / Rational(64);
  if (!s.is_triangle) return {a, b, Rational()};
  return {a, (Rational(1) - a) * b, (Rational(1) - a) * (Rational(1) - b)};
}

struct Polynomial {
  ::Shape shape;
  std::vector<Rational> exact;
  ::Block block;  // times binomials
};
// Coefficients high 2^bits + low, some of which are tiny beside the others.
Polynomial random_polynomial(const ::Shape& s, int bits, Random& random) {
  Polynomial out{s, std::vector<Rational>(std::size_t(s.count())), {}};
  std::vector<::Big> numbers(out.exact.size());
  ::each_pair_of_binomials(s, [&](std::size_t i, std::int64_t one, std::int64_t other) {
    const std::int64_t most = i == 0 || random.below(4) != 0 ? std::int64_t{1} << 40 : 0;
    const std::int64_t high = random.between(i == 0 ? most / 2 : -most, most), low = random.between(-1000, 1000);
    out.exact[i] = Rational(high) * Rational::power_of_two(bits) + Rational(low);
    numbers[i] = (::shifted(::Big(high), bits) + ::Big(low)) * ::Big(one) * ::Big(other);
  });
  out.block = ::packed(numbers);
  return out;
}

// The power of two by which the coefficients were multiplied.
Rational factor_of(const Polynomial& p, const ::Rounded& r) {
  return Rational::power_of_two(std::lround(std::log2(nearest_double(Rational(r.c[0]) / p.exact[0]))));
}

const ::Shape kShapes[] = {{false, 1, 1}, {false, 4, 2}, {false, 3, 8},  {false, 12, 12}, {false, 45, 30},
                           {true, 1, 1},  {true, 2, 2},  {true, 6, 6}, {true, 12, 12}};

TEST(CheckerRounding, PartsOfPartsAreWithinTheirBound) {
  for (std::uint64_t seed = 0; seed < 40; ++seed)
    for (const ::Shape& s : kShapes) {
      SCOPED_TRACE("seed " + std::to_string(seed) + (s.is_triangle ? " triangle " : " ") + std::to_string(s.p));
      if (s.p > 12 && seed > 1) continue;
      Random random(seed);
      const Polynomial p = random_polynomial(s, static_cast<int>(random.below(200)), random);
      ::Rounded r = ::rounded(s, p.block);
      const Rational factor = factor_of(p, r);
      for (std::size_t i = 0; i < p.exact.size(); ++i)
        EXPECT_LE(abs(Rational(r.c[i]) - p.exact[i] * factor), Rational(r.error)) << i;
      std::vector<int> children;
      for (int level = 0; level < 6; ++level) {
        children.push_back(static_cast<int>(random.below(4)));
        r = ::quarter(s, r, children.back());
        const Point x = random_point(s, random);
        Point at = x;
        for (std::size_t i = children.size(); i-- > 0;) at = in_parent(s, children[i], at);
        std::vector<Rational> part;
        for (const std::int64_t c : r.c) part.push_back(Rational(c));
        EXPECT_LE(abs(value(s, part, x) - value(s, p.exact, at) * factor), Rational(r.error)) << "level " << level;
      }
      EXPECT_LE(r.error, 6 * (s.p + s.q) + 1);
    }
}

TEST(CheckerRounding, KeepsAtLeastFortyBitsOfModerateDegrees) {
  Random random(3);
  for (const ::Shape& s : kShapes) {
    if (s.p > 12) continue;
    const ::Rounded r = ::rounded(s, random_polynomial(s, 100, random).block);
    std::int64_t most = 0;
    for (const std::int64_t c : r.c) most = std::max(most, std::abs(c));
    EXPECT_GE(most, std::int64_t{1} << 40) << s.p;
  }
}

TEST(CheckerRounding, SignsAreSaidOnlyBeyondTheBound) {
  EXPECT_EQ(::sign_of(::Rounded{{4, 9}, 3}), 1);
  EXPECT_EQ(::sign_of(::Rounded{{-4, -9}, 3}), -1);
  EXPECT_EQ(::sign_of(::Rounded{{3, 9}, 3}), ::kUnknown);
  EXPECT_EQ(::sign_of(::Rounded{{-3, -9}, 3}), ::kUnknown);
  EXPECT_EQ(::sign_of(::Rounded{{4, -4}, 3}), 0);
  EXPECT_EQ(::sign_of(::Rounded{{4, -4, 0}, 3}), 0);
  EXPECT_EQ(::sign_of(::Rounded{{4, -3}, 3}), ::kUnknown);
}

}  // namespace
}  // namespace veritope
