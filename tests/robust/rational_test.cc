// SPDX-License-Identifier: LGPL-3.0-or-later
#include "robust/rational.h"

#include <gmpxx.h>
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>
#include <type_traits>

#include "robust/base/check.h"
#include "robust/base/random.h"
#include "robust/binary64.h"

namespace veritope {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

TEST(Rational, IsInLowestTermsWithAPositiveDenominator) {
  EXPECT_EQ(Rational(Integer(6), Integer(-4)).to_string(), "-3/2");
  EXPECT_EQ(Rational(Integer(0), Integer(-4)).to_string(), "0");
  EXPECT_EQ(Rational(5).to_string(), "5");
  EXPECT_EQ(Rational().denominator(), Integer(1));
  EXPECT_THROW(Rational(Integer(1), Integer(0)), InternalError);
}

TEST(Rational, DoesNotConvertFromOrToDouble) {
  EXPECT_FALSE((std::is_constructible_v<Rational, double>));
  EXPECT_FALSE((std::is_convertible_v<Rational, double>));
}

TEST(Rational, IsAnOrderedField) {
  const Rational a(Integer(1), Integer(3)), b(Integer(-2), Integer(5));
  EXPECT_EQ((a + b).to_string(), "-1/15");
  EXPECT_EQ((a - b).to_string(), "11/15");
  EXPECT_EQ((a * b).to_string(), "-2/15");
  EXPECT_EQ((a / b).to_string(), "-5/6");
  EXPECT_EQ((-a).to_string(), "-1/3");
  EXPECT_LT(b, a);
  EXPECT_GT(a, b);
  EXPECT_EQ(abs(b).to_string(), "2/5");
  EXPECT_EQ(abs(a), a);
  EXPECT_EQ(sign_of(b), Sign::kNegative);
  EXPECT_THROW(a / Rational(), InternalError);
}

TEST(Rational, TakesADoublesExactValue) {
  EXPECT_EQ(Rational::from_double(0.1).to_string(), "3602879701896397/36028797018963968");
  EXPECT_EQ(Rational::from_double(-0.0), Rational());
  EXPECT_EQ(Rational::from_double(5e-324), Rational::power_of_two(-1074));
  EXPECT_EQ(Rational::from_double(-0x1p1023), -Rational::power_of_two(1023));
  EXPECT_THROW(Rational::from_double(kInfinity), InternalError);
  EXPECT_THROW(Rational::from_double(std::nan("")), InternalError);
}

TEST(Rational, RoundsToItselfIfItIsADouble) {
  Random random(3);
  for (int i = 0; i < 20000; ++i) {
    const double v = std::bit_cast<double>(random.next());
    if (!is_finite(v)) continue;
    const Rational r = Rational::from_double(v);
    ASSERT_EQ(nearest_double(r), v);
    ASSERT_EQ(round_down(r), v);
    ASSERT_EQ(round_up(r), v);
  }
}

TEST(Rational, RoundsBetweenDoublesDownUpAndToTheNearest) {
  Random random(4);
  for (int i = 0; i < 20000; ++i) {
    const double low = std::bit_cast<double>(random.next());
    const double high = std::nextafter(low, kInfinity);
    if (!is_finite(low) || !is_finite(high)) continue;
    const Rational a = Rational::from_double(low), b = Rational::from_double(high);
    const Rational quarter = (a * Rational(3) + b) / Rational(4), middle = (a + b) / Rational(2);
    ASSERT_EQ(round_down(quarter), low) << i;
    ASSERT_EQ(round_up(quarter), high) << i;
    ASSERT_EQ(nearest_double(quarter), low) << i;
    ASSERT_EQ(nearest_double(a + b - quarter), high) << i;
    const bool low_is_even = (std::bit_cast<std::uint64_t>(low) & 1) == 0;
    ASSERT_EQ(nearest_double(middle), low_is_even ? low : high) << i;
  }
}

TEST(Rational, RoundsQuotientsThatAreNotInLowestTerms) {
  Random random(5);
  for (int i = 0; i < 20000; ++i) {
    const double a = std::bit_cast<double>(random.next()), b = std::bit_cast<double>(random.next());
    if (!is_finite(a) || !is_finite(b) || b == 0) continue;
    const Rational q = Rational::from_double(a) / Rational::from_double(b);
    const Integer factor(random.between(1, 1'000'000'000));
    ASSERT_EQ(nearest_quotient(q.numerator() * factor, q.denominator() * factor), nearest_double(q))
        << i;
  }
  EXPECT_EQ(nearest_quotient(Integer(0), Integer(6)), 0);
  EXPECT_FALSE(std::signbit(nearest_quotient(Integer(0), Integer(6))));
  EXPECT_THROW(nearest_quotient(Integer(1), Integer(0)), InternalError);
  EXPECT_THROW(nearest_quotient(Integer(1), Integer(-2)), InternalError);
}

TEST(Rational, RoundsAtTheEndsOfTheRange) {
  const Rational tiny = Rational::power_of_two(-1075),
                 huge = Rational::from_double(0x1.fffffffffffffp1023);
  EXPECT_EQ(nearest_double(tiny), 0);  // a tie; 0 is even
  EXPECT_EQ(nearest_double(tiny * Rational(Integer(3), Integer(2))), 5e-324);
  EXPECT_EQ(round_up(Rational::power_of_two(-5000)), 5e-324);
  EXPECT_EQ(round_down(Rational::power_of_two(-5000)), 0);
  EXPECT_EQ(round_down(-Rational::power_of_two(-5000)), -5e-324);
  const Rational half_ulp = Rational::power_of_two(970);
  EXPECT_EQ(nearest_double(huge + half_ulp), kInfinity);
  EXPECT_EQ(nearest_double(huge + half_ulp - Rational(1)), 0x1.fffffffffffffp1023);
  EXPECT_EQ(round_down(huge + half_ulp), 0x1.fffffffffffffp1023);
  EXPECT_EQ(round_up(huge + Rational(1)), kInfinity);
  EXPECT_EQ(round_down(Rational::power_of_two(1024)), 0x1.fffffffffffffp1023);
  EXPECT_EQ(round_up(Rational::power_of_two(5000)), kInfinity);
  EXPECT_EQ(round_up(-Rational::power_of_two(5000)), -0x1.fffffffffffffp1023);
  EXPECT_EQ(nearest_double(-Rational::power_of_two(5000)), -kInfinity);
  EXPECT_EQ(std::signbit(nearest_double(Rational())), false);
}

TEST(Rational, AgreesWithGmpsOwnRationals) {
  Random random(9);
  for (int i = 0; i < 2000; ++i) {
    const std::int64_t p = random.between(-1000, 1000), q = random.between(1, 1000),
                       r = random.between(-1000, 1000), s = random.between(1, 1000);
    const Rational a{Integer(p), Integer(q)}, b{Integer(r), Integer(s)};
    mpq_class x(static_cast<long>(p), static_cast<long>(q)),
        y(static_cast<long>(r), static_cast<long>(s));
    x.canonicalize(), y.canonicalize();
    const auto same = [](const Rational& u, const mpq_class& v) {
      return u.to_string() == v.get_str();
    };
    ASSERT_TRUE(same(a + b, x + y) && same(a - b, x - y) && same(a * b, x * y));
    ASSERT_TRUE(r == 0 || same(a / b, x / y));
    ASSERT_EQ(a < b, x < y);
  }
}

// Products of small primes: numerators and denominators have many common factors, and up to some hundred bits.
TEST(Rational, IsInLowestTermsAfterEachOperation) {
  Random random(10);
  const auto draw = [&] {
    Integer out(random.between(0, 19) == 0 ? 0 : random.between(0, 1) == 0 ? 1 : -1);
    for (std::int64_t i = random.between(0, 60); i > 0; --i)
      out *=
          Integer(std::array{2, 2, 3, 5, 7, 65537}[static_cast<std::size_t>(random.between(0, 5))]);
    return out;
  };
  const auto of_gmp = [](const Integer& p, const Integer& q) {
    mpq_class out(p.to_string() + "/" + q.to_string());
    out.canonicalize();
    return out;
  };
  for (int i = 0; i < 3000; ++i) {
    const Integer p = draw(), r = draw();
    Integer q = draw(), s = draw();
    if (q.is_zero()) q = Integer(1);
    if (s.is_zero()) s = q;
    const Rational a(p, q), b(r, s);
    const mpq_class x = of_gmp(p, q), y = of_gmp(r, s);
    const auto same = [](const Rational& u, const mpq_class& v) {
      return u.to_string() == v.get_str() && u.denominator().sign() == Sign::kPositive;
    };
    ASSERT_TRUE(same(a + b, x + y)) << a.to_string() << " + " << b.to_string();
    ASSERT_TRUE(same(a - b, x - y)) << a.to_string() << " - " << b.to_string();
    ASSERT_TRUE(same(a * b, x * y)) << a.to_string() << " * " << b.to_string();
    ASSERT_TRUE(r.is_zero() || same(a / b, x / y)) << a.to_string() << " / " << b.to_string();
    Rational c = a;
    ASSERT_TRUE(same(c += c, x + x) && same(c *= c, 4 * x * x) && same(c -= c, 0)) << a.to_string();
    c = a;
    ASSERT_TRUE(p.is_zero() || same(c /= c, 1)) << a.to_string();
    ASSERT_EQ(a <=> b == 0, x == y);
  }
}

}  // namespace
}  // namespace veritope
