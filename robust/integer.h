// SPDX-License-Identifier: LGPL-3.0-or-later
// robust/integer.h: integers of any size; a thin owner of a GMP mpz. The heap is used as GMP uses it.
#pragma once
#include <compare>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <type_traits>

#include "robust/base/sign.h"

namespace veritope {

template <typename T>
concept BuiltinInteger = std::integral<T> && !std::same_as<T, bool> && sizeof(T) <= 8;

/// A mathematical integer. Ring operations never fail; out of memory ends the program (GMP aborts).
class Integer {
 public:
  Integer();
  /// Exact from every built-in integer type, and from nothing else: a double does not convert.
  template <BuiltinInteger T>
  Integer(T value) : Integer() {
    if constexpr (std::is_signed_v<T>) {
      set_signed(value);
    } else {
      set_unsigned(value);
    }
  }
  Integer(const Integer& other);
  Integer(Integer&& other) noexcept;
  Integer& operator=(const Integer& other);
  Integer& operator=(Integer&& other) noexcept;
  ~Integer();

  /// The integer sum of limbs[i] * 2^(64 i), limbs unsigned, negated if `negative`.
  static Integer from_limbs(const std::uint64_t* limbs, std::size_t count, bool negative);
  /// Decimal digits with an optional '-'. REQUIRES exactly that.
  static Integer from_decimal(std::string_view digits);

  Integer& operator+=(const Integer& b);
  Integer& operator-=(const Integer& b);
  Integer& operator*=(const Integer& b);
  friend Integer operator+(Integer a, const Integer& b) { return a += b; }
  friend Integer operator-(Integer a, const Integer& b) { return a -= b; }
  friend Integer operator*(Integer a, const Integer& b) { return a *= b; }
  friend Integer operator-(Integer a) { return a.negate(); }
  Integer& negate();
  /// *this += a * b and *this -= a * b, without a temporary.
  Integer& add_product(const Integer& a, const Integer& b);
  Integer& subtract_product(const Integer& a, const Integer& b);

  /// this * 2^n, exact.
  Integer& shift_left(std::uint64_t n);
  /// floor(this / 2^n).
  Integer& shift_right(std::uint64_t n);

  friend bool operator==(const Integer& a, const Integer& b) { return compare(a, b) == 0; }
  friend std::strong_ordering operator<=>(const Integer& a, const Integer& b) {
    return compare(a, b) <=> 0;
  }

  Sign sign() const;
  bool is_zero() const { return sign() == Sign::kZero; }
  /// Bits of |this|: 0 for 0, else floor(log2 |this|) + 1.
  std::uint64_t bit_length() const;
  /// Index of the lowest set bit of |this|. REQUIRES !is_zero().
  std::uint64_t trailing_zeros() const;
  bool fits_int64() const;
  /// REQUIRES fits_int64().
  std::int64_t to_int64() const;
  /// The low 64 bits of |this|.
  std::uint64_t low_bits() const;
  /// True iff bit n of |this| is set.
  bool test_bit(std::uint64_t n) const;
  /// "-12".
  std::string to_string() const;

  /// The GMP mpz (an mpz_ptr, an mpz_srcptr) for code that calls GMP itself; its header stays out of ours.
  void* gmp() { return storage_; }
  const void* gmp() const { return storage_; }

 private:
  static int compare(const Integer& a, const Integer& b);
  void set_signed(long long value);
  void set_unsigned(unsigned long long value);

  alignas(void*) unsigned char storage_[16];  // holds the mpz
};

Integer abs(Integer a);
/// The greatest common divisor, >= 0; gcd(0, 0) = 0.
Integer gcd(const Integer& a, const Integer& b);
/// a / b when b divides a. REQUIRES b != 0 and that it does.
Integer divide_exactly(const Integer& a, const Integer& b);
/// floor(a / b). REQUIRES b != 0.
Integer floor_divide(const Integer& a, const Integer& b);
/// 2^n.
Integer power_of_two(std::uint64_t n);

inline Sign sign_of(const Integer& a) { return a.sign(); }

}  // namespace veritope
