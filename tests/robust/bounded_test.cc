// SPDX-License-Identifier: LGPL-3.0-or-later
#include "robust/bounded.h"

#include <gtest/gtest.h>

#include "robust/base/random.h"
#include "robust/integer.h"

namespace veritope {
namespace {

template <int Bits, std::int64_t Terms>
constexpr int bits_of(const Bounded<Bits, Terms>&) {
  return Bounded<Bits, Terms>::kBits;
}

// The width follows the bound: the largest sums and products that a type holds, and the first that it does not.
static_assert(std::is_same_v<Bounded<62>::Held, std::int64_t> &&
              std::is_same_v<Bounded<63>::Held, int128>);
static_assert(std::is_same_v<Bounded<126>::Held, int128> &&
              std::is_same_v<Bounded<127>::Held, FixedInt<3>>);
static_assert(std::is_same_v<Bounded<61, 2>::Held, std::int64_t>);
static_assert(std::is_same_v<Bounded<61, 3>::Held, int128>, "three terms ask for two bits more");
static_assert(bits_of(Bounded<10>() + Bounded<10>()) == 11 &&
              bits_of(Bounded<10>() - Bounded<3>()) == 11);
static_assert(bits_of(Bounded<10>() + Bounded<10>() + Bounded<10>() + Bounded<10>()) == 12,
              "terms are counted, not carried one by one");
static_assert(bits_of(Bounded<10, 3>() * Bounded<20, 5>()) == 34);
static_assert(bits_of(sqr(Bounded<31>())) == 62 && bits_of(multiple<5>(Bounded<10>())) == 13);

template <int Bits, std::int64_t Terms>
Integer value(const Bounded<Bits, Terms>& v) {
  using Held = typename Bounded<Bits, Terms>::Held;
  if constexpr (sizeof(Held) == 8) {
    return Integer(v.held());
  } else {
    return FixedInt<internal::kLimbsOf<Held>>(v.held()).to_integer();
  }
}

/// 0, +-1, +-2^Bits or random, up to 2^Bits in magnitude.
template <int Bits>
Bounded<Bits> draw(Random& random) {
  using Held = typename Bounded<Bits>::Held;
  const Held most = Held(1) << Bits;
  Held v = Held(static_cast<std::int64_t>(random.below(2)));
  const std::uint64_t how = random.below(3);
  if (how == 1) v = most;
  if (how == 2) {
    for (int i = 0; i < Bits; ++i) v = v + v + Held(static_cast<std::int64_t>(random.below(2)));
    if (v > most) v = most;
  }
  return Bounded<Bits>::trusted(random.below(2) == 0 ? v : -v);
}

/// Laws of the ring at one width, beside GMP's integers; the operands reach the bound.
template <int Bits>
void expect_integers(std::uint64_t seed) {
  Random random(seed);
  for (int i = 0; i < 500; ++i) {
    const auto a = draw<Bits>(random), b = draw<Bits>(random), c = draw<Bits>(random),
               d = draw<Bits>(random);
    ASSERT_EQ(value(a + b), value(a) + value(b));
    ASSERT_EQ(value(a - b), value(a) - value(b));
    ASSERT_EQ(value(a * b), value(a) * value(b));
    const auto minor = a * d - b * c;
    const Integer expected = value(a) * value(d) - value(b) * value(c);
    ASSERT_EQ(value(minor), expected);
    ASSERT_EQ(value(sqr(minor) + a), expected * expected + value(a));
    ASSERT_EQ(sign_of(minor), expected.sign());
    ASSERT_EQ(value(multiple<7>(minor)), Integer(7) * expected);
  }
}

TEST(Bounded, ComputesAsIntegersDoAtEveryWidthUpToTheBound) {
  expect_integers<0>(1);
  expect_integers<1>(2);
  expect_integers<30>(3);
  expect_integers<31>(4);
  expect_integers<61>(5);
  expect_integers<62>(6);
  expect_integers<63>(7);
  expect_integers<125>(8);
  expect_integers<126>(9);
  expect_integers<127>(10);
  expect_integers<190>(11);
}

TEST(Bounded, ANumberFitsFewerBitsUpToTheirPowerOfTwo) {
  using Wide = Bounded<40>;
  for (const std::int64_t v : {std::int64_t{0}, std::int64_t{1} << 20, -(std::int64_t{1} << 20)}) {
    ASSERT_TRUE(internal::fits<20>(Wide::trusted(v)));
    EXPECT_EQ(internal::narrowed<20>(Wide::trusted(v)).held(), v);
  }
  EXPECT_FALSE(internal::fits<20>(Wide::trusted((std::int64_t{1} << 20) + 1)));
  EXPECT_FALSE(internal::fits<20>(Wide::trusted(-(std::int64_t{1} << 20) - 1)));
}

}  // namespace
}  // namespace veritope
