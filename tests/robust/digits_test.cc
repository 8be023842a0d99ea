// SPDX-License-Identifier: LGPL-3.0-or-later
#include "robust/digits.h"

#include <gtest/gtest.h>

#include "robust/base/random.h"
#include "robust/integer.h"

namespace veritope {
namespace {

Integer big(int128 v) { return FixedInt<2>(v).to_integer(); }
template <int N>
Integer value(const Columns<N>& c) {
  Integer sum;
  for (int i = N; i-- > 0;) {
    sum.shift_left(kDigitBits);
    sum += big(c.c[i]);
  }
  return sum;
}
template <int N>
Integer value(const Digits<N>& d) {
  Integer sum;
  for (int i = N; i-- > 0;) {
    sum.shift_left(kDigitBits);
    sum += Integer(d.d[i]);
  }
  return sum;
}

// A digit at one of its limits, or any.
std::int64_t digit(Random& random, bool top) {
  const std::int64_t limit = std::int64_t{1} << kDigitBits;
  const std::int64_t values[] = {0, 1, limit - 1, limit / 2, random.between(0, limit - 1)};
  const std::int64_t v = values[random.below(5)];
  return top && random.below(2) == 0 ? -v - static_cast<std::int64_t>(random.below(2)) : v;
}
template <int N>
Digits<N> drawn(Random& random) {
  Digits<N> r;
  for (int i = 0; i < N; ++i) r.d[i] = digit(random, i == N - 1);
  return r;
}

template <int A, int B>
void expect_products(Random& random) {
  const Digits<A> a = drawn<A>(random), a2 = drawn<A>(random);
  const Digits<B> b = drawn<B>(random), b2 = drawn<B>(random);
  const auto p = column_product(a, b);
  ASSERT_EQ(value(p), value(a) * value(b));
  const auto sum = p - column_product(a2, b2), both = p + column_product(a2, b2);
  ASSERT_EQ(value(sum), value(a) * value(b) - value(a2) * value(b2));
  ASSERT_EQ(value(both), value(a) * value(b) + value(a2) * value(b2));
  ASSERT_EQ(sign_of(sum), value(sum).sign());
  ASSERT_EQ(value(settled(sum)), value(sum));
  ASSERT_EQ(value(carried(sum)), value(sum));
  for (int i = 0; i < A + B - 1; ++i) {
    ASSERT_GE(settled(sum).d[i], 0);
    ASSERT_LE(settled(sum).d[i], (std::int64_t{1} << kDigitBits) - 1);
  }
}

TEST(Digits, ProductsSumsAndCarriesAreThoseOfIntegers) {
  const std::uint64_t seed = 3;
  Random random(seed);
  for (int i = 0; i < 4000; ++i) {
    SCOPED_TRACE("seed " + std::to_string(seed) + " number " + std::to_string(i));
    expect_products<1, 1>(random);
    expect_products<2, 1>(random);
    expect_products<2, 2>(random);
    expect_products<2, 4>(random);
    expect_products<3, 3>(random);
    expect_products<3, 6>(random);
  }
}

TEST(Columns, TheSignIsThatOfAllDigits) {
  const int128 one = 1;
  const int128 digit = one << kDigitBits;
  const auto sign = [](const Columns<3>& c) { return sign_of(c); };
  EXPECT_EQ(sign({{0, 0, 0}}), Sign::kZero);
  EXPECT_EQ(sign({{1, 0, 0}}), Sign::kPositive);
  EXPECT_EQ(sign({{-1, 0, 0}}), Sign::kNegative);
  EXPECT_EQ(sign({{-digit, 1, 0}}), Sign::kZero);
  EXPECT_EQ(sign({{-digit + 1, 1, 0}}), Sign::kPositive);
  EXPECT_EQ(sign({{-digit - 1, 1, 0}}), Sign::kNegative);
  EXPECT_EQ(sign({{0, -digit, 1}}), Sign::kZero);
  EXPECT_EQ(sign({{0, 1 - digit, 1}}), Sign::kPositive);
  EXPECT_EQ(sign({{-1, -digit, 1}}), Sign::kNegative);
  EXPECT_EQ(sign({{-1, 0, 1}}), Sign::kPositive);
  EXPECT_EQ(sign({{(one << 126) - 1, 0, -1}}), Sign::kPositive);
  EXPECT_EQ(sign({{(one << 124) - 1, 0, -1}}), Sign::kNegative);
}

}  // namespace
}  // namespace veritope
