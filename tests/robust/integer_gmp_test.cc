// SPDX-License-Identifier: LGPL-3.0-or-later
// Integers that are held in the object and those that are GMP's, against GMP, on all pairs of numbers near the limits
// between them.
#include <gmpxx.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "robust/base/random.h"
#include "robust/integer.h"

namespace veritope {
namespace {

// Powers of two and their neighbours, with both signs, and random numbers of up to 200 bits.
std::vector<mpz_class> edge_numbers() {
  std::vector<mpz_class> out = {0};
  const auto add = [&out](const mpz_class& x) {
    out.push_back(x);
    out.push_back(-x);
  };
  for (const int bits : {0, 1, 31, 32, 61, 62, 63, 64, 65, 127, 128})
    for (const int near : {-1, 0, 1}) add((mpz_class(1) << static_cast<unsigned>(bits)) + near);
  Random random(1);
  for (const unsigned bits : {20u, 40u, 63u, 64u, 100u, 200u}) {
    mpz_class x = 0;
    for (unsigned i = 0; i < bits; ++i) x = 2 * x + (random.next() & 1);
    add(x);
  }
  return out;
}
Integer as_integer(const mpz_class& x) { return Integer::from_decimal(x.get_str()); }

// Also that a number which fits is held as one that fits: the forms must not depend on how a number came about.
void expect_same(const Integer& got, const mpz_class& want, const char* what) {
  EXPECT_EQ(got.to_string(), want.get_str()) << what;
  EXPECT_EQ(got, as_integer(want)) << what;
  EXPECT_EQ(got.fits_int64(), want.fits_slong_p()) << what;
  EXPECT_EQ(got.sign(), static_cast<Sign>(sgn(want))) << what;
}

void expect_same_of_one(const mpz_class& x) {
  const Integer a = as_integer(x);
  const mpz_class magnitude = abs(x);
  expect_same(a, x, "the number");
  expect_same(-a, -x, "negated");
  expect_same(abs(a), magnitude, "absolute value");
  expect_same(Integer(a), x, "copied");
  EXPECT_EQ(a.bit_length(), x == 0 ? 0 : mpz_sizeinbase(x.get_mpz_t(), 2));
  EXPECT_EQ(a.low_bits(), mpz_getlimbn(x.get_mpz_t(), 0));
  if (x != 0) {
    EXPECT_EQ(a.trailing_zeros(), mpz_scan1(x.get_mpz_t(), 0));
  }
  if (x.fits_slong_p()) {
    EXPECT_EQ(a.to_int64(), x.get_si());
  }
  const std::vector<std::uint64_t> limbs = a.limbs();
  EXPECT_EQ(limbs.size(), mpz_size(x.get_mpz_t()));
  expect_same(Integer::from_limbs(limbs.data(), limbs.size(), x < 0), x, "from its limbs");
  for (const std::uint64_t n : {0u, 1u, 2u, 31u, 62u, 63u, 64u, 65u, 130u}) {
    mpz_class down;
    mpz_fdiv_q_2exp(down.get_mpz_t(), x.get_mpz_t(), n);
    expect_same(a << n, x << n, "shifted up");
    expect_same(Integer(a).shift_right(n), down, "shifted down");
    EXPECT_EQ(a.test_bit(n), mpz_tstbit(magnitude.get_mpz_t(), n) != 0);
  }
  for (const std::uint64_t n : {0u, 1u, 2u, 3u}) {
    mpz_class power_of_x;
    mpz_pow_ui(power_of_x.get_mpz_t(), x.get_mpz_t(), n);
    expect_same(power(a, n), power_of_x, "power");
  }
  for (const std::uint64_t m : {std::uint64_t{1}, std::uint64_t{7}, ~std::uint64_t{0}})
    EXPECT_EQ(floor_remainder(a, m), mpz_fdiv_ui(x.get_mpz_t(), m));
  if (x >= 0) expect_same(floor_sqrt(a), sqrt(x), "square root");
}

void expect_same_of_two(const mpz_class& x, const mpz_class& y) {
  SCOPED_TRACE("and " + y.get_str());
  const Integer a = as_integer(x), b = as_integer(y);
  expect_same(a + b, x + y, "sum");
  expect_same(a - b, x - y, "difference");
  expect_same(a * b, x * y, "product");
  expect_same(Integer(a).add_product(b, b), x + y * y, "sum with a product");
  expect_same(Integer(a).subtract_product(b, a), x - y * x, "difference from a product");
  expect_same(gcd(a, b), gcd(x, y), "greatest common divisor");
  expect_same(lcm(a, b), lcm(x, y), "least common multiple");
  EXPECT_EQ(a == b, x == y);
  EXPECT_EQ(a < b, x < y);
  EXPECT_EQ(a > b, x > y);
  Integer assigned = a;
  assigned = b;
  expect_same(assigned, y, "assigned");
  Integer moved = a;
  moved = std::move(assigned);
  expect_same(moved, y, "moved");
  if (y == 0) return;
  mpz_class floor;
  mpz_fdiv_q(floor.get_mpz_t(), x.get_mpz_t(), y.get_mpz_t());
  expect_same(floor_divide(a, b), floor, "quotient");
  expect_same(divide_exactly(a * b, b), x, "exact quotient");
  if (x == 0 || y < 2) return;
  Integer rest = a * b * b;
  mpz_class want = x * y * y;
  const std::uint64_t times = mpz_remove(want.get_mpz_t(), want.get_mpz_t(), y.get_mpz_t());
  EXPECT_EQ(remove_factor(&rest, b), times);
  expect_same(rest, want, "without a factor");
}

TEST(Integer, AgreesWithGmpNearTheLimitsOfInt64) {
  const std::vector<mpz_class> numbers = edge_numbers();
  for (const mpz_class& x : numbers) {
    SCOPED_TRACE("seed 1, " + x.get_str());
    expect_same_of_one(x);
    for (const mpz_class& y : numbers) expect_same_of_two(x, y);
  }
}

TEST(Integer, MayBeAnOperandOfItsOwnOperation) {
  for (const mpz_class& x : edge_numbers()) {
    SCOPED_TRACE("seed 1, " + x.get_str());
    Integer sum = as_integer(x), difference = sum, product = sum, with_product = sum, without_product = sum, same = sum;
    sum += sum;
    const Integer& subtracted = difference;
    difference -= subtracted;
    product *= product;
    with_product.add_product(with_product, with_product);
    without_product.subtract_product(without_product, without_product);
    const Integer& alias = same;
    same = alias;
    expect_same(sum, x + x, "sum");
    expect_same(difference, 0, "difference");
    expect_same(product, x * x, "product");
    expect_same(with_product, x + x * x, "sum with a product");
    expect_same(without_product, x - x * x, "difference from a product");
    expect_same(same, x, "assigned to itself");
  }
}

TEST(Integer, TakesEveryBuiltInIntegerAtItsLimits) {
  EXPECT_EQ(Integer(INT64_MIN).to_string(), "-9223372036854775808");
  EXPECT_EQ(Integer(INT64_MAX).to_string(), "9223372036854775807");
  EXPECT_EQ(Integer(UINT64_MAX).to_string(), "18446744073709551615");
  EXPECT_EQ(Integer(std::uint64_t{1} << 63).to_string(), "9223372036854775808");
  EXPECT_EQ(Integer('a').to_string(), "97");
  EXPECT_EQ(Integer(std::int8_t{-128}).to_string(), "-128");
}

}  // namespace
}  // namespace veritope
