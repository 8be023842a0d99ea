// SPDX-License-Identifier: LGPL-3.0-or-later
#include "report/decimal_text.h"

#include <cmath>
#include <cstdint>

#include "report/text_style.h"

namespace veritope::report {
namespace {

// (-1)^is_negative * 0.d1d2d3... * 10^exponent, d1 != 0; zero has the digits "000...".
struct Decimal {
  bool is_negative = false;
  std::string digits;
  std::int64_t exponent = 0;
};

Integer power_of_ten(std::int64_t n) {
  return Integer::from_decimal("1" + std::string(static_cast<std::size_t>(n), '0'));
}

// p / q * 10^shift, rounded to an integer, ties to even. REQUIRES p >= 0, q > 0.
Integer scaled(Integer p, Integer q, std::int64_t shift) {
  if (shift >= 0) {
    p *= power_of_ten(shift);
  } else {
    q *= power_of_ten(-shift);
  }
  Integer whole = floor_divide(p, q);
  const Integer twice_rest = Integer(2) * (p - whole * q);
  if (twice_rest > q || (twice_rest == q && whole.test_bit(0))) whole += Integer(1);
  return whole;
}

// p / q >= 10^n. REQUIRES p, q > 0.
bool reaches(const Integer& p, const Integer& q, std::int64_t n) {
  return n >= 0 ? p >= q * power_of_ten(n) : p * power_of_ten(-n) >= q;
}

// The e with 10^(e-1) <= p / q < 10^e. REQUIRES p, q > 0.
std::int64_t decimal_exponent(const Integer& p, const Integer& q) {
  constexpr std::int64_t kLog2Times100000 = 30103;
  const auto bits =
      static_cast<std::int64_t>(p.bit_length()) - static_cast<std::int64_t>(q.bit_length());
  std::int64_t exponent = bits * kLog2Times100000 / 100000;  // off by little
  while (reaches(p, q, exponent)) ++exponent;
  while (!reaches(p, q, exponent - 1)) --exponent;
  return exponent;
}

Decimal to_decimal(const Rational& value, int num_digits) {
  Decimal out;
  const auto n = static_cast<std::size_t>(num_digits);
  if (value.sign() == Sign::kZero) {
    out.digits.assign(n, '0');
    out.exponent = 1;
    return out;
  }
  out.is_negative = value.sign() == Sign::kNegative;
  const Integer p = abs(value.numerator()), q = value.denominator();
  out.exponent = decimal_exponent(p, q);
  out.digits = scaled(p, q, num_digits - out.exponent).to_string();
  if (out.digits.size() > n) {  // rounded up to a power of ten
    out.digits.pop_back();
    ++out.exponent;
  }
  return out;
}

std::string exponent_text(std::int64_t exponent) {
  const std::string digits = std::to_string(exponent < 0 ? -exponent : exponent);
  return std::string(exponent < 0 ? "e-" : "e+") + (digits.size() < 2 ? "0" : "") + digits;
}

std::string without_zeros(std::string text) {
  const std::size_t last = text.find_last_not_of('0');
  text.erase(last == text.npos ? 0 : last + 1);
  return text;
}

// REQUIRES d1 != 0 and no zeros at the end.
std::string plain_text(const std::string& digits, std::int64_t exponent) {
  const auto size = static_cast<std::int64_t>(digits.size());
  if (exponent <= 0) return "0." + std::string(static_cast<std::size_t>(-exponent), '0') + digits;
  if (exponent >= size) return digits + std::string(static_cast<std::size_t>(exponent - size), '0');
  const auto whole = static_cast<std::size_t>(exponent);
  return digits.substr(0, whole) + "." + digits.substr(whole);
}

// Different doubles have different texts of 17 digits.
template <typename Number>
std::array<std::string, 2> ends_of(const Number& lo, const Number& hi, int digits) {
  std::array<std::string, 2> out = {short_decimal(lo, digits), short_decimal(hi, digits)};
  for (int more = digits + 1; lo < hi && out[0] == out[1]; ++more)
    out = {short_decimal(lo, more), short_decimal(hi, more)};
  return out;
}

}  // namespace

std::string fraction_text(const Rational& value) {
  return value.numerator().to_string() + "/" + value.denominator().to_string();
}

std::string scientific_text(const Rational& value, int digits) {
  const Decimal d = to_decimal(value, digits);
  return (d.is_negative ? "-" : "") + d.digits.substr(0, 1) + "." + d.digits.substr(1) +
         exponent_text(d.exponent - 1);
}

std::string short_decimal(const Rational& value, int digits) {
  if (value.sign() == Sign::kZero) return "0";
  const Decimal d = to_decimal(value, digits);
  const std::string shown = without_zeros(d.digits);
  const std::string sign = d.is_negative ? "-" : "";
  if (d.exponent > -4 && d.exponent <= 12) return sign + plain_text(shown, d.exponent);
  return sign + shown.substr(0, 1) + (shown.size() > 1 ? "." : "") + shown.substr(1) +
         exponent_text(d.exponent - 1);
}

bool is_short_decimal(const Rational& value, int digits) {
  if (value.sign() == Sign::kZero) return true;
  const Decimal d = to_decimal(value, digits);
  const std::int64_t shift = d.exponent - digits;
  const Rational shown(Integer::from_decimal(d.digits));
  const Rational power(power_of_ten(shift < 0 ? -shift : shift));
  return abs(value) == (shift < 0 ? shown / power : shown * power);
}

std::string short_decimal(double value, int digits) {
  if (!std::isfinite(value)) return std::isnan(value) ? "nan" : (value < 0 ? "-inf" : "inf");
  return short_decimal(Rational::from_double(value), digits);
}

std::string point_text(const Point3d& p) {
  return unbroken("(" + short_decimal(p[0]) + ", " + short_decimal(p[1]) + ", " +
                  short_decimal(p[2]) + ")");
}

std::array<std::string, 2> range_ends(double lo, double hi, int digits) {
  return ends_of(lo, hi, digits);
}
std::array<std::string, 2> range_ends(const Rational& lo, const Rational& hi, int digits) {
  return ends_of(lo, hi, digits);
}

std::string range_text(const Interval& a, int digits) {
  const auto [lo, hi] = range_ends(a.lo(), a.hi(), digits);
  return lo == hi ? lo : lo + " to " + hi;
}

std::string box_text(const Box3d& box) {
  std::array<std::string, 2> out = {"(", "("};
  for (std::size_t k = 0; k < 3; ++k) {
    const auto ends = range_ends(box.lo[k], box.hi[k]);
    for (std::size_t i = 0; i < 2; ++i) out[i] += (k == 0 ? "" : ", ") + ends[i];
  }
  return unbroken(out[0] + ")") + " to " + unbroken(out[1] + ")");
}

std::string cut(std::string_view text, std::size_t size) {
  if (text.size() <= size) return std::string(text);
  return std::string(text.substr(0, size - 3)) + "...";
}

}  // namespace veritope::report
