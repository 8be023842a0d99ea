// SPDX-License-Identifier: LGPL-3.0-or-later
// The C++ checker's quotients of long numbers (star_ratio.h) against exact integers.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <vector>

#include "robust/base/random.h"
#include "robust/integer.h"
#include "verify/checker/patches/big.h"
#include "verify/checker/patches/star_ratio.h"

namespace veritope {
namespace {

const Integer kLimit = Integer(std::int64_t{1} << 61);

// n limbs of a number that fits, in two's complement.
std::vector<std::uint64_t> limbs_of(const Integer& v, int n) {
  std::vector<std::uint64_t> out;
  const bool is_negative = v < Integer(0);
  Integer rest = is_negative ? -v - Integer(1) : v;
  for (int i = 0; i < n; ++i) {
    out.push_back(is_negative ? ~rest.low_bits() : rest.low_bits());
    rest.shift_right(64);
  }
  return out;
}

void expect_right(const Integer& x, const Integer& w, int shift, int n) {
  const Integer divisor = w << static_cast<std::uint64_t>(shift);
  Integer expected = floor_divide(x, divisor);
  const Integer rest = x - expected * divisor;
  const bool is_limited = expected >= kLimit || -expected >= kLimit;
  if (is_limited) expected = expected < Integer(0) ? -kLimit : kLimit;
  const auto of_x = limbs_of(x, n), of_w = limbs_of(w, n);
  bool is_exact = false;
  const std::int64_t found = ::floor_ratio(of_x.data(), of_w.data(), n, shift, &is_exact);
  EXPECT_EQ(Integer(found), expected) << x.to_string() << " / " << w.to_string() << " 2^" << shift;
  if (!is_limited) {
    EXPECT_EQ(is_exact, rest.is_zero())
        << x.to_string() << " / " << w.to_string() << " 2^" << shift;
  }
}

Integer random_natural(Random& random, int bits) {
  Integer out(0);
  for (; bits > 0; bits -= 32) {
    out.shift_left(static_cast<std::uint64_t>(std::min(bits, 32)));
    out += Integer(static_cast<std::int64_t>(random.below(std::uint64_t{1} << std::min(bits, 32))));
  }
  return out;
}

TEST(CheckerRatio, IsTheFloorOfRandomQuotients) {
  Random random(1);
  for (int i = 0; i < 200'000; ++i) {
    const int of_w = 1 + static_cast<int>(random.below(300)),
              shift = static_cast<int>(random.below(121));
    const int of_x = std::max(1, of_w + shift + static_cast<int>(random.below(70)) - 4);
    const Integer w = random_natural(random, of_w) + Integer(1), x = random_natural(random, of_x);
    const int n = std::max(of_w + 1, of_x) / 64 + 1 + static_cast<int>(random.below(2));
    expect_right(x, w, shift, n);
    expect_right(-x, w, shift, n);
  }
}

TEST(CheckerRatio, IsExactForMultiplesAndTheirNeighbours) {
  Random random(2);
  for (int i = 0; i < 50'000; ++i) {
    const int of_w = 1 + static_cast<int>(random.below(260)),
              shift = static_cast<int>(random.below(121));
    const Integer w = random_natural(random, of_w) + Integer(1);
    Integer x = w * random_natural(random, 1 + static_cast<int>(random.below(62)));
    x.shift_left(static_cast<std::uint64_t>(shift));
    const int n = (of_w + shift + 66) / 64 + 1;
    for (int step = -1; step <= 1; ++step) {
      expect_right(x + Integer(step), w, shift, n);
      expect_right(-x + Integer(step), w, shift, n);
    }
  }
}

// Estimates from the highest limbs are one too great where the lower limbs of w are full.
TEST(CheckerRatio, IsRightWhereTheEstimateIsOneTooGreat) {
  int wrong_estimates = 0;
  for (int low_bits = 64; low_bits <= 192; low_bits += 32)
    for (std::int64_t q : {std::int64_t{1} << 60, (std::int64_t{1} << 61) - 1, std::int64_t{5}}) {
      // The highest 64 bits of w are 2^63, and what is below them is almost one more.
      const auto low = static_cast<std::uint64_t>(low_bits);
      const Integer w = (Integer(1) << (low + 63)) + (Integer(1) << low) - Integer(1);
      const Integer x = w * Integer(q) - Integer(1);
      expect_right(x, w, 0, low_bits / 64 + 3);
      expect_right(-x, w, 0, low_bits / 64 + 3);
      Integer top = x;
      top.shift_right(low + 63);
      wrong_estimates += top > Integer(q - 1) ? 1 : 0;
    }
  EXPECT_GT(wrong_estimates, 0);
}

Integer integer_of(const ::Big& v) {
  Integer out(0);
  for (std::size_t i = v.m.size(); i-- > 0;)
    for (const unsigned half : {32u, 0u})
      out = (out << 32) + Integer(static_cast<std::int64_t>(v.m[i] >> half & 0xffffffffu));
  return v.neg ? -out : out;
}
::Big big_of(const Integer& v) {
  const auto limbs = limbs_of(v, 8);
  return ::Big::of(limbs.data(), 8);
}

// Short numbers take other ways than long ones.
TEST(CheckerBig, DividesAndFindsCommonDivisorsOfAllLengths) {
  Random random(3);
  for (int i = 0; i < 100'000; ++i) {
    const Integer common =
        random_natural(random, 1 + static_cast<int>(random.below(90))) + Integer(1);
    Integer a = common * random_natural(random, static_cast<int>(random.below(150)));
    Integer b = common * (random_natural(random, static_cast<int>(random.below(70))) + Integer(1));
    if (random.below(2) == 0) a = -a;
    if (random.below(2) == 0) b = -b;
    ::Big rest;
    const ::Big quotient = ::divide(big_of(a), big_of(b), &rest);
    const Integer q = integer_of(quotient), r = integer_of(rest);
    ASSERT_EQ(q * b + r, a) << a.to_string() << " / " << b.to_string();
    ASSERT_TRUE(r.is_zero() || (r < Integer(0)) == (a < Integer(0)));
    ASSERT_TRUE(abs(r) < abs(b));
    ASSERT_EQ(integer_of(::gcd(big_of(a), big_of(b))), abs(gcd(a, b)))
        << a.to_string() << ", " << b.to_string();
  }
}

}  // namespace
}  // namespace veritope
