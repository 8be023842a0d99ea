// SPDX-License-Identifier: LGPL-3.0-or-later
#include "robust/integer.h"

#include <gmp.h>

#include <memory>
#include <new>

#include "robust/base/check.h"

namespace veritope {

static_assert(sizeof(__mpz_struct) <= 16 && alignof(__mpz_struct) <= alignof(void*));
static_assert(GMP_NUMB_BITS == 64 && sizeof(unsigned long) == 8, "written for 64-bit limbs");

namespace {
mpz_ptr z(Integer& a) { return std::launder(static_cast<mpz_ptr>(a.gmp())); }
mpz_srcptr z(const Integer& a) { return std::launder(static_cast<mpz_srcptr>(a.gmp())); }
}  // namespace

Integer::Integer() noexcept {
  ::new (static_cast<void*>(storage_)) __mpz_struct;
  mpz_init(z(*this));
}
Integer::Integer(const Integer& other) noexcept {
  ::new (static_cast<void*>(storage_)) __mpz_struct;
  mpz_init_set(z(*this), z(other));
}
Integer::Integer(Integer&& other) noexcept : Integer() { mpz_swap(z(*this), z(other)); }
Integer& Integer::operator=(const Integer& other) noexcept {
  mpz_set(z(*this), z(other));
  return *this;
}
Integer& Integer::operator=(Integer&& other) noexcept {
  mpz_swap(z(*this), z(other));
  return *this;
}
Integer::~Integer() { mpz_clear(z(*this)); }

void Integer::set_signed(long long value) noexcept { mpz_set_si(z(*this), value); }
void Integer::set_unsigned(unsigned long long value) noexcept { mpz_set_ui(z(*this), value); }

Integer Integer::from_limbs(const std::uint64_t* limbs, std::size_t count, bool negative) noexcept {
  Integer r;
  mpz_import(z(r), count, -1, sizeof(std::uint64_t), 0, 0, limbs);
  if (negative) mpz_neg(z(r), z(r));
  return r;
}

Integer Integer::from_decimal(std::string_view digits) {
  Integer r;
  VT_CHECK(mpz_set_str(z(r), std::string(digits).c_str(), 10) == 0, "not a decimal integer");
  return r;
}

Integer& Integer::operator+=(const Integer& b) noexcept {
  mpz_add(z(*this), z(*this), z(b));
  return *this;
}
Integer& Integer::operator-=(const Integer& b) noexcept {
  mpz_sub(z(*this), z(*this), z(b));
  return *this;
}
Integer& Integer::operator*=(const Integer& b) noexcept {
  mpz_mul(z(*this), z(*this), z(b));
  return *this;
}
Integer& Integer::negate() noexcept {
  mpz_neg(z(*this), z(*this));
  return *this;
}
Integer& Integer::add_product(const Integer& a, const Integer& b) noexcept {
  mpz_addmul(z(*this), z(a), z(b));
  return *this;
}
Integer& Integer::subtract_product(const Integer& a, const Integer& b) noexcept {
  mpz_submul(z(*this), z(a), z(b));
  return *this;
}
Integer& Integer::shift_left(std::uint64_t n) noexcept {
  mpz_mul_2exp(z(*this), z(*this), n);
  return *this;
}
Integer& Integer::shift_right(std::uint64_t n) noexcept {
  mpz_fdiv_q_2exp(z(*this), z(*this), n);
  return *this;
}

int Integer::compare(const Integer& a, const Integer& b) noexcept { return mpz_cmp(z(a), z(b)); }
Sign Integer::sign() const noexcept { return static_cast<Sign>(mpz_sgn(z(*this))); }
std::uint64_t Integer::bit_length() const noexcept {
  return is_zero() ? 0 : mpz_sizeinbase(z(*this), 2);
}
std::uint64_t Integer::trailing_zeros() const {
  VT_CHECK(!is_zero(), "trailing_zeros of zero");
  return mpz_scan1(z(*this), 0);  // equal in two's complement and in |this|
}
bool Integer::fits_int64() const noexcept { return mpz_fits_slong_p(z(*this)) != 0; }
std::int64_t Integer::to_int64() const {
  VT_CHECK(fits_int64(), "the integer is outside int64");
  return mpz_get_si(z(*this));
}
std::uint64_t Integer::low_bits() const noexcept { return mpz_get_ui(z(*this)); }
bool Integer::test_bit(std::uint64_t n) const noexcept {
  const std::uint64_t limb = mpz_getlimbn(z(*this), static_cast<mp_size_t>(n / 64));
  return (limb >> (n % 64) & 1) != 0;
}
std::string Integer::to_string() const {
  std::string text(mpz_sizeinbase(z(*this), 10) + 2, '\0');
  mpz_get_str(text.data(), 10, z(*this));
  text.resize(text.find('\0'));
  return text;
}

Integer abs(Integer a) noexcept {
  mpz_abs(z(a), z(a));
  return a;
}
Integer gcd(const Integer& a, const Integer& b) noexcept {
  Integer r;
  mpz_gcd(z(r), z(a), z(b));
  return r;
}
Integer divide_exactly(const Integer& a, const Integer& b) {
  VT_CHECK(!b.is_zero(), "division by zero");
  Integer r;
  mpz_divexact(z(r), z(a), z(b));
  return r;
}
Integer floor_divide(const Integer& a, const Integer& b) {
  VT_CHECK(!b.is_zero(), "division by zero");
  Integer r;
  mpz_fdiv_q(z(r), z(a), z(b));
  return r;
}
Integer floor_sqrt(const Integer& a) {
  VT_CHECK(a.sign() != Sign::kNegative, "square root of a negative number");
  Integer r;
  mpz_sqrt(z(r), z(a));
  return r;
}
Integer power_of_two(std::uint64_t n) noexcept {
  Integer r(1);
  return r.shift_left(n);
}
Integer power(const Integer& base, std::uint64_t n) noexcept {
  Integer r;
  mpz_pow_ui(z(r), z(base), n);
  return r;
}

}  // namespace veritope
