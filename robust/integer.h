// SPDX-License-Identifier: LGPL-3.0-or-later
// robust/integer.h: integers of any size; a thin owner of a GMP mpz. Memory comes from GMP's allocator. Elsewhere in
// the library std::bad_alloc passes through when memory runs out; here it cannot: GMP does not return, it ends the
// program. Which integer type to take when: docs/integers.md.
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

/// A mathematical integer. Ring operations never fail and never throw:
/// when memory runs out, the program ends, as the top of this file says.
class Integer {
 public:
  Integer() noexcept;
  /// Exact from every built-in integer type, and from nothing else: a double does not convert.
  template <BuiltinInteger T>
  Integer(T value) noexcept : Integer() {
    if constexpr (std::is_signed_v<T>) {
      set_signed(value);
    } else {
      set_unsigned(value);
    }
  }
  Integer(const Integer& other) noexcept;
  Integer(Integer&& other) noexcept;
  Integer& operator=(const Integer& other) noexcept;
  Integer& operator=(Integer&& other) noexcept;
  ~Integer();

  /// The integer sum of limbs[i] * 2^(64 i), limbs unsigned, negated if `negative`.
  static Integer from_limbs(const std::uint64_t* limbs, std::size_t count, bool negative) noexcept;
  /// REQUIRES decimal digits with an optional '-', and nothing else.
  static Integer from_decimal(std::string_view digits);

  Integer& operator+=(const Integer& b) noexcept;
  Integer& operator-=(const Integer& b) noexcept;
  Integer& operator*=(const Integer& b) noexcept;
  friend Integer operator+(Integer a, const Integer& b) noexcept { return a += b; }
  friend Integer operator-(Integer a, const Integer& b) noexcept { return a -= b; }
  friend Integer operator*(Integer a, const Integer& b) noexcept { return a *= b; }
  friend Integer operator-(Integer a) noexcept { return a.negate(); }
  friend Integer operator<<(Integer a, std::uint64_t n) noexcept { return a.shift_left(n); }
  Integer& negate() noexcept;
  /// *this += a * b and *this -= a * b, without a temporary.
  Integer& add_product(const Integer& a, const Integer& b) noexcept;
  Integer& subtract_product(const Integer& a, const Integer& b) noexcept;

  /// this * 2^n, exact.
  Integer& shift_left(std::uint64_t n) noexcept;
  /// floor(this / 2^n).
  Integer& shift_right(std::uint64_t n) noexcept;

  friend bool operator==(const Integer& a, const Integer& b) noexcept { return compare(a, b) == 0; }
  friend std::strong_ordering operator<=>(const Integer& a, const Integer& b) noexcept {
    return compare(a, b) <=> 0;
  }

  Sign sign() const noexcept;
  bool is_zero() const noexcept { return sign() == Sign::kZero; }
  /// Bits of |this|: 0 for 0, else floor(log2 |this|) + 1.
  std::uint64_t bit_length() const noexcept;
  /// Index of the lowest set bit of |this|. REQUIRES !is_zero().
  std::uint64_t trailing_zeros() const;
  bool fits_int64() const noexcept;
  /// REQUIRES fits_int64().
  std::int64_t to_int64() const;
  /// The low 64 bits of |this|.
  std::uint64_t low_bits() const noexcept;
  /// True iff bit n of |this| is set.
  bool test_bit(std::uint64_t n) const noexcept;
  /// "-12".
  std::string to_string() const;

  /// The GMP mpz (an mpz_ptr, an mpz_srcptr) for code that calls GMP itself; its header stays out
  /// of ours.
  void* gmp() { return storage_; }
  const void* gmp() const { return storage_; }

 private:
  static int compare(const Integer& a, const Integer& b) noexcept;
  void set_signed(long long value) noexcept;
  void set_unsigned(unsigned long long value) noexcept;

  alignas(void*) unsigned char storage_[16];  // holds the mpz
};

Integer abs(Integer a) noexcept;
/// The greatest common divisor, >= 0; gcd(0, 0) = 0.
Integer gcd(const Integer& a, const Integer& b) noexcept;
/// a / b. REQUIRES that b != 0 and that b divides a.
Integer divide_exactly(const Integer& a, const Integer& b);
/// floor(a / b). REQUIRES b != 0.
Integer floor_divide(const Integer& a, const Integer& b);
/// The greatest integer whose square is at most a. REQUIRES a >= 0.
Integer floor_sqrt(const Integer& a);
/// 2^n.
Integer power_of_two(std::uint64_t n) noexcept;
/// base^n; base^0 = 1.
Integer power(const Integer& base, std::uint64_t n) noexcept;

inline Sign sign_of(const Integer& a) noexcept { return a.sign(); }

}  // namespace veritope
