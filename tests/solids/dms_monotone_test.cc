// SPDX-License-Identifier: LGPL-3.0-or-later
// tests/solids/dms_monotone_test.cc: matrices that are monotone with many others, polynomials found from their values,
// and linear parts of affine maps, all exact.
#include "solids/dms/dms_monotone.h"

#include <gtest/gtest.h>

#include "solids/dms/dms_values.h"
#include "splines/bezier_triangle.h"
#include "tests/support/random_dms.h"

namespace veritope {
namespace {

Rational cell(const DmsMatrix& m, std::size_t i, std::size_t j) { return m[3 * i + j]; }

Rational determinant_of(const DmsMatrix& m) {
  return dot_product({m[0], m[1], m[2]}, cross_product({m[3], m[4], m[5]}, {m[6], m[7], m[8]}));
}
// By the leading minors of R G + (R G)^T.
bool is_monotone_by_minors(const DmsMatrix& r, const DmsMatrix& g) {
  DmsMatrix s;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      for (std::size_t k = 0; k < 3; ++k) {
        s[3 * i + j] += cell(r, i, k) * cell(g, k, j);
        s[3 * j + i] += cell(r, i, k) * cell(g, k, j);
      }
  return s[0].sign() == Sign::kPositive && (s[0] * s[4] - s[1] * s[3]).sign() == Sign::kPositive &&
         determinant_of(s).sign() == Sign::kPositive;
}
DmsMatrix draw_matrix(Random& random, int size) {
  DmsMatrix m;
  for (Rational& x : m) x = Rational(random.between(-size, size)) / Rational(random.between(1, 4));
  return m;
}
std::vector<const EnclosedMatrix*> pointers(const std::vector<EnclosedMatrix>& all) {
  std::vector<const EnclosedMatrix*> out;
  for (const EnclosedMatrix& m : all) out.push_back(&m);
  return out;
}
std::string text_of(const DmsMatrix& m) {
  std::string out;
  for (const Rational& x : m) out += x.to_string() + " ";
  return out;
}

const std::array<DmsPoint, 4> kCorners{DmsPoint{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};

DmsMatrix product(const DmsMatrix& a, const DmsMatrix& b) {
  DmsMatrix out;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      for (std::size_t k = 0; k < 3; ++k) out[3 * i + j] += cell(a, i, k) * cell(b, k, j);
  return out;
}

// PROVES DMS-1.J1
TEST(DmsMonotone, IsWhatTheLeadingMinorsSay) {
  int yes = 0;
  for (std::uint64_t seed = 0; seed < 4000; ++seed) {
    Random random(seed);
    const DmsMatrix r = draw_matrix(random, 3);
    DmsMatrix g = draw_matrix(random, 3);
    // Near multiples of one another, and singular, are where intervals do not decide.
    if (seed % 4 == 0) g = {r[0], r[3], r[6], r[1], r[4], r[7], r[2], r[5], r[8]};
    const bool expected = is_monotone_by_minors(r, g);
    yes += expected;
    ASSERT_EQ(is_monotone(EnclosedMatrix(r), EnclosedMatrix(g)), expected)
        << "seed " << seed << ": " << text_of(r) << "; " << text_of(g);
  }
  EXPECT_GT(yes, 500);
}

TEST(DmsMonotone, IsDecidedByExactNumbersAtTheLimit) {
  const Rational hair = Rational::power_of_two(-200);
  const EnclosedMatrix one({1, 0, 0, 0, 1, 0, 0, 0, 1});
  // [2 2c; 2c 2] is positive definite for |c| < 1.
  for (const int above : {-1, 0, 1}) {
    const DmsMatrix g{1, Rational(2) + Rational(above) * hair, 0, 0, 1, 0, 0, 0, 1};
    EXPECT_EQ(is_monotone(one, EnclosedMatrix(g)), above < 0) << above;
  }
  EXPECT_FALSE(is_monotone(one, EnclosedMatrix({0, 0, 0, 0, 0, 0, 0, 0, 0})));
}

TEST(DmsMonotone, FindsAMatrixForAllNearARegularOne) {
  int found = 0;
  for (std::uint64_t seed = 0; seed < 400; ++seed) {
    Random random(seed);
    const DmsMatrix middle = draw_matrix(random, 4);
    if (determinant_of(middle).sign() != Sign::kPositive) continue;
    std::vector<EnclosedMatrix> all;
    for (int i = 0; i < 5; ++i) {
      DmsMatrix near = middle;
      for (Rational& x : near) x += Rational(random.between(-9, 9)) / Rational(100);
      all.emplace_back(std::move(near));
    }
    const auto r = find_monotone_matrix(pointers(all), kCorners);
    if (!r) continue;
    ++found;
    EXPECT_EQ(determinant_of(*r).sign(), Sign::kPositive) << seed;
    for (const Rational& x : *r) {
      EXPECT_LT(abs(x), Rational::power_of_two(20)) << seed;
      EXPECT_EQ(x.denominator(), Integer(1)) << seed;
    }
    for (const EnclosedMatrix& g : all) EXPECT_TRUE(is_monotone_by_minors(*r, g.exact)) << seed;
  }
  EXPECT_GT(found, 100);
}

// Matrices G become B G A^-1, and the corners A times the corners.
TEST(DmsMonotone, AffineMapsDoNotChangeWhatIsFound) {
  constexpr std::array<std::array<int, 3>, 4> kExponents{
      {{0, 10, -10}, {-12, 3, 8}, {20, 0, 0}, {0, 0, 0}}};
  int found = 0;
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    Random random(seed);
    std::vector<EnclosedMatrix> all, moved;
    // A shear by up to 300 and powers of two.
    const Rational shear(random.between(-300, 300));
    const auto& exponents = kExponents[seed % 4];
    DmsMatrix a{}, back{}, b{};
    for (std::size_t i = 0; i < 3; ++i) {
      a[4 * i] = Rational::power_of_two(exponents[i]);
      back[4 * i] = Rational::power_of_two(-exponents[i]);
      b[4 * i] = Rational::power_of_two(exponents[(i + 1) % 3]);
    }
    const DmsMatrix sheared{1, shear, 0, 0, 1, 0, 0, 0, 1},
        unsheared{1, -shear, 0, 0, 1, 0, 0, 0, 1};
    a = product(sheared, a), back = product(back, unsheared), b = product(b, sheared);
    for (int i = 0; i < 6; ++i) {
      DmsMatrix g{1, 0, 0, 0, 1, 0, 0, 0, 1};
      for (Rational& x : g) x += Rational(random.between(-30, 30)) / Rational(100);
      all.emplace_back(g);
      moved.emplace_back(product(product(b, g), back));
    }
    std::array<DmsPoint, 4> corners;
    for (std::size_t m = 0; m < 4; ++m)
      for (std::size_t c = 0; c < 3; ++c)
        for (std::size_t k = 0; k < 3; ++k) corners[m][c] += cell(a, c, k) * kCorners[m][k];
    const auto before = find_monotone_matrix(pointers(all), kCorners),
               after = find_monotone_matrix(pointers(moved), corners);
    ASSERT_EQ(before.has_value(), after.has_value()) << seed;
    if (!after) continue;
    ++found;
    EXPECT_EQ(determinant_of(*after).sign(), Sign::kPositive) << seed;
    for (const EnclosedMatrix& g : moved)
      EXPECT_TRUE(is_monotone_by_minors(*after, g.exact)) << seed;
    for (const Rational& x : *after) {
      EXPECT_LE(x.numerator().bit_length(), 60u) << seed;
      EXPECT_LE(x.denominator().bit_length(), 62u) << seed;
    }
  }
  EXPECT_GT(found, 100);
}

TEST(DmsMonotone, FindsNoneWhereThereIsNone) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    Random random(seed);
    const DmsMatrix g = draw_matrix(random, 4);
    DmsMatrix minus = g;
    for (Rational& x : minus) x.negate();
    std::vector<EnclosedMatrix> all;
    all.emplace_back(g);
    all.emplace_back(minus);
    EXPECT_FALSE(find_monotone_matrix(pointers(all), kCorners))
        << "seed " << seed << ": " << text_of(g);
    // A negative determinant.
    const DmsMatrix mirror = determinant_of(g).sign() == Sign::kPositive ? minus : g;
    all.clear();
    all.emplace_back(mirror);
    EXPECT_FALSE(find_monotone_matrix(pointers(all), kCorners))
        << "seed " << seed << ": " << text_of(mirror);
  }
}

// ---------------------------------------------------------------- values

Rational power_product(const std::vector<int>& index, const std::vector<Rational>& shares) {
  Rational value(1);
  int left = 0;
  for (const int i : index) left += i;
  for (std::size_t m = 0; m < index.size(); ++m)
    for (int k = 1; k <= index[m]; ++k) value *= shares[m] * Rational(left--) / Rational(k);
  return value;
}

TEST(DmsValues, OfAPolynomialGiveItsBernsteinCoefficients) {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    Random random(seed);
    const std::size_t corners = 3 + seed % 2;
    const int degree = static_cast<int>(random.between(1, corners == 3 ? 6 : 4));
    std::vector<std::vector<int>> indices;
    if (corners == 3)
      for_each_triangle_index(degree, [&](int i, int j, int k) { indices.push_back({i, j, k}); });
    else
      for_each_tetrahedral_index(degree, [&](const TetrahedralIndex& index) {
        indices.emplace_back(index.begin(), index.end());
      });
    std::vector<DmsPoint> drawn(indices.size()), values(indices.size());
    for (DmsPoint& b : drawn)
      for (Rational& c : b) c = Rational(random.between(-9, 9)) / Rational(random.between(1, 5));
    for (std::size_t at = 0; at < indices.size(); ++at) {
      std::vector<Rational> shares;
      for (const int i : indices[at])
        shares.push_back(Rational(i + 1) / Rational(degree + static_cast<int>(corners)));
      for (std::size_t b = 0; b < indices.size(); ++b)
        for (std::size_t c = 0; c < 3; ++c)
          values[at][c] += power_product(indices[b], shares) * drawn[b][c];
    }
    EXPECT_EQ(SimplexInterpolation(degree, corners).coefficients(values), drawn)
        << "seed " << seed << ", degree " << degree;
  }
}

TEST(DmsValues, AreTakenInsideOfTheSimplex) {
  const std::vector<DmsPoint> corners{{0, 0, 0}, {6, 0, 0}, {0, 12, 0}};
  const std::vector<DmsPoint> points = SimplexInterpolation(3, 3).points(corners);
  ASSERT_EQ(points.size(), 10u);
  EXPECT_EQ(points[0], (DmsPoint{1, 2, 0}));  // (4, 1, 1) / 6
  EXPECT_EQ(points[9], (DmsPoint{1, 8, 0}));
}

TEST(DmsValues, AreThoseOfTheEvaluatorAndEndOutsideOfTheDomain) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const RandomDms drawn = draw_dms(seed, 3);
    Random random(seed);
    std::vector<DmsPoint> points;
    for (int i = 0; i < 5; ++i) points.push_back(draw_dms_point(random, drawn.model));
    DmsEvaluator evaluator(drawn.model);
    const auto values = values_at(evaluator, points);
    ASSERT_TRUE(values) << drawn.text;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const DmsValue value = evaluator.evaluate(*evaluator.locate(points[i]));
      EXPECT_TRUE(std::equal((*values)[i].begin(), (*values)[i].end(), value.value.begin()))
          << drawn.text;
    }
    points.push_back({10000, 0, 0});
    EXPECT_FALSE(values_at(evaluator, points)) << drawn.text;
  }
}

TEST(DmsMatrix, OfAnAffineMapIsItsLinearPart) {
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    Random random(seed);
    const DmsAffine map = draw_affine(random, true), place = draw_affine(random);
    const std::array<DmsPoint, 4> points{place({0, 0, 0}), place({1, 0, 0}), place({0, 1, 0}),
                                         place({0, 0, 1})};
    std::array<DmsPoint, 4> values;
    for (std::size_t i = 0; i < 4; ++i) values[i] = map(points[i]);
    const DmsMatrix found = linear_part(points, values);
    for (std::size_t i = 0; i < 9; ++i) EXPECT_EQ(found[i], map.m[i / 3][i % 3]) << seed;
  }
}

}  // namespace
}  // namespace veritope
