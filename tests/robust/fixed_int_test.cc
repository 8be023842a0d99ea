// SPDX-License-Identifier: LGPL-3.0-or-later
#include "robust/fixed_int.h"

#include <gtest/gtest.h>

#include <type_traits>

#include "robust/base/random.h"

namespace veritope {
namespace {

// Compile-time use, and values at the ends of the range.
static_assert(FixedInt<2>(-5) * FixedInt<2>(7) == FixedInt<2>(-35));
static_assert(wide_product(FixedInt<3>(-5), FixedInt<2>(7)) == FixedInt<5>(-35));
static_assert((FixedInt<3>(-1) << 130 >> 130) == FixedInt<3>(-1));
static_assert(FixedInt<2>(int128{1} << 100) == FixedInt<2>(1) << 100);
static_assert(FixedInt<4>(FixedInt<2>(-3)) == FixedInt<4>(-3));
static_assert(bits_of_sum(3, 10) == 12 && bits_of_sum(1, 10) == 10 && bits_of_product(3, 4) == 7);

TEST(FixedInt, DoesNotConvertFromDoubleOrNarrow) {
  EXPECT_FALSE((std::is_constructible_v<FixedInt<2>, double>));
  EXPECT_FALSE((std::is_constructible_v<FixedInt<2>, FixedInt<3>>));
  EXPECT_FALSE((std::is_constructible_v<FixedInt<1>, int128>));
  EXPECT_FALSE((std::is_convertible_v<FixedInt<2>, FixedInt<3>>));
}

template <int L>
FixedInt<L> drawn(Random& random) {
  FixedInt<L> v;
  for (std::uint64_t& limb : v.limb) {
    const std::uint64_t kind = random.below(4);
    limb = kind == 0 ? 0 : (kind == 1 ? ~std::uint64_t{0} : random.next());
  }
  return v;
}

// v modulo 2^(64 L) as a two's complement number.
template <int L>
Integer wrapped(const Integer& v) {
  const Integer period = power_of_two(64 * L);
  Integer r = v - floor_divide(v, period) * period;
  return r.bit_length() >= 64 * L ? r - period : r;
}

template <int L>
void compare_with_integers(unsigned seed) {
  Random random(seed);
  for (int i = 0; i < 2000; ++i) {
    const FixedInt<L> a = drawn<L>(random), b = drawn<L>(random);
    const Integer p = a.to_integer(), q = b.to_integer();
    ASSERT_EQ((a + b).to_integer(), wrapped<L>(p + q));
    ASSERT_EQ((a - b).to_integer(), wrapped<L>(p - q));
    ASSERT_EQ((a * b).to_integer(), wrapped<L>(p * q));
    ASSERT_EQ((-a).to_integer(), wrapped<L>(-p));
    ASSERT_EQ(wide_product(a, b).to_integer(), p * q);
    const FixedInt<2> c = drawn<2>(random);
    ASSERT_EQ(wide_product(a, c).to_integer(), p * c.to_integer());
    ASSERT_EQ(wide_product(c, a).to_integer(), p * c.to_integer());
    ASSERT_EQ(a.sign(), p.sign());
    ASSERT_EQ(sign_of(a), p.sign());
    ASSERT_EQ(a <=> b, p <=> q);
    ASSERT_EQ(a <=> a, std::strong_ordering::equal);
    const int n = static_cast<int>(random.below(64 * L));
    Integer left = p, right = p;
    ASSERT_EQ((a << n).to_integer(), wrapped<L>(left.shift_left(static_cast<std::uint64_t>(n))));
    ASSERT_EQ((a >> n).to_integer(), right.shift_right(static_cast<std::uint64_t>(n)));
    ASSERT_EQ(FixedInt<L + 1>(a).to_integer(), p);
    if constexpr (L > 1) {
      FixedInt<L> low = a;  // equal upper limbs, so that the comparison reaches the lowest
      low.limb[0] ^= 1;
      ASSERT_EQ(low <=> a, low.to_integer() <=> p);
    }
  }
}

TEST(FixedInt, AgreesWithIntegersModuloItsRange) {
  compare_with_integers<1>(1);
  compare_with_integers<2>(2);
  compare_with_integers<3>(3);
  compare_with_integers<5>(4);
  compare_with_integers<8>(5);
}

TEST(FixedInt, HoldsTheLeastNumberOfItsRange) {
  const FixedInt<2> least = FixedInt<2>(1) << 127;
  EXPECT_EQ(least.to_integer(), -power_of_two(127));
  EXPECT_EQ(wide_product(least, least).to_integer(), power_of_two(254));
  EXPECT_TRUE(least.is_negative());
  EXPECT_TRUE((least + least).is_zero());
}

}  // namespace
}  // namespace veritope
