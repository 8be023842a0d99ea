// SPDX-License-Identifier: LGPL-3.0-or-later
#include "splines/prime_field.h"

#include <gmp.h>

#include <algorithm>
#include <bit>
#include <utility>

#include "robust/base/check.h"

namespace veritope::internal {
namespace {

using Number = PrimeField::Number;

constexpr std::array<Number, 12> kBases{2, 3, 5, 7, 11, 13, 17, 19, 23, 29, 31, 37};

bool is_strong_probable_prime(const PrimeField& field, Number base) {
  const Number n = field.prime();
  const int twos = std::countr_zero(n - 1);
  Number x = field.power(base, (n - 1) >> twos);
  if (x == 1 || x == n - 1) return true;
  for (int i = 1; i < twos; ++i) {
    x = field.multiply(x, x);
    if (x == n - 1) return true;
  }
  return false;
}

bool is_prime(const PrimeField& field) {
  for (const Number b : kBases)
    if (field.prime() % b == 0) return false;
  for (const Number b : kBases)
    if (!is_strong_probable_prime(field, b)) return false;
  return true;
}

}  // namespace

static_assert(sizeof(mp_limb_t) == 8 && GMP_NAIL_BITS == 0);

PrimeField::Number PrimeField::power(Number a, Number n) const {
  Number result = 1;
  for (; n != 0; n >>= 1, a = multiply(a, a))
    if ((n & 1) != 0) result = multiply(result, a);
  return result;
}

PrimeField::Number PrimeField::of(const Integer& a) const {
  return floor_remainder(a, p_);
}

std::vector<PrimeField> largest_primes(std::size_t count) {
  VT_CHECK(count <= 4096, "so many primes lie above 2^61 - 2^24");
  std::vector<PrimeField> primes;
  for (Number c = 1; primes.size() < count; c += 2)
    if (const PrimeField field(c); is_prime(field)) primes.push_back(field);
  return primes;
}

RemainderBasis::RemainderBasis(std::uint64_t bits) : bits_(bits) {
  // All primes exceed 2^60.
  fields_ = largest_primes(static_cast<std::size_t>((bits + 1) / 60 + 1));
  const Integer least = power_of_two(bits + 1);
  Integer product(1);
  std::size_t k = 0;
  for (; product <= least; ++k) {
    const PrimeField& field = fields_[k];
    product_.push_back(product.limbs());
    offset_.push_back(field.power(2, bits));
    std::vector<Number> minus;
    Number prefix = 1;
    for (std::size_t j = 0; j < k; ++j) {
      minus.push_back(field.subtract(0, prefix));
      prefix = field.multiply(prefix, fields_[j].prime() % field.prime());
    }
    inverse_.push_back(field.inverse(prefix));
    minus_product_.push_back(std::move(minus));
    product *= Integer(field.prime());
  }
  fields_.resize(k, PrimeField(1));
  digit_.resize(k);
  limbs_.resize(product.limbs().size() + 1);
}

Integer RemainderBasis::combined(const Number* remainder, std::size_t stride) {
  for (std::size_t k = 0; k < fields_.size(); ++k) {
    const PrimeField& field = fields_[k];
    // digit_[j] is below 2^61 but may not be a number of this field: its products are below 2^122 all the same.
    const Number rest = field.add(field.add(remainder[k * stride], offset_[k]),
                                  field.dot(digit_.data(), minus_product_[k].data(), k));
    digit_[k] = field.multiply(rest, inverse_[k]);
  }
  const std::size_t size = limbs_.size();
  std::fill(limbs_.begin(), limbs_.end(), 0);
  for (std::size_t k = 0; k < fields_.size(); ++k) {
    const auto n = static_cast<mp_size_t>(product_[k].size());
    const mp_limb_t carry = mpn_addmul_1(limbs_.data(), product_[k].data(), n, digit_[k]);
    mpn_add_1(limbs_.data() + n, limbs_.data() + n, static_cast<mp_size_t>(size) - n, carry);
  }
  // Subtracts 2^bits: the number is below 2^(bits + 1), so the result is negative iff bit `bits` is not set.
  std::uint64_t& limb = limbs_[static_cast<std::size_t>(bits_ / 64)];
  const std::uint64_t bit = std::uint64_t{1} << bits_ % 64;
  if ((limb & bit) != 0) {
    limb ^= bit;
    return Integer::from_limbs(limbs_.data(), size, false);
  }
  return Integer::from_limbs(limbs_.data(), size, false) - power_of_two(bits_);
}

}  // namespace veritope::internal
