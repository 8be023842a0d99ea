// SPDX-License-Identifier: LGPL-3.0-or-later
#include "robust/short_relation.h"

#include <gtest/gtest.h>

#include "robust/base/random.h"
#include "robust/rational.h"

namespace veritope {
namespace {

using Polynomial = std::vector<Integer>;

Rational value_at(const Polynomial& m, const Rational& t) {
  Rational out;
  for (std::size_t i = m.size(); i-- > 0;) out = out * t + Rational(m[i]);
  return out;
}

// floor(2^bits x) for the root of m in [0, 1]. REQUIRES m(0) < 0 < m(1).
Integer root_of(const Polynomial& m, int bits) {
  Integer lo, hi = power_of_two(static_cast<std::uint64_t>(bits));
  const Rational unit = Rational::power_of_two(-bits);
  while (hi - lo > Integer(1)) {
    const Integer middle = (lo + hi).shift_right(1);
    (value_at(m, Rational(middle) * unit).sign() > 0 ? hi : lo) = middle;
  }
  return lo;
}

TEST(ShortRelation, FindsKnownPolynomials) {
  EXPECT_EQ(plausible_polynomial(root_of({-1, 0, 2}, 128), 128, 6), (Polynomial{-1, 0, 2}));
  EXPECT_EQ(plausible_polynomial(root_of({-1, 1, 0, 1}, 128), 128, 6), (Polynomial{-1, 1, 0, 1}));
  EXPECT_EQ(plausible_polynomial(root_of({-3, 0, 0, 0, 0, 0, 7}, 256), 256, 6),
            (Polynomial{-3, 0, 0, 0, 0, 0, 7}));
  EXPECT_EQ(plausible_polynomial(root_of({-3, 7}, 64), 64, 1), (Polynomial{-3, 7}));
  EXPECT_EQ(plausible_polynomial(Integer(0), 64, 3), (Polynomial{0, 1}));
  EXPECT_EQ(plausible_polynomial(power_of_two(64), 64, 3), (Polynomial{-1, 1}));
}

TEST(ShortRelation, GivesNoPolynomialForARandomNumber) {
  constexpr std::uint64_t kSeed = 20261127;
  Random random(kSeed);
  for (int i = 0; i < 20; ++i) {
    Integer x;
    for (int k = 0; k < 4; ++k) x = (x << 64) + Integer(random.next());
    EXPECT_TRUE(plausible_polynomial(x, 256, 4).empty())
        << "seed " << kSeed << ' ' << x.to_string();
  }
}

// Random irreducible cubics by Eisenstein's criterion: p divides all coefficients but the last, p^2 not the first.
TEST(ShortRelation, FindsRandomCubics) {
  constexpr std::uint64_t kSeed = 7;
  Random random(kSeed);
  for (int i = 0; i < 100; ++i) {
    const auto some = [&] { return static_cast<std::int64_t>(random.below(1u << 20)); };
    const Polynomial m{-7 * (7 * some() + 1), 7 * some(), 7 * some(),
                       7 * 7 * (std::int64_t{1} << 21) + 7 * some() + 1};
    Polynomial found = plausible_polynomial(root_of(m, 256), 256, 6);
    ASSERT_EQ(found.size(), 4u) << "seed " << kSeed << " case " << i;
    for (std::size_t k = 0; k < 4; ++k)  // a multiple of it
      EXPECT_EQ(found[k] * m[3], m[k] * found[3]) << "seed " << kSeed << " case " << i;
  }
}

TEST(ShortRelation, FindsTheRelationOfTwoNumbers) {
  // y = (1 + 3 x - x^2) / 5 for x = 1 / sqrt 2.
  const Integer x = root_of({-1, 0, 2}, 256);
  const Integer one = power_of_two(256), xx = (x * x).shift_right(256);
  const Integer y = floor_divide(one + Integer(3) * x - xx, Integer(5));
  std::vector<Integer> c = short_relation({one, x, y}, 256);
  if (c.back().sign() < 0)
    for (Integer& v : c) v.negate();
  EXPECT_EQ(c, (std::vector<Integer>{-1, -6, 10}));  // x^2 = 1/2
}

}  // namespace
}  // namespace veritope
