// SPDX-License-Identifier: LGPL-3.0-or-later
// io/base/decimal_exact.cc: decimals in big integers: the table of powers of ten, and the rounding that is always
// right.
#include <gmp.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "io/base/decimal.h"

namespace veritope::internal {
namespace {

class BigInt {
 public:
  BigInt() { mpz_init(value_); }
  ~BigInt() { mpz_clear(value_); }
  BigInt(const BigInt&) = delete;
  BigInt& operator=(const BigInt&) = delete;
  mpz_ptr get() { return value_; }
  std::int64_t num_bits() const { return static_cast<std::int64_t>(mpz_sizeinbase(value_, 2)); }

 private:
  mpz_t value_;
};

// The leading 128 bits of 5^q (q >= 0) or of 2^k / 5^-q, cut off; 10^q = 5^q 2^q.
PowerOfTen power_of_ten(int q) {
  BigInt five, bits;
  mpz_ui_pow_ui(five.get(), 5, static_cast<unsigned long>(std::abs(q)));
  const auto length = static_cast<int>(five.num_bits());
  PowerOfTen power{};
  if (q >= 0) {
    if (length <= 128) {
      mpz_mul_2exp(bits.get(), five.get(), static_cast<mp_bitcnt_t>(128 - length));
    } else {
      mpz_tdiv_q_2exp(bits.get(), five.get(), static_cast<mp_bitcnt_t>(length - 128));
    }
    power.exponent = length - 128 + q;
  } else {
    // 2^(length - 1) < 5^-q < 2^length, so the quotient has 128 bits.
    mpz_setbit(bits.get(), static_cast<mp_bitcnt_t>(127 + length));
    mpz_tdiv_q(bits.get(), bits.get(), five.get());
    power.exponent = q - 127 - length;
  }
  std::uint64_t words[2] = {0, 0};
  mpz_export(words, nullptr, -1, sizeof words[0], 0, 0, bits.get());
  power.low = words[0];
  power.high = words[1];
  return power;
}

std::vector<PowerOfTen> make_powers() {
  std::vector<PowerOfTen> powers;
  for (int q = kMinPower; q <= kMaxPower; ++q) powers.push_back(power_of_ten(q));
  return powers;
}

// numerator / denominator > 0, rounded.
double round_quotient(BigInt& numerator, BigInt& denominator) {
  // The quotient lies in (2^(k-1), 2^(k+1)); keep at least 53 bits, or down to 2^-1074.
  const std::int64_t k = numerator.num_bits() - denominator.num_bits();
  std::int64_t ulp = std::max<std::int64_t>(k - 53, -1074);
  const auto shift_to = [&](std::int64_t exponent) {
    if (exponent > 0) {
      mpz_mul_2exp(denominator.get(), denominator.get(), static_cast<mp_bitcnt_t>(exponent));
    } else if (exponent < 0) {
      mpz_mul_2exp(numerator.get(), numerator.get(), static_cast<mp_bitcnt_t>(-exponent));
    }
  };
  shift_to(ulp);
  BigInt quotient, rest;
  mpz_tdiv_qr(quotient.get(), rest.get(), numerator.get(), denominator.get());
  if (quotient.num_bits() > 53) {
    ++ulp;  // one bit more than fits
    const bool odd = mpz_odd_p(quotient.get()) != 0;
    mpz_tdiv_q_2exp(quotient.get(), quotient.get(), 1);
    if (odd) mpz_add(rest.get(), rest.get(), denominator.get());
    mpz_mul_2exp(denominator.get(), denominator.get(), 1);
  }
  mpz_mul_2exp(rest.get(), rest.get(), 1);
  const int half = mpz_cmp(rest.get(), denominator.get());
  if (half > 0 || (half == 0 && mpz_odd_p(quotient.get()) != 0)) {
    mpz_add_ui(quotient.get(), quotient.get(), 1);
  }
  // At most 2^53, so the conversion is exact; ldexp is exact or overflows to infinity.
  return std::ldexp(mpz_get_d(quotient.get()), static_cast<int>(ulp));
}

}  // namespace

const PowerOfTen* powers_of_ten() {
  static const std::vector<PowerOfTen> powers = make_powers();
  return powers.data();
}

double round_decimal_exactly(std::string_view digits, std::int64_t exponent) {
  const std::size_t first = digits.find_first_not_of('0');
  if (first == digits.npos) return 0;
  digits.remove_prefix(first);
  const std::size_t last = digits.find_last_not_of('0');
  exponent += static_cast<std::int64_t>(digits.size() - 1 - last);
  digits = digits.substr(0, last + 1);
  // 10^(magnitude - 1) <= value < 10^magnitude; 2^1024 < 10^309 and 2^-1075 > 10^-324.
  const std::int64_t magnitude = exponent + static_cast<std::int64_t>(digits.size());
  if (magnitude > 309) return std::numeric_limits<double>::infinity();
  if (magnitude < -323) return 0;
  BigInt numerator, denominator;
  mpz_set_str(numerator.get(), std::string(digits).c_str(), 10);
  BigInt& scaled = exponent >= 0 ? numerator : denominator;
  BigInt power;
  mpz_ui_pow_ui(power.get(), 10, static_cast<unsigned long>(std::abs(exponent)));
  if (exponent >= 0) {
    mpz_mul(scaled.get(), scaled.get(), power.get());
    mpz_set_ui(denominator.get(), 1);
  } else {
    mpz_set(scaled.get(), power.get());
  }
  return round_quotient(numerator, denominator);
}

}  // namespace veritope::internal
