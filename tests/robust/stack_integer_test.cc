// SPDX-License-Identifier: LGPL-3.0-or-later
#include "robust/stack_integer.h"

#include <gtest/gtest.h>

#include <array>
#include <string>

#include "robust/base/random.h"
#include "robust/integer.h"

namespace veritope {
namespace {

using Number = StackInteger<12>;

// One number in two representations.
struct Pair {
  Number ours;
  Integer theirs;
};
Pair operator+(const Pair& a, const Pair& b) { return {a.ours + b.ours, a.theirs + b.theirs}; }
Pair operator-(const Pair& a, const Pair& b) { return {a.ours - b.ours, a.theirs - b.theirs}; }
Pair operator*(const Pair& a, const Pair& b) { return {a.ours * b.ours, a.theirs * b.theirs}; }
Pair operator<<(const Pair& a, int n) {
  return {a.ours << n, a.theirs << static_cast<std::uint64_t>(n)};
}
Pair from(std::int64_t v) { return {Number(v), Integer(v)}; }

// Equal: the difference with the number that is built of theirs' bits is zero.
Number rebuilt(const Integer& v) {
  Number r;
  for (std::uint64_t bit = v.bit_length(); bit-- > 0;)
    r = (r << 1) + Number(v.test_bit(bit) ? 1 : 0);
  return v.sign() == Sign::kNegative ? -r : r;
}
void expect_same(const Pair& p) {
  ASSERT_EQ(p.ours.sign(), to_sign3(p.theirs.sign())) << p.theirs.to_string();
  EXPECT_EQ((p.ours - rebuilt(p.theirs)).sign(), Sign3::kZero) << p.theirs.to_string();
}

TEST(StackInteger, ComputesAsIntegersDo) {
  const std::uint64_t seed = 17;
  Random random(seed);
  const auto draw = [&]() -> Pair {
    constexpr std::int64_t kEdges[] = {0, 1, -1, INT64_MAX, INT64_MIN, std::int64_t{1} << 62};
    Pair p = from(random.below(3) == 0 ? kEdges[random.below(6)]
                                       : static_cast<std::int64_t>(random.next()));
    if (random.below(2) == 0) p = p << static_cast<int>(random.below(130));
    return random.below(2) == 0 ? p : p + from(static_cast<std::int64_t>(random.next()));
  };
  for (int i = 0; i < 3000; ++i) {
    SCOPED_TRACE("seed " + std::to_string(seed) + " number " + std::to_string(i));
    const Pair a = draw(), b = draw(), c = draw();
    ASSERT_NO_FATAL_FAILURE(expect_same(a + b));
    ASSERT_NO_FATAL_FAILURE(expect_same(a - b));
    ASSERT_NO_FATAL_FAILURE(expect_same(a * b));
    ASSERT_NO_FATAL_FAILURE(expect_same(a * b - b * a));
    ASSERT_NO_FATAL_FAILURE(expect_same((a + b) * c - a * c));
    ASSERT_NO_FATAL_FAILURE(expect_same((a - a) * b + c));
    ASSERT_NO_FATAL_FAILURE(expect_same(a * b * c - (a << 64)));
    const Number copy = a.ours;
    EXPECT_EQ((copy - a.ours).sign(), Sign3::kZero);
    EXPECT_EQ((-copy + a.ours).sign(), Sign3::kZero);
  }
}

TEST(StackInteger, WhatDoesNotFitIsUnknownAndStaysSo) {
  const Number one(1), top = one << (64 * 12 - 1);
  EXPECT_EQ(top.sign(), Sign3::kPositive);
  EXPECT_EQ((one << 64 * 12).sign(), Sign3::kUncertain);
  const Number unknown = top + top;
  EXPECT_EQ(unknown.sign(), Sign3::kUncertain);
  EXPECT_EQ((top * (one << 100)).sign(), Sign3::kUncertain);
  for (const Number& v :
       {unknown + one, one - unknown, unknown * one, one * unknown, unknown * Number(0),
        Number(0) * unknown, unknown << 3, -unknown, unknown - unknown}) {
    EXPECT_EQ(v.sign(), Sign3::kUncertain);
  }
  EXPECT_EQ((top - top).sign(), Sign3::kZero);
  EXPECT_EQ((-top - (top - one)).sign(), Sign3::kNegative);  // all bits
  EXPECT_EQ((-top - top).sign(), Sign3::kUncertain);
}

TEST(StackInteger, MayBeAssignedToItself) {
  Number v(7);
  const Number& same = v;
  v = same;
  EXPECT_EQ((v - Number(7)).sign(), Sign3::kZero);
}

TEST(StackInteger, FromDigitsIsTheirSum) {
  Random random(18);
  constexpr std::int64_t kBase = std::int64_t{1} << 62;
  for (int i = 0; i < 2000; ++i) {
    const int count = static_cast<int>(random.between(1, 7));
    std::array<std::int64_t, 7> d{};
    Number sum;
    for (int k = count - 1; k >= 0; --k) {
      const std::uint64_t how = random.below(4);
      d[k] = how == 0 ? 0 : (how == 1 ? kBase - 1 : random.between(0, kBase - 1));
      if (k == count - 1 && random.below(2) == 0) d[k] = -d[k] - (how == 1);
      sum = (sum << 62) + Number(d[k]);
    }
    EXPECT_EQ((Number::from_digits(d.data(), count) - sum).sign(), Sign3::kZero) << i;
  }
}

}  // namespace
}  // namespace veritope
