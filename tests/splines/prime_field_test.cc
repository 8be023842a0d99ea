// SPDX-License-Identifier: LGPL-3.0-or-later
#include "splines/prime_field.h"

#include <gtest/gtest.h>

#include "robust/base/check.h"
#include "robust/base/random.h"

namespace veritope::internal {
namespace {

constexpr uint128 kMost = ~uint128{0};

TEST(PrimeField, ReducesEveryNumberOf128Bits) {
  Random random(1);
  for (const std::uint64_t c : {1u, 31u, (1u << 24) - 1}) {
    const PrimeField field(c);
    const uint128 p = field.prime();
    std::vector<uint128> cases{0,
                               p - 1,
                               p,
                               p + 1,
                               2 * p - 1,
                               2 * p,
                               p * p,
                               (p - 1) * (p - 1),
                               kMost,
                               kMost - 1,
                               kMost / p * p,
                               kMost / p * p - 1};
    for (int i = 0; i < 10000; ++i)
      cases.push_back((uint128{random.next()} << 64 | random.next()) >> random.below(128));
    for (const uint128 x : cases)
      ASSERT_EQ(field.reduced(x), static_cast<std::uint64_t>(x % p))
          << "c " << c << ", x " << static_cast<std::uint64_t>(x >> 64) << " * 2^64 + "
          << static_cast<std::uint64_t>(x);
  }
}

TEST(PrimeField, AddsUpProductsOfTheLargestNumbers) {
  const PrimeField field(1);
  for (const std::size_t count : {0u, 1u, 63u, 64u, 65u, 128u, 129u, 1000u}) {
    const std::vector<std::uint64_t> largest(count, field.prime() - 1);
    EXPECT_EQ(field.dot(largest.data(), largest.data(), count), count % field.prime());
  }
}

TEST(PrimeField, KnowsInversesAndNegativeIntegers) {
  Random random(2);
  for (const PrimeField& field : largest_primes(3)) {
    EXPECT_EQ(field.of(Integer(-1)), field.prime() - 1);
    EXPECT_EQ(field.of(power_of_two(61)), PrimeField::kTop - field.prime());
    for (int i = 0; i < 100; ++i) {
      const std::uint64_t a = 1 + random.below(field.prime() - 1);
      EXPECT_EQ(field.multiply(a, field.inverse(a)), 1u) << a;
    }
  }
}

// Known: the numbers k for which 2^61 - k is prime begin so.
TEST(LargestPrimes, AreThePrimesBelowTwoToThe61) {
  const std::vector<std::uint64_t> known{1, 31, 45, 229, 259, 283, 339, 391, 403, 465};
  const auto primes = largest_primes(known.size());
  for (std::size_t i = 0; i < known.size(); ++i)
    EXPECT_EQ(PrimeField::kTop - primes[i].prime(), known[i]);
}

TEST(LargestPrimes, AreNoMoreThanProvedToExist) {
  EXPECT_THROW(static_cast<void>(largest_primes(4097)), InternalError);
}

TEST(RemainderBasis, FindsEveryIntegerBelowItsBits) {
  Random random(3);
  for (const std::uint64_t bits : {0u, 1u, 59u, 60u, 61u, 63u, 64u, 65u, 127u, 128u, 636u, 5000u}) {
    RemainderBasis basis(bits);
    const Integer most = power_of_two(bits) - Integer(1);
    std::vector<Integer> cases{0, most, -most};
    for (int i = 0; i < 30; ++i) {
      Integer n;
      for (std::uint64_t b = 0; b < bits; b += 61)
        n = n.shift_left(61) + Integer(static_cast<std::int64_t>(random.next() >> 3));
      n.shift_right(n.bit_length() > bits ? n.bit_length() - bits : 0);
      cases.push_back(i % 2 == 0 ? n : -n);
    }
    for (const Integer& n : cases) {
      std::vector<std::uint64_t> remainders;
      for (const PrimeField& field : basis.fields()) {
        remainders.push_back(field.of(n));
        remainders.push_back(12345);  // not its own
      }
      ASSERT_EQ(basis.combined(remainders.data(), 2), n) << "bits " << bits;
    }
  }
}

}  // namespace
}  // namespace veritope::internal
