// SPDX-License-Identifier: LGPL-3.0-or-later
#include "splines/ring.h"

#include <gtest/gtest.h>

#include "robust/base/check.h"

namespace veritope {
namespace {

static_assert(Ring<double> && Ring<Rational> && Ring<Integer>);

TEST(RingOfIntegers, TakesFractionsThatAreIntegers) {
  using Numbers = RingNumbers<Integer>;
  EXPECT_EQ(Numbers::ratio(-6, 3), Integer(-2));
  EXPECT_EQ(Numbers::ratio(0, 7), Integer(0));
  EXPECT_EQ(Numbers::of_knot(Rational(8) / Rational(4)), Integer(2));
  EXPECT_EQ(one<Integer>(), Integer(1));
}

TEST(RingOfIntegers, RefusesOtherFractions) {
  using Numbers = RingNumbers<Integer>;
  EXPECT_THROW(Numbers::ratio(1, 2), InternalError);
  EXPECT_THROW(Numbers::ratio(-7, 3), InternalError);
  EXPECT_THROW(Numbers::of_knot(Rational(1) / Rational(2)), InternalError);
}

}  // namespace
}  // namespace veritope
