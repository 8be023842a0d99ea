// SPDX-License-Identifier: LGPL-3.0-or-later
#include "interval/exact_box.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "robust/base/check.h"
#include "robust/base/random.h"

namespace veritope {
namespace {

Rational q(long p, long d) { return Rational(p) / Rational(d); }

TEST(ExactBox, FloorLog2BracketsEveryFraction) {
  Random random(1);
  for (int i = 0; i < 500; ++i) {
    const Rational x =
        q(static_cast<long>(random.between(1, 5000)), static_cast<long>(random.between(1, 5000)));
    const std::int64_t e = floor_log2(-x);
    EXPECT_LE(Rational::power_of_two(e), x) << x.to_string();
    EXPECT_LT(x, Rational::power_of_two(e + 1)) << x.to_string();
  }
  EXPECT_THROW(floor_log2(Rational(0)), InternalError);
}

TEST(ExactBox, SimplestMemberHasTheLeastDenominator) {
  Random random(2);
  for (int i = 0; i < 300; ++i) {
    const Rational a = q(static_cast<long>(random.between(-300, 300)), 97),
                   b = a + q(static_cast<long>(random.between(0, 40)), 101);
    const Rational s = simplest_member({a, b});
    EXPECT_TRUE(a <= s && s <= b);
    for (long d = 1; Rational(d) < Rational(s.denominator()); ++d) {
      // No multiple of 1/d between a and b.
      const Integer n =
          floor_divide((b * Rational(d)).numerator(), (b * Rational(d)).denominator());
      EXPECT_LT(Rational(n) / Rational(d), a) << a.to_string() << " " << b.to_string();
    }
  }
}

TEST(ExactBox, ShortenedBoxesHoldTheirOriginals) {
  Random random(3);
  for (int i = 0; i < 200; ++i) {
    const Rational lo = q(static_cast<long>(random.between(-900, 900)), 577);
    const ExactBox<1> a{{ExactInterval{lo, lo + q(1, 1 + static_cast<long>(random.below(5000)))}}};
    const ExactBox<1> b = shortened(a, Rational::power_of_two(-40));
    EXPECT_TRUE(is_subset(a, b));
    EXPECT_LE(b.width(), a.width() * (Rational(1) + Rational::power_of_two(-18)));
    EXPECT_LT(b[0].lo.denominator().bit_length(), 64u);
  }
}

TEST(ExactBox, PlacedAndSeenFromAreInverse) {
  const ExactBox<2> frame{{ExactInterval{q(1, 3), q(1, 2)}, ExactInterval{q(-2, 7), q(5, 1)}}};
  const ExactBox<2> local{{ExactInterval{q(1, 8), q(3, 8)}, ExactInterval{q(-1, 8), q(9, 8)}}};
  EXPECT_EQ(seen_from(placed(local, frame), frame), local);
}

TEST(ExactBox, ComponentHullsDoNotTouch) {
  Random random(4);
  for (int loop = 0; loop < 50; ++loop) {
    std::vector<ExactBox<2>> boxes;
    for (int i = 0; i < 12; ++i) {
      ExactBox<2> b;
      for (ExactInterval& s : b.side) {
        s.lo = Rational(random.between(0, 60));
        s.hi = s.lo + Rational(random.between(0, 8));
      }
      boxes.push_back(b);
    }
    const auto hulls = component_hulls(boxes);
    for (std::size_t i = 0; i < hulls.size(); ++i)
      for (std::size_t j = 0; j < i; ++j) EXPECT_FALSE(touches(hulls[i], hulls[j]));
    for (const auto& b : boxes)
      EXPECT_EQ(
          std::count_if(hulls.begin(), hulls.end(), [&](const auto& h) { return is_subset(b, h); }),
          1);
  }
}

}  // namespace
}  // namespace veritope
