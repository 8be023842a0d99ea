// SPDX-License-Identifier: LGPL-3.0-or-later
// Signs of separators against the Bernstein coefficients of W^d q(F / W) in rationals.
#include "solids/star_box/sheet_separator.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "tests/solids/exact_nodes.h"

namespace veritope {
namespace {

// A homogeneous polynomial of the parameters: in (1 - u, u) of degree p and (1 - v, v) of degree q, or in three
// barycentric coordinates. Its coefficients are the Bernstein coefficients times positive integers.
using Exponents = std::array<int, 4>;
using Polynomial = std::map<Exponents, Rational>;

Polynomial product(const Polynomial& a, const Polynomial& b) {
  Polynomial out;
  for (const auto& [e, v] : a)
    for (const auto& [f, w] : b) {
      Exponents sum;
      for (std::size_t k = 0; k < 4; ++k) sum[k] = e[k] + f[k];
      out[sum] += v * w;
    }
  return out;
}

Rational choose(int n, int k) {
  Rational out(1);
  for (int i = 0; i < k; ++i) out = out * Rational(n - i) / Rational(i + 1);
  return out;
}
// How many times its Bernstein coefficient the coefficient of these exponents is.
Rational factor(const FormShape& s, const Exponents& e) {
  if (s.is_triangle) return choose(s.p, e[0]) * choose(s.p - e[0], e[1]);
  return choose(s.p, e[0]) * choose(s.q, e[2]);
}
FormShape times(const FormShape& s, int d) { return {s.is_triangle, d * s.p, d * s.q}; }

// Visits the exponents in the order of control points.
template <typename Visit>
void for_each_place(const FormShape& s, Visit visit) {
  if (s.is_triangle) {
    for_each_triangle_index(s.p, [&](int i, int j, int k) {
      visit(Exponents{i, j, k, 0}, triangle_index(j, k));
    });
    return;
  }
  std::size_t at = 0;
  for (int i = 0; i <= s.p; ++i)
    for (int j = 0; j <= s.q; ++j) visit(Exponents{i, s.p - i, j, s.q - j}, at++);
}

// The Bernstein coefficients of W^d q(F / W), in degrees (d p, d q).
std::vector<Rational> exact_coefficients(const FormShape& s, const ExactPoints& points,
                                         const SheetSeparator& q) {
  std::array<Polynomial, 4> y;  // w y1, w y2, w y3, w
  for_each_place(s, [&](const Exponents& e, std::size_t at) {
    const Rational w = points[at][3];
    y[3][e] = w * factor(s, e);
    for (std::size_t k = 0; k < 3; ++k)
      y[k][e] = (points[at][k] - from(q.origin[k]) * w) / from(q.unit) * factor(s, e);
  });
  std::array<std::vector<Polynomial>, 4> powers;
  for (std::size_t k = 0; k < 4; ++k) {
    powers[k].push_back({{Exponents{}, Rational(1)}});
    for (int d = 0; d < q.degree; ++d) powers[k].push_back(product(powers[k].back(), y[k]));
  }
  Polynomial sum;
  std::size_t i = 0;
  for (int a = 0; a <= q.degree; ++a)
    for (int b = 0; a + b <= q.degree; ++b)
      for (int c = 0; a + b + c <= q.degree; ++c) {
        const auto power = [&](std::size_t k, int n) -> const Polynomial& {
          return powers[k][static_cast<std::size_t>(n)];
        };
        const Rational f(q.coefficients[i++]);
        const Polynomial m = product(product(power(0, a), power(1, b)),
                                     product(power(2, c), power(3, q.degree - a - b - c)));
        for (const auto& [e, v] : m) sum[e] += f * v;
      }
  std::vector<Rational> out;
  for (const auto& [e, v] : sum) out.push_back(v / factor(times(s, q.degree), e));
  return out;
}

// The separator near the piece, with values of about 2^bits on it.
SheetSeparator random_separator(Random& random, int degree, const Box3d& hull) {
  SheetSeparator q;
  q.degree = degree;
  q.unit =
      std::exp2(std::ceil(std::log2(extent(hull))) + static_cast<double>(random.between(0, 2)));
  for (std::size_t k = 0; k < 3; ++k)
    q.origin[k] = approx_centre(hull)[k] + (random.unit() - 0.5) * q.unit;
  const std::int64_t most = std::int64_t{1} << random.between(3, 30);
  for (std::size_t i = 0; i < SheetSeparator::num_coefficients(degree); ++i)
    q.coefficients.push_back(random.between(-most, most));
  q.coefficients[0] += random.between(-4, 4) * most / 2;
  return q;
}

struct Seen {
  int plus = 0, minus = 0, none = 0;
};

void expect_signs(const FormShape& shape, bool is_rational, std::uint64_t seed, Seen* seen) {
  Random random(seed);
  const PatchComplex complex = both_sides(bent_sheet(shape, is_rational, 0, 1, random));
  PieceForest forest = PieceForest::make(complex, PieceForest::FrameChoice::kWhole).value();
  for_some_nodes(forest, random, 4, [&](PieceForest::Id id, const ExactPoints& points) {
    for (int degree = 1; degree <= SheetSeparator::kMostDegree; ++degree)
      for (int trial = 0; trial < 4; ++trial) {
        const FormShape& s = forest.form(forest.node(id).patch).shape;  // of a reversed patch, too
        SheetSeparator q = random_separator(random, degree, forest.node(id).hull);
        std::vector<Rational> exact = exact_coefficients(s, points, q);
        ASSERT_EQ(exact.size(), times(s, degree).count());
        if (trial == 3 && !is_rational) {
          // Shift it so that the least coefficient is near 0, within one unit of the constant.
          const Rational least = *std::min_element(exact.begin(), exact.end());
          const double shift = std::floor(nearest_double(least));
          q.coefficients[0] -= static_cast<std::int64_t>(shift) + random.between(-1, 1);
          exact = exact_coefficients(s, points, q);
        }
        const Rational least = *std::min_element(exact.begin(), exact.end()),
                       greatest = *std::max_element(exact.begin(), exact.end());
        const Sign3 expected = least > Rational(0)      ? Sign3::kPositive
                               : greatest < Rational(0) ? Sign3::kNegative
                                                        : Sign3::kUncertain;
        // What the separator could have as its value, which errors are relative to.
        Rational size;
        for (const std::int64_t c : q.coefficients) size += abs(Rational(c));
        const Rational clear = size * Rational::power_of_two(-30);
        const Sign3 found = separator_sign(forest, id, q);
        const std::string what = "seed " + std::to_string(seed) + ", node " + std::to_string(id) +
                                 ", degree " + std::to_string(degree) + ", trial " +
                                 std::to_string(trial);
        const bool is_clear = least > clear || greatest < -clear;
        if (is_certain(found) || is_clear) {
          EXPECT_EQ(found, expected) << what;
        }
        seen->plus += found == Sign3::kPositive ? 1 : 0;
        seen->minus += found == Sign3::kNegative ? 1 : 0;
        seen->none += expected == Sign3::kUncertain ? 1 : 0;
      }
  });
}

TEST(SheetSeparator, HasTheSignThatAllExactCoefficientsHave) {
  Seen seen;
  std::uint64_t seed = 61;
  for (const FormShape& shape :
       {FormShape{false, 1, 1}, FormShape{false, 2, 1}, FormShape{false, 1, 3},
        FormShape{false, 2, 2}, FormShape{true, 1, 0}, FormShape{true, 2, 0},
        FormShape{true, 3, 0}})
    for (const bool is_rational : {false, true}) expect_signs(shape, is_rational, seed++, &seen);
  EXPECT_GT(seen.plus, 100);
  EXPECT_GT(seen.minus, 100);
  EXPECT_GT(seen.none, 100);
}

// The forest of a box from -1/2 to 1/2, in whose coordinates it has this side; node 0 .. 5 are its faces.
class OnABox : public testing::Test {
 protected:
  static Patches patches() {
    const Rational half = Rational(1) / Rational(2);
    return patch_shapes::box({-half, -half, -half}, {half, half, half});
  }
  // The face on which z has this sign.
  PieceForest::Id face(bool is_upper) {
    for (std::uint32_t r = 0; r < forest_.num_roots(); ++r) {
      const Box3d& hull = forest_.node(forest_.root(r)).hull;
      if (is_upper ? hull.lo[2] > 0.5 * size_ - 0x1p-20 : hull.hi[2] < -0.5 * size_ + 0x1p-20)
        return forest_.root(r);
    }
    return PieceForest::kNone;
  }
  PatchComplex complex_ = complex_of(patches());
  PieceForest forest_ = PieceForest::make(complex_, PieceForest::FrameChoice::kWhole).value();
  double size_ = std::ldexp(1.0, forest_.scale());
};

// Coefficients come in the order 1, y3, y3^2, y2, y2 y3, y2^2, y1, ...
TEST_F(OnABox, SeparatorsHaveTheirCoefficientsInTheOrderOfTheCertificate) {
  const auto sign = [&](int degree, std::initializer_list<std::pair<std::size_t, int>> terms,
                        PieceForest::Id id) {
    SheetSeparator q;
    q.degree = degree, q.unit = size_;
    q.coefficients.assign(SheetSeparator::num_coefficients(degree), 0);
    for (const auto& [at, value] : terms) q.coefficients[at] = value;
    return separator_sign(forest_, id, q);
  };
  const PieceForest::Id top = face(true), bottom = face(false);
  EXPECT_EQ(sign(1, {{1, 1}}, top), Sign3::kPositive);
  EXPECT_EQ(sign(1, {{1, 1}}, bottom), Sign3::kNegative);
  EXPECT_EQ(sign(1, {{2, 1}}, top), Sign3::kUncertain);
  EXPECT_EQ(sign(1, {{3, 1}}, top), Sign3::kUncertain);
  // On top y3 = 1/2, |y1|, |y2| <= 1/2.
  EXPECT_EQ(sign(1, {{0, -1}, {1, 1}, {2, 2}}, top), Sign3::kUncertain);
  EXPECT_EQ(sign(1, {{0, 1}, {1, -4}}, top), Sign3::kNegative);
  EXPECT_EQ(sign(1, {{0, 2}, {1, -4}}, top), Sign3::kUncertain);  // 0 everywhere
  EXPECT_EQ(sign(2, {{0, -1}, {2, 5}}, top), Sign3::kPositive);
  EXPECT_EQ(sign(2, {{0, -1}, {2, 5}}, bottom), Sign3::kPositive);
  EXPECT_EQ(sign(2, {{1, 5}, {4, 1}}, top), Sign3::kPositive);  // 5 y3 + y2 y3
  EXPECT_EQ(sign(2, {{1, 5}, {4, 1}}, bottom), Sign3::kNegative);
  EXPECT_EQ(sign(2, {{0, 1}, {5, -3}, {9, -3}}, top), Sign3::kUncertain);
  EXPECT_EQ(sign(2, {{0, 2}, {5, -3}, {9, -3}}, top), Sign3::kPositive);  // 2 - 3 y2^2 - 3 y1^2
  EXPECT_EQ(sign(3, {{3, 1}}, top), Sign3::kPositive);                    // y3^3
  EXPECT_EQ(sign(3, {{3, 1}}, bottom), Sign3::kNegative);
  EXPECT_EQ(sign(3, {{3, 17}, {9, 8}, {19, 8}}, top),
            Sign3::kPositive);  // 17 y3^3 + 8 y2^3 + 8 y1^3
  EXPECT_EQ(sign(3, {{3, 15}, {9, 8}, {19, 8}}, top), Sign3::kUncertain);
}

TEST_F(OnABox, SeparatorsOfExtremeUnitsNeverHaveAWrongSign) {
  const PieceForest::Id top = face(true);
  for (const int exponent : {-1060, -600, -340, 340, 600, 1020})
    for (int degree = 1; degree <= 3; ++degree) {
      SheetSeparator q;
      q.degree = degree, q.unit = std::ldexp(1.0, exponent);
      q.coefficients.assign(SheetSeparator::num_coefficients(degree), 0);
      q.coefficients[static_cast<std::size_t>(degree)] = 1;  // y3^degree > 0
      EXPECT_NE(separator_sign(forest_, top, q), Sign3::kNegative) << exponent;
      q.coefficients[static_cast<std::size_t>(degree)] = -1;
      EXPECT_NE(separator_sign(forest_, top, q), Sign3::kPositive) << exponent;
    }
}

TEST_F(OnABox, SeparatorsWithoutAllCoefficientsAreOurBug) {
  SheetSeparator q;
  q.degree = 2;
  q.coefficients.assign(4, 1);
  EXPECT_THROW((void)separator_sign(forest_, 0, q), InternalError);
}

}  // namespace
}  // namespace veritope
