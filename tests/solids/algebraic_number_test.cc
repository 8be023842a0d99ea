// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/classify/algebraic_number.h"

#include <gtest/gtest.h>

namespace veritope {
namespace {

using Row = std::vector<Rational>;

Rational ratio(std::int64_t p, std::int64_t q = 1) { return Rational(p) / Rational(q); }

AlgebraicNumber rational(const Rational& x) { return {{-x.numerator(), x.denominator()}, x, x}; }
AlgebraicNumber root(std::vector<Integer> polynomial, const Rational& lo, const Rational& hi) {
  return {std::move(polynomial), lo, hi};
}
const AlgebraicNumber kRootOfHalf = root({-1, 0, 2}, ratio(70, 100), ratio(71, 100));
const AlgebraicNumber kRootOfThird = root({-1, 0, 3}, ratio(57, 100), ratio(58, 100));

// p(number k) modulo the pair's modulus.
Row value(const std::vector<Integer>& p, const PrimitivePair& pair, std::size_t k) {
  Row out{Rational(0)};
  for (std::size_t i = p.size(); i-- > 0;) {
    out = product_modulo(out, pair.numbers[k], pair.modulus);
    out[0] += Rational(p[i]);
  }
  return out;
}
bool is_zero(const Row& r) {
  for (const Rational& x : r)
    if (x.sign() != 0) return false;
  return true;
}
double approx(const Row& p, const Rational& t) {
  Rational out;
  for (std::size_t i = p.size(); i-- > 0;) out = out * t + p[i];
  return nearest_double(out);
}

void expect_pair(const AlgebraicPair& pair, std::size_t degree) {
  const auto primitive = primitive_pair(pair);
  ASSERT_TRUE(primitive.has_value());
  EXPECT_EQ(primitive->modulus.size(), degree + 1);
  EXPECT_LT(primitive->lo, primitive->hi);
  EXPECT_LT(approx(primitive->modulus, primitive->lo) * approx(primitive->modulus, primitive->hi),
            0);
  const Rational middle = (primitive->lo + primitive->hi) / Rational(2);
  for (std::size_t k = 0; k < 2; ++k) {
    EXPECT_TRUE(is_zero(value(pair[k].polynomial, *primitive, k))) << k;
    EXPECT_NEAR(approx(primitive->numbers[k], middle), nearest_double(pair[k].lo), 0.1) << k;
  }
}

TEST(PrimitivePair, HasBothNumbersAsPolynomialsOfOne) {
  expect_pair({{kRootOfHalf, kRootOfThird}, {}, 0}, 4);
  expect_pair({{rational(ratio(1, 3)), kRootOfThird}, {}, 0}, 2);
  expect_pair({{kRootOfHalf, rational(ratio(0))}, {}, 0}, 2);
  // The two roots of one cubic and of a square: degree 6.
  expect_pair({{root({-1, 1, 0, 1}, ratio(68, 100), ratio(69, 100)), kRootOfHalf}, {}, 0}, 6);
}

TEST(PrimitivePair, KeepsADependence) {
  // v = 1 - u.
  AlgebraicPair pair{{kRootOfHalf, root({1, -4, 2}, ratio(29, 100), ratio(30, 100))},
                     {Rational(1), Rational(-1)},
                     1};
  expect_pair(pair, 2);
  std::swap(pair.numbers[0], pair.numbers[1]);
  pair.dependent = 0;
  expect_pair(pair, 2);
}

TEST(PrimitivePair, IsNotForRationalNumbers) {
  EXPECT_FALSE(primitive_pair({{rational(ratio(1, 2)), rational(ratio(1, 3))}, {}, 0}).has_value());
}

TEST(ProductModulo, DividesByTheModulus) {
  const Row modulus{Rational(-1), Rational(0), Rational(2)};  // 2 t^2 = 1
  EXPECT_EQ(product_modulo({Rational(0), Rational(1)}, {Rational(0), Rational(1)}, modulus),
            (Row{ratio(1, 2), Rational(0)}));
  EXPECT_EQ(product_modulo({Rational(3)}, {Rational(5)}, modulus),
            (Row{Rational(15), Rational(0)}));
}

}  // namespace
}  // namespace veritope
