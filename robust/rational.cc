// SPDX-License-Identifier: LGPL-3.0-or-later
#include "robust/rational.h"

#include <bit>
#include <cstdint>
#include <utility>

#include "robust/base/check.h"
#include "robust/binary64.h"

namespace veritope {
namespace {

enum class Direction { kTowardZero, kNearest, kAwayFromZero };

// |numerator / den| rounded, as the bits of a non-negative double. The quotient keeps 53 bits, or fewer where the
// result is subnormal; the bits of consecutive doubles are consecutive integers, so that rounding
// up is adding one. REQUIRES den > 0.
std::uint64_t rounded_magnitude(const Integer& numerator, const Integer& den, Direction direction) {
  const Integer num = abs(numerator);
  if (num.is_zero()) return 0;
  // 2^(e-1) < num / den < 2^(e+1)
  const std::int64_t e =
      static_cast<std::int64_t>(num.bit_length()) - static_cast<std::int64_t>(den.bit_length());
  bool is_exact = false;
  const auto scaled_floor = [&](std::int64_t exponent, Integer& twice_excess) {
    // floor(num / den / 2^exponent)
    Integer n = num;
    Integer d = den;
    if (exponent < 0) {
      n.shift_left(static_cast<std::uint64_t>(-exponent));
    } else {
      d.shift_left(static_cast<std::uint64_t>(exponent));
    }
    Integer q = floor_divide(n, d);
    twice_excess = n.subtract_product(q, d);
    is_exact = twice_excess.is_zero();
    twice_excess.shift_left(1);
    twice_excess -= d;
    return q;
  };
  if (e > 1100) return direction == Direction::kTowardZero ? kMaxFiniteBits : kInfinityBits;
  std::int64_t lsb = e - 53;  // the quotient then has 53 or 54 bits
  if (lsb < kMinExponent) lsb = kMinExponent;
  Integer twice_excess;  // 2 * remainder - divisor: its sign says below, at or above one half
  Integer q = scaled_floor(lsb, twice_excess);
  if (q.bit_length() > 53) q = scaled_floor(++lsb, twice_excess);
  const std::uint64_t m = q.low_bits();
  // m * 2^lsb with m < 2^53; if lsb > kMinExponent then m >= 2^52.
  std::uint64_t bits =
      lsb == kMinExponent ? m : (static_cast<std::uint64_t>(lsb - kMinExponent) << 52) + m;
  if (bits > kMaxFiniteBits)
    return direction == Direction::kTowardZero ? kMaxFiniteBits : kInfinityBits;
  const Sign half = twice_excess.sign();
  bool up = false;
  if (direction == Direction::kNearest) {
    up = half == Sign::kPositive || (half == Sign::kZero && (m & 1) != 0);
  } else if (direction == Direction::kAwayFromZero) {
    up = !is_exact;
  }
  return bits + (up ? 1 : 0);
}

std::uint64_t rounded_magnitude(const Rational& a, Direction direction) {
  return rounded_magnitude(a.numerator(), a.denominator(), direction);
}

// Divides both by their greatest common divisor. REQUIRES that they are not both 0.
void cancel(Integer& a, Integer& b) noexcept {
  if (a == Integer(1) || b == Integer(1)) return;
  const Integer common = gcd(a, b);
  if (common == Integer(1)) return;
  a = divide_exactly(a, common);
  b = divide_exactly(b, common);
}

double with_sign(std::uint64_t magnitude, bool negative) {
  return std::bit_cast<double>(magnitude | (negative ? std::uint64_t{1} << 63 : 0));
}

}  // namespace

Rational& Rational::canonicalise() noexcept {
  if (den_.sign() == Sign::kNegative) {
    num_.negate();
    den_.negate();
  }
  if (den_ == Integer(1)) return *this;
  cancel(num_, den_);
  return *this;
}

Rational::Rational(Integer numerator, Integer denominator)
    : num_(std::move(numerator)), den_(std::move(denominator)) {
  VT_CHECK(!den_.is_zero(), "zero denominator");
  canonicalise();
}

Rational Rational::from_double(double value) {
  VT_CHECK(is_finite(value), "from_double of NaN or infinity");
  const Binary64 b = split(value);
  return Rational(Integer(b.mantissa)) * power_of_two(b.exponent);
}

Rational Rational::power_of_two(std::int64_t n) noexcept {
  Rational r(1);
  (n >= 0 ? r.num_ : r.den_).shift_left(static_cast<std::uint64_t>(n >= 0 ? n : -n));
  return r;
}

// Lowest terms by smaller divisors than that of the result (Henrici 1956; Knuth, The Art of Computer Programming,
// volume 2, section 4.5.1): with g = gcd(den_, b.den_) a common factor of the sum's numerator and of den_ b.den_ / g
// divides g. Canonical fractions with different denominators have no sum 0.
Rational& Rational::add(const Rational& b, bool is_difference) noexcept {
  const auto add_to_numerator = [&](const Integer& factor) {
    is_difference ? num_.subtract_product(b.num_, factor) : num_.add_product(b.num_, factor);
  };
  if (den_ == b.den_) {
    is_difference ? num_ -= b.num_ : num_ += b.num_;
    return canonicalise();
  }
  const Integer common = gcd(den_, b.den_);
  if (common == Integer(1)) {
    num_ *= b.den_;
    add_to_numerator(den_);
    den_ *= b.den_;
    return *this;
  }
  const Integer own = divide_exactly(den_, common), other = divide_exactly(b.den_, common);
  num_ *= other;
  add_to_numerator(own);
  const Integer superfluous = gcd(num_, common);
  if (superfluous == Integer(1)) {
    den_ *= other;
  } else {
    num_ = divide_exactly(num_, superfluous);
    den_ = own * other * divide_exactly(common, superfluous);
  }
  return *this;
}
Rational& Rational::operator+=(const Rational& b) noexcept { return add(b, false); }
Rational& Rational::operator-=(const Rational& b) noexcept { return add(b, true); }

// Common factors of the product's terms are those of one numerator and the other denominator.
Rational& Rational::operator*=(const Rational& b) noexcept {
  if (&b == this) {
    num_ *= num_;
    den_ *= den_;
    return *this;
  }
  Integer factor = b.num_, divisor = b.den_;
  cancel(num_, divisor);
  cancel(factor, den_);
  num_ *= factor;
  den_ *= divisor;
  return *this;
}
Rational& Rational::operator/=(const Rational& b) {
  VT_CHECK(!b.num_.is_zero(), "division by zero");
  Integer factor = b.den_, divisor = b.num_;
  cancel(num_, divisor);
  cancel(factor, den_);
  num_ *= factor;
  den_ *= divisor;
  if (den_.sign() == Sign::kPositive) return *this;
  num_.negate();
  den_.negate();
  return *this;
}
Rational& Rational::negate() noexcept {
  num_.negate();
  return *this;
}

std::strong_ordering operator<=>(const Rational& a, const Rational& b) noexcept {
  if (a.den_ == b.den_) return a.num_ <=> b.num_;
  return a.num_ * b.den_ <=> b.num_ * a.den_;
}

std::string Rational::to_string() const {
  return den_ == Integer(1) ? num_.to_string() : num_.to_string() + "/" + den_.to_string();
}

Rational abs(Rational a) noexcept { return a.sign() == Sign::kNegative ? -std::move(a) : a; }

double nearest_double(const Rational& a) {
  return with_sign(rounded_magnitude(a, Direction::kNearest), a.sign() == Sign::kNegative);
}
double nearest_quotient(const Integer& numerator, const Integer& denominator) {
  VT_CHECK(denominator.sign() == Sign::kPositive, "nearest_quotient over a positive denominator");
  return with_sign(rounded_magnitude(numerator, denominator, Direction::kNearest),
                   numerator.sign() == Sign::kNegative);
}
double round_down(const Rational& a) {
  const bool negative = a.sign() == Sign::kNegative;
  return with_sign(
      rounded_magnitude(a, negative ? Direction::kAwayFromZero : Direction::kTowardZero), negative);
}
double round_up(const Rational& a) {
  const bool negative = a.sign() == Sign::kNegative;
  return with_sign(
      rounded_magnitude(a, negative ? Direction::kTowardZero : Direction::kAwayFromZero), negative);
}

}  // namespace veritope
