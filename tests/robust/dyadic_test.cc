// SPDX-License-Identifier: LGPL-3.0-or-later
#include "robust/dyadic.h"

#include <gtest/gtest.h>

#include <bit>
#include <limits>
#include <type_traits>

#include "robust/base/check.h"
#include "robust/base/random.h"
#include "robust/binary64.h"

namespace veritope {
namespace {

TEST(Dyadic, HasAnOddMantissa) {
  const Dyadic a(Integer(12), -3);
  EXPECT_EQ(a.mantissa(), Integer(3));
  EXPECT_EQ(a.exponent(), -1);
  EXPECT_EQ(a.to_string(), "3*2^-1");
  EXPECT_EQ(Dyadic(5).to_string(), "5");
  EXPECT_EQ(Dyadic(Integer(0), 77), Dyadic());
  EXPECT_EQ(Dyadic().to_string(), "0");
}

TEST(Dyadic, DoesNotConvertFromOrToDouble) {
  EXPECT_FALSE((std::is_constructible_v<Dyadic, double>));
  EXPECT_FALSE((std::is_convertible_v<Dyadic, double>));
}

TEST(Dyadic, RefusesWhatIsNotANumber) {
  EXPECT_THROW(Dyadic::from_double(std::numeric_limits<double>::infinity()), InternalError);
  EXPECT_THROW(Dyadic::from_double(std::numeric_limits<double>::quiet_NaN()), InternalError);
}

TEST(Dyadic, IsARingThatAgreesWithRationals) {
  Random random(11);
  const auto draw = [&] {
    const double v = std::bit_cast<double>(random.next());
    return is_finite(v) ? v : static_cast<double>(random.between(-2, 2));
  };
  for (int i = 0; i < 3000; ++i) {
    double x = draw(), y = i % 5 == 0 ? x : (i % 7 == 0 ? 0 : draw());
    if (i % 11 == 0) x = 0;
    const Dyadic a = Dyadic::from_double(x), b = Dyadic::from_double(y);
    const Rational p = Rational::from_double(x), q = Rational::from_double(y);
    ASSERT_EQ(a.to_rational(), p);
    ASSERT_EQ((a + b).to_rational(), p + q);
    ASSERT_EQ((a - b).to_rational(), p - q);
    ASSERT_EQ((a * b).to_rational(), p * q);
    ASSERT_EQ((-a).to_rational(), -p);
    ASSERT_EQ(a <=> b, p <=> q);
    ASSERT_EQ(a == b, p == q);
    ASSERT_EQ(sign_of(a), p.sign());
  }
  Dyadic c(3);
  c += Dyadic(4);
  c -= Dyadic(Integer(1), -1);
  EXPECT_EQ(c.to_string(), "13*2^-1");
}

}  // namespace
}  // namespace veritope
