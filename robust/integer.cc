// SPDX-License-Identifier: LGPL-3.0-or-later
#include "robust/integer.h"

#include <gmp.h>

#include <algorithm>
#include <bit>
#include <limits>
#include <numeric>

#include "robust/base/check.h"

namespace veritope {

static_assert(GMP_NUMB_BITS == 64 && sizeof(unsigned long) == 8, "written for 64-bit limbs");

namespace {

constexpr std::int64_t kLeast = std::numeric_limits<std::int64_t>::min();
constexpr std::uint64_t kBeyond = std::uint64_t{1} << 63;  // the least magnitude of a positive number that is not small

std::uint64_t magnitude(std::int64_t value) {
  return value < 0 ? 0 - static_cast<std::uint64_t>(value) : static_cast<std::uint64_t>(value);
}

}  // namespace

// An Integer as GMP sees it.
struct IntegerGmp {
  static bool is_small(const Integer& a) { return a.is_small(); }
  static std::int64_t small(const Integer& a) { return a.held_.small; }
  static bool are_small(const Integer& a, const Integer& b) { return a.is_small() && b.is_small(); }

  static __mpz_struct fields(const Integer& a) {
    __mpz_struct z;
    z._mp_alloc = a.held_.capacity;
    z._mp_size = a.held_.size;
    z._mp_d = reinterpret_cast<mp_limb_t*>(a.held_.limbs);
    return z;
  }
  // Takes over the limbs of z, or frees them if the number is small.
  static void hold(Integer& a, mpz_ptr z) {
    const std::size_t size = mpz_size(z);
    const std::uint64_t low = mpz_getlimbn(z, 0);
    const bool negative = mpz_sgn(z) < 0;
    a.held_ = Integer::Held();
    if (size > 1 || low > kBeyond || (low == kBeyond && !negative)) {
      a.held_.capacity = z->_mp_alloc;
      a.held_.size = z->_mp_size;
      a.held_.limbs = reinterpret_cast<std::uint64_t*>(z->_mp_d);
      return;
    }
    mpz_clear(z);
    a.held_.small = static_cast<std::int64_t>(negative ? 0 - low : low);
  }
};

namespace {

using Gmp = IntegerGmp;

// An mpz that is only read: it shares the limbs of an Integer, which must not change meanwhile.
class Operand {
 public:
  explicit Operand(const Integer& a) {
    if (Gmp::is_small(a)) {
      limb_ = magnitude(Gmp::small(a));
      mpz_roinit_n(z_, &limb_, Gmp::small(a) < 0 ? -1 : Gmp::small(a) > 0);
    } else {
      *z_ = Gmp::fields(a);
    }
  }
  Operand(const Operand&) = delete;
  operator mpz_srcptr() const { return z_; }

 private:
  mp_limb_t limb_ = 0;
  mpz_t z_;
};

// An mpz to be computed, which an Integer holds afterwards. GMP asks of operands that share the result's limbs that
// they are the result: is(b) says so.
class Result {
 public:
  explicit Result(Integer& to) : to_(to) {
    if (Gmp::is_small(to)) {
      mpz_init(z_);  // asks for no memory
    } else {
      *z_ = Gmp::fields(to);
    }
  }
  Result(const Result&) = delete;
  ~Result() { Gmp::hold(to_, z_); }

  operator mpz_ptr() { return z_; }
  bool is(const Integer& b) const { return &b == &to_ && !Gmp::is_small(b); }

 private:
  Integer& to_;
  mpz_t z_;
};

// to = f(to, b) with a function of GMP.
template <typename F>
Integer& update(Integer& to, const Integer& b, F f) {
  const Operand first(to), second(b);
  Result r(to);
  f(r, r.is(to) ? static_cast<mpz_srcptr>(r) : first, r.is(b) ? static_cast<mpz_srcptr>(r) : second);
  return to;
}
template <typename F>
Integer& update(Integer& to, F f) {
  const Operand first(to);
  Result r(to);
  f(r, r.is(to) ? static_cast<mpz_srcptr>(r) : first);
  return to;
}
// to = f(to, a, b); the old value of `to` is in the result.
template <typename F>
void update_sum(Integer& to, const Integer& a, const Integer& b, F f) {
  const Operand first(a), second(b);
  Result r(to);
  if (Gmp::is_small(to)) mpz_set_si(r, Gmp::small(to));
  f(r, r.is(a) ? static_cast<mpz_srcptr>(r) : first, r.is(b) ? static_cast<mpz_srcptr>(r) : second);
}
// f(a, b) as a new number.
template <typename F>
Integer computed(const Integer& a, const Integer& b, F f) {
  const Operand first(a), second(b);
  Integer to;
  {
    Result r(to);
    f(r, first, second);
  }
  return to;
}

}  // namespace

void Integer::copy_limbs() noexcept {
  const __mpz_struct from = Gmp::fields(*this);
  mpz_t z;
  mpz_init_set(z, &from);
  Gmp::hold(*this, z);
}
void Integer::free_limbs() noexcept {
  __mpz_struct z = Gmp::fields(*this);
  mpz_clear(&z);
}
Integer& Integer::assign(const Integer& other) noexcept {
  if (this == &other) return *this;
  const Operand from(other);
  Result r(*this);
  mpz_set(r, from);
  return *this;
}
void Integer::set_unsigned(std::uint64_t value) noexcept {
  Result r(*this);
  mpz_set_ui(r, value);
}

Integer Integer::from_limbs(const std::uint64_t* limbs, std::size_t count, bool negative) noexcept {
  Integer to;
  {
    Result r(to);
    mpz_import(r, count, -1, sizeof(std::uint64_t), 0, 0, limbs);
    if (negative) mpz_neg(r, r);
  }
  return to;
}

Integer Integer::from_decimal(std::string_view digits) {
  constexpr std::size_t kSurelySmall = 18;  // digits
  const bool negative = digits.starts_with('-');
  const std::string_view rest = digits.substr(negative ? 1 : 0);
  // GMP would skip blanks, and end at a zero byte.
  VT_CHECK(!rest.empty() && std::all_of(rest.begin(), rest.end(), [](char c) { return c >= '0' && c <= '9'; }),
           "not a decimal integer");
  if (rest.size() <= kSurelySmall) {
    std::int64_t value = 0;
    for (const char c : rest) value = 10 * value + (c - '0');
    return negative ? -value : value;
  }
  Integer to;
  {
    Result r(to);
    mpz_set_str(r, std::string(digits).c_str(), 10);
  }
  return to;
}

Integer& Integer::operator+=(const Integer& b) noexcept {
  std::int64_t sum;
  if (Gmp::are_small(*this, b) && !__builtin_add_overflow(held_.small, b.held_.small, &sum)) {
    held_.small = sum;
    return *this;
  }
  return update(*this, b, mpz_add);
}
Integer& Integer::operator-=(const Integer& b) noexcept {
  std::int64_t difference;
  if (Gmp::are_small(*this, b) && !__builtin_sub_overflow(held_.small, b.held_.small, &difference)) {
    held_.small = difference;
    return *this;
  }
  return update(*this, b, mpz_sub);
}
Integer& Integer::operator*=(const Integer& b) noexcept {
  std::int64_t product;
  if (Gmp::are_small(*this, b) && !__builtin_mul_overflow(held_.small, b.held_.small, &product)) {
    held_.small = product;
    return *this;
  }
  return update(*this, b, mpz_mul);
}
Integer& Integer::negate() noexcept {
  if (is_small() && held_.small != kLeast) {
    held_.small = -held_.small;
    return *this;
  }
  return update(*this, mpz_neg);
}
Integer& Integer::add_product(const Integer& a, const Integer& b) noexcept {
  std::int64_t product;
  std::int64_t sum;
  if (is_small() && Gmp::are_small(a, b) && !__builtin_mul_overflow(a.held_.small, b.held_.small, &product) &&
      !__builtin_add_overflow(held_.small, product, &sum)) {
    held_.small = sum;
  } else {
    update_sum(*this, a, b, mpz_addmul);
  }
  return *this;
}
Integer& Integer::subtract_product(const Integer& a, const Integer& b) noexcept {
  std::int64_t product;
  std::int64_t difference;
  if (is_small() && Gmp::are_small(a, b) && !__builtin_mul_overflow(a.held_.small, b.held_.small, &product) &&
      !__builtin_sub_overflow(held_.small, product, &difference)) {
    held_.small = difference;
  } else {
    update_sum(*this, a, b, mpz_submul);
  }
  return *this;
}
Integer& Integer::shift_left(std::uint64_t n) noexcept {
  if (is_small() && (held_.small == 0 || (n < 64 && n + bit_length() < 64))) {
    held_.small *= held_.small == 0 ? 0 : std::int64_t{1} << n;
    return *this;
  }
  return update(*this, [n](mpz_ptr to, mpz_srcptr from) { mpz_mul_2exp(to, from, n); });
}
Integer& Integer::shift_right(std::uint64_t n) noexcept {
  if (is_small()) {
    held_.small >>= n < 63 ? n : 63;
    return *this;
  }
  return update(*this, [n](mpz_ptr to, mpz_srcptr from) { mpz_fdiv_q_2exp(to, from, n); });
}

int Integer::compare(const Integer& a, const Integer& b) noexcept { return mpz_cmp(Operand(a), Operand(b)); }
std::uint64_t Integer::bit_length() const noexcept {
  if (is_small()) return static_cast<std::uint64_t>(std::bit_width(magnitude(held_.small)));
  return mpz_sizeinbase(Operand(*this), 2);
}
std::uint64_t Integer::trailing_zeros() const {
  VT_CHECK(!is_zero(), "trailing_zeros of zero");
  if (is_small()) return static_cast<std::uint64_t>(std::countr_zero(magnitude(held_.small)));
  return mpz_scan1(Operand(*this), 0);  // equal in two's complement and in |this|
}
std::int64_t Integer::to_int64() const {
  VT_CHECK(is_small(), "the integer is outside int64");
  return held_.small;
}
std::uint64_t Integer::low_bits() const noexcept {
  return is_small() ? magnitude(held_.small) : held_.limbs[0];
}
bool Integer::test_bit(std::uint64_t n) const noexcept {
  const std::uint64_t limb = mpz_getlimbn(Operand(*this), static_cast<mp_size_t>(n / 64));
  return (limb >> (n % 64) & 1) != 0;
}
std::vector<std::uint64_t> Integer::limbs() const {
  const Operand a(*this);
  return {mpz_limbs_read(a), mpz_limbs_read(a) + mpz_size(a)};
}
std::string Integer::to_string() const {
  if (is_small()) return std::to_string(held_.small);
  const Operand a(*this);
  std::string text(mpz_sizeinbase(a, 10) + 2, '\0');
  mpz_get_str(text.data(), 10, a);
  text.resize(text.find('\0'));
  return text;
}

Integer abs(Integer a) noexcept {
  if (a.sign() == Sign::kNegative) a.negate();
  return a;
}
Integer gcd(const Integer& a, const Integer& b) noexcept {
  if (Gmp::are_small(a, b)) return std::gcd(magnitude(Gmp::small(a)), magnitude(Gmp::small(b)));
  return computed(a, b, mpz_gcd);
}
Integer lcm(const Integer& a, const Integer& b) noexcept {
  if (a == b) return abs(a);
  return computed(a, b, mpz_lcm);
}
std::uint64_t remove_factor(Integer* a, const Integer& factor) {
  VT_CHECK(!a->is_zero() && factor > Integer(1), "every power of the factor divides the number");
  mp_bitcnt_t count = 0;
  update(*a, factor, [&count](mpz_ptr to, mpz_srcptr from, mpz_srcptr f) { count = mpz_remove(to, from, f); });
  return count;
}
std::uint64_t floor_remainder(const Integer& a, std::uint64_t m) {
  VT_CHECK(m != 0, "division by zero");
  return mpz_fdiv_ui(Operand(a), m);
}
Integer divide_exactly(const Integer& a, const Integer& b) {
  VT_CHECK(!b.is_zero(), "division by zero");
  if (Gmp::are_small(a, b) && Gmp::small(a) != kLeast) return Gmp::small(a) / Gmp::small(b);
  return computed(a, b, mpz_divexact);
}
Integer floor_divide(const Integer& a, const Integer& b) {
  VT_CHECK(!b.is_zero(), "division by zero");
  if (Gmp::are_small(a, b) && Gmp::small(a) != kLeast) {
    const std::int64_t n = Gmp::small(a);
    const std::int64_t d = Gmp::small(b);
    return n / d - (n % d != 0 && (n < 0) != (d < 0));
  }
  return computed(a, b, mpz_fdiv_q);
}
Integer floor_sqrt(const Integer& a) {
  VT_CHECK(a.sign() != Sign::kNegative, "square root of a negative number");
  Integer root = a;
  return update(root, mpz_sqrt);
}
Integer power_of_two(std::uint64_t n) noexcept {
  Integer r(1);
  return r.shift_left(n);
}
Integer power(const Integer& base, std::uint64_t n) noexcept {
  Integer r = base;
  return update(r, [n](mpz_ptr to, mpz_srcptr from) { mpz_pow_ui(to, from, n); });
}

}  // namespace veritope
