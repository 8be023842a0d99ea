// SPDX-License-Identifier: LGPL-3.0-or-later
#include "robust/limbs.h"

#include <gtest/gtest.h>

#include <vector>

#include "robust/base/random.h"
#include "robust/integer.h"

namespace veritope::internal {
namespace {

constexpr std::uint64_t kMost = ~std::uint64_t{0};
using Limbs = std::vector<std::uint64_t>;

Integer value(const Limbs& v) { return Integer::from_limbs(v.data(), v.size(), false); }
int size(const Limbs& v) { return static_cast<int>(v.size()); }

/// Limbs that are 0, 1, all bits or random.
Limbs draw(Random& random, std::size_t count) {
  Limbs v(count);
  for (std::uint64_t& limb : v) {
    const std::uint64_t how = random.below(4);
    limb = how == 0 ? 0 : how == 1 ? kMost : how == 2 ? 1 : random.next();
  }
  return v;
}

constexpr std::uint64_t sum_of_most(unsigned char carry) {
  return add_with_carry(carry, kMost, kMost);
}
constexpr std::uint64_t product_of_most(std::uint64_t carry) {
  return multiply_add(carry, kMost, kMost, kMost);
}
static_assert(sum_of_most(0) == kMost - 1 && sum_of_most(1) == kMost);
static_assert(product_of_most(kMost) == kMost && product_of_most(0) == 0);

TEST(Limbs, ASumOfTwoLimbsCarriesAtRunTimeAsWhenCompiling) {
  for (const unsigned char in : {0, 1}) {
    unsigned char carry = in;
    EXPECT_EQ(add_with_carry(carry, kMost, kMost), sum_of_most(in));
    EXPECT_EQ(carry, 1);
    carry = in;
    EXPECT_EQ(add_with_carry(carry, kMost, 0), in == 0 ? kMost : 0);
    EXPECT_EQ(carry, in);
  }
}

TEST(Limbs, TheLargestProductAndSumFillTwoLimbs) {
  std::uint64_t carry = kMost;
  EXPECT_EQ(multiply_add(carry, kMost, kMost, kMost), kMost);
  EXPECT_EQ(carry, kMost);
}

TEST(Limbs, ProductsAreThoseOfIntegers) {
  Random random(1);
  for (std::size_t m = 1; m <= 8; ++m) {
    for (std::size_t n = 1; n <= 8; ++n) {
      for (int i = 0; i < 20; ++i) {
        const Limbs a = draw(random, m), b = draw(random, n);
        Limbs r(m + n, 12345);
        multiply_limbs(r.data(), a.data(), size(a), b.data(), size(b));
        ASSERT_EQ(value(r), value(a) * value(b))
            << value(a).to_string() << " * " << value(b).to_string();
      }
    }
  }
}

TEST(Limbs, SumsAndDifferencesAreThoseOfIntegersWithTheCarry) {
  Random random(2);
  for (std::size_t m = 1; m <= 6; ++m) {
    const Integer limit = power_of_two(64 * m);
    for (std::size_t n = 0; n <= m; ++n) {
      for (int i = 0; i < 50; ++i) {
        const Limbs a = draw(random, m), b = draw(random, n);
        Limbs r(m, 12345);
        const unsigned char over =
            combine_limbs<true>(r.data(), a.data(), size(a), b.data(), size(b));
        ASSERT_EQ(value(r) + Integer(over) * limit, value(a) + value(b));
        const unsigned char not_below =
            combine_limbs<false>(r.data(), a.data(), size(a), b.data(), size(b));
        ASSERT_EQ(not_below, value(a) >= value(b));
        ASSERT_EQ(value(r), value(a) - value(b) + (not_below == 1 ? Integer(0) : limit));
      }
    }
  }
}

TEST(Limbs, CompareAsTheNumbersDo) {
  Random random(3);
  for (std::size_t n = 0; n <= 5; ++n) {
    for (int i = 0; i < 200; ++i) {
      const Limbs a = draw(random, n);
      Limbs b = a;
      if (n > 0 && random.below(3) > 0) b[random.below(n)] = draw(random, 1)[0];
      ASSERT_EQ(compare_limbs(a.data(), b.data(), size(a)), value(a) <=> value(b));
    }
  }
}

TEST(Limbs, SignificantSizeEndsAtTheHighestLimbThatIsNotZero) {
  const Limbs v{0, 5, 0, 0};
  EXPECT_EQ(significant_size(v.data(), 4), 2);
  EXPECT_EQ(significant_size(v.data(), 3), 2);
  EXPECT_EQ(significant_size(v.data(), 2), 2);
}

TEST(Limbs, MagnitudeHoldsTheLeastNumber) {
  EXPECT_EQ(magnitude_of(INT64_MIN), std::uint64_t{1} << 63);
  EXPECT_EQ(magnitude_of(-1), 1u);
  EXPECT_EQ(magnitude_of(0), 0u);
  EXPECT_EQ(magnitude_of(INT64_MAX), static_cast<std::uint64_t>(INT64_MAX));
}

}  // namespace
}  // namespace veritope::internal
