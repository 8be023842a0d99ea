// SPDX-License-Identifier: LGPL-3.0-or-later
// Wide against GMP's integers: sums, differences and products of numbers with their bits anywhere.
#include "robust/wide.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "robust/base/random.h"
#include "robust/rational.h"

namespace veritope {
namespace {

using W = Wide<degree_limbs(3, 4)>;

// A Wide of degree 1 counts units of 2^kMinExponent, one of degree n units of its n-th power.
Rational exact(double v) { return Rational::from_double(v); }

// A finite double of any exponent, an end of the range, or a neighbour of a power of two.
double draw(Random& random) {
  const double ends[] = {0,
                         -0.0,
                         std::numeric_limits<double>::denorm_min(),
                         std::numeric_limits<double>::max(),
                         std::numeric_limits<double>::min(),
                         1};
  if (random.below(8) == 0) return ends[random.below(6)] * (random.below(2) == 0 ? 1 : -1);
  const double m = random.below(2) == 0 ? 1 + random.unit() : 1;
  const double v = std::ldexp(m, static_cast<int>(random.between(-1074, 1023)));
  const double near = random.below(3) == 0 ? std::nextafter(v, 0) : v;
  return random.below(2) == 0 ? near : -near;
}

TEST(Wide, SignsOfPolynomialsAreThoseOfRationals) {
  const std::uint64_t seed = 3;
  Random random(seed);
  for (int i = 0; i < 20000; ++i) {
    const double v[] = {draw(random), draw(random), draw(random), draw(random)};
    const W a = W::from_double(v[0]), b = W::from_double(v[1]), c = W::from_double(v[2]),
            d = W::from_double(v[3]);
    const Rational p = exact(v[0]), q = exact(v[1]), r = exact(v[2]), s = exact(v[3]);
    SCOPED_TRACE("seed " + std::to_string(seed) + " number " + std::to_string(i) + ": " +
                 p.to_string() + " " + q.to_string() + " " + r.to_string() + " " + s.to_string());
    ASSERT_EQ(a.sign(), p.sign());
    ASSERT_EQ((a + b).sign(), (p + q).sign());
    ASSERT_EQ((a - b).sign(), (p - q).sign());
    ASSERT_EQ((a * b - c * d).sign(), (p * q - r * s).sign());
    ASSERT_EQ(((a - b) * (c - d) * (a + d)).sign(), ((p - q) * (r - s) * (p + s)).sign());
    // An identity: nothing is lost on the way, carries and borrows through zero limbs included.
    ASSERT_EQ(((a + b) * (a - b) - (a * a - b * b)).sign(), Sign::kZero);
    ASSERT_EQ((((a + b) + c) * d - (a * d + (b * d + c * d))).sign(), Sign::kZero);
    ASSERT_EQ((((a - b) - c) * (d * d) - ((a * d - b * d) - c * d) * d).sign(), Sign::kZero);
  }
}

TEST(Wide, HoldsTheLargestValuesThatItsDegreeAllows) {
  const double most = std::numeric_limits<double>::max();
  const W a = W::from_double(most), b = W::from_double(-most);
  const W d = a - b;  // 2^2099 less something
  const W cube = d * d * d;
  W sum = cube;
  for (int i = 0; i < 15; ++i) sum = sum + cube;  // 2^4 times
  EXPECT_EQ(sum.sign(), Sign::kPositive);
  for (int i = 0; i < 16; ++i) sum = sum - cube;
  EXPECT_EQ(sum.sign(), Sign::kZero);
  EXPECT_EQ((b * d * d).sign(), Sign::kNegative);
}

TEST(Wide, CarriesAndBorrowsCrossZeroLimbs) {
  const W one = W::from_double(0x1p0), tiny = W::from_double(0x1p-1074),
          huge = W::from_double(0x1p1000);
  const W below = huge - tiny;  // a borrow through 2074 bits
  EXPECT_EQ((below - huge).sign(), Sign::kNegative);
  EXPECT_EQ((below + tiny - huge).sign(), Sign::kZero);
  EXPECT_EQ((below - one + tiny - huge + one).sign(), Sign::kZero);
  EXPECT_EQ((W() - tiny + tiny).sign(), Sign::kZero);
  EXPECT_EQ((W() * huge).sign(), Sign::kZero);
}

TEST(Wide, CopiesAreIndependent) {
  W a = W::from_double(0x1p1000) + W::from_double(1);
  const W b = a;
  a = W::from_double(-1);
  EXPECT_EQ(a.sign(), Sign::kNegative);
  EXPECT_EQ((b - W::from_double(0x1p1000)).sign(), Sign::kPositive);
  a = b;
  EXPECT_EQ((a - b).sign(), Sign::kZero);
}

}  // namespace
}  // namespace veritope
