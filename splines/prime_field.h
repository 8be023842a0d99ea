// SPDX-License-Identifier: LGPL-3.0-or-later
// splines/prime_field.h: numbers modulo primes just below 2^61, and integers from their remainders (Chinese remainder
// theorem).
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "robust/base/int128.h"
#include "robust/integer.h"

namespace veritope::internal {

/// Arithmetic modulo p = 2^61 - c. Numbers are in [0, p).
class PrimeField {
 public:
  using Number = std::uint64_t;
  static constexpr Number kTop = Number{1} << 61;
  /// The sum of this many products of two numbers and one number is below 2^128: 64 (2^61 - 1)^2 + 2^61.
  static constexpr std::size_t kMaxTerms = 64;

  /// REQUIRES 0 < c < 2^24. Only inverse() needs 2^61 - c to be prime.
  explicit PrimeField(Number c) : c_(c), p_(kTop - c) {}

  Number prime() const { return p_; }
  /// x mod p for any x: 2^61 = c, so x < 2^128 folds to less than 2^92, and that to less than 2^61 + 2^55 < 2 p.
  Number reduced(uint128 x) const {
    x = (x & kMask) + (x >> 61) * c_;
    x = (x & kMask) + (x >> 61) * c_;
    const Number r = static_cast<Number>(x);
    return r >= p_ ? r - p_ : r;
  }
  Number add(Number a, Number b) const { return a + b >= p_ ? a + b - p_ : a + b; }
  Number subtract(Number a, Number b) const { return a >= b ? a - b : a + p_ - b; }
  Number multiply(Number a, Number b) const { return reduced(uint128{a} * b); }
  Number power(Number a, Number n) const;
  /// REQUIRES p prime and a != 0.
  Number inverse(Number a) const { return power(a, p_ - 2); }
  /// a mod p, in [0, p) for negative a as well.
  Number of(const Integer& a) const;
  /// sum of a[i] b[i]
  Number dot(const Number* a, const Number* b, std::size_t count) const {
    uint128 sum = 0;
    for (; count > kMaxTerms; count -= kMaxTerms, a += kMaxTerms, b += kMaxTerms)
      sum = reduced(sum_of_products(sum, a, b, kMaxTerms));
    return reduced(sum_of_products(sum, a, b, count));
  }

 private:
  static constexpr Number kMask = kTop - 1;
  static uint128 sum_of_products(uint128 sum, const Number* a, const Number* b, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) sum += uint128{a[i]} * b[i];
    return sum;
  }
  Number c_, p_;
};

/// The `count` largest primes below 2^61, in descending order: the first is 2^61 - 1. REQUIRES count <= 4096, which
/// keeps c < 2^24. They are proved prime by the strong test to the first twelve prime bases, which decides all numbers
/// below 3.1 10^23 [SW17].
std::vector<PrimeField> largest_primes(std::size_t count);

/// Integers of less than 2^bits in magnitude from their remainders modulo the fewest largest primes that suffice.
class RemainderBasis {
 public:
  explicit RemainderBasis(std::uint64_t bits);
  std::span<const PrimeField> fields() const { return fields_; }
  /// remainder[k * stride] is modulo fields()[k]. Makes Garner's mixed digits, whose sums of products are reduced once
  /// per digit.
  Integer combined(const PrimeField::Number* remainder, std::size_t stride);

 private:
  std::uint64_t bits_;
  std::vector<PrimeField> fields_;
  // For the product p_0 p_1 ... p_(k - 1): its inverse modulo p_k, minus itself modulo each later prime, and its limbs.
  std::vector<PrimeField::Number> inverse_;
  std::vector<std::vector<PrimeField::Number>>
      minus_product_;  // [k][j], j < k: minus p_0 ... p_(j - 1) modulo p_k
  std::vector<std::vector<std::uint64_t>> product_;
  std::vector<PrimeField::Number>
      offset_;  // 2^bits modulo p_k: makes the remainders those of a positive number
  std::vector<PrimeField::Number> digit_;
  std::vector<std::uint64_t> limbs_;
};

}  // namespace veritope::internal
