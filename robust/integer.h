// SPDX-License-Identifier: LGPL-3.0-or-later
// robust/integer.h: integers of any size. Those that fit int64_t are held in the object and take no other memory;
// longer ones are GMP's, and their memory comes from GMP's allocator. Elsewhere in the library std::bad_alloc passes
// through when memory runs out; here it cannot: GMP does not return, it ends the program. Which integer type to take
// when: docs/integers.md.
#pragma once
#include <compare>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "robust/base/sign.h"

namespace veritope {

template <typename T>
concept BuiltinInteger = std::integral<T> && !std::same_as<T, bool> && sizeof(T) <= 8;

/// A mathematical integer. Ring operations never fail and never throw:
/// when memory runs out, the program ends, as the top of this file says.
class Integer {
 public:
  Integer() noexcept = default;
  /// Exact from every built-in integer type, and from nothing else: a double does not convert.
  template <BuiltinInteger T>
  Integer(T value) noexcept {
    if (std::is_signed_v<T> || static_cast<std::uint64_t>(value) >> 63 == 0) {
      held_.small = static_cast<std::int64_t>(value);
    } else {
      set_unsigned(static_cast<std::uint64_t>(value));
    }
  }
  Integer(const Integer& other) noexcept : held_(other.held_) {
    if (!is_small()) copy_limbs();
  }
  Integer(Integer&& other) noexcept : held_(std::exchange(other.held_, Held())) {}
  Integer& operator=(const Integer& other) noexcept {
    if (is_small() && other.is_small()) {
      held_ = other.held_;
      return *this;
    }
    return assign(other);
  }
  Integer& operator=(Integer&& other) noexcept {
    std::swap(held_, other.held_);
    return *this;
  }
  ~Integer() {
    if (!is_small()) free_limbs();
  }

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

  friend bool operator==(const Integer& a, const Integer& b) noexcept {
    return a.is_small() || b.is_small() ? a.is_small() && b.is_small() && a.held_.small == b.held_.small
                                        : compare(a, b) == 0;
  }
  friend std::strong_ordering operator<=>(const Integer& a, const Integer& b) noexcept {
    return a.is_small() && b.is_small() ? a.held_.small <=> b.held_.small : compare(a, b) <=> 0;
  }

  Sign sign() const noexcept {
    const std::int64_t signed_as_this = is_small() ? held_.small : held_.size;
    return static_cast<Sign>((signed_as_this > 0) - (signed_as_this < 0));
  }
  bool is_zero() const noexcept { return sign() == Sign::kZero; }
  /// Bits of |this|: 0 for 0, else floor(log2 |this|) + 1.
  std::uint64_t bit_length() const noexcept;
  /// Index of the lowest set bit of |this|. REQUIRES !is_zero().
  std::uint64_t trailing_zeros() const;
  bool fits_int64() const noexcept { return is_small(); }
  /// REQUIRES fits_int64().
  std::int64_t to_int64() const;
  /// The low 64 bits of |this|.
  std::uint64_t low_bits() const noexcept;
  /// True iff bit n of |this| is set.
  bool test_bit(std::uint64_t n) const noexcept;
  /// |this| as the sum of limbs[i] * 2^(64 i); no limb for 0, and the last one is not 0.
  std::vector<std::uint64_t> limbs() const;
  /// "-12".
  std::string to_string() const;

 private:
  friend struct IntegerGmp;  // reads and writes the fields as those of an mpz

  // capacity = 0: the integer is `small`. Otherwise it is outside int64_t, and these are the fields of its mpz.
  struct Held {
    std::int32_t capacity = 0;
    std::int32_t size = 0;
    union {
      std::int64_t small = 0;
      std::uint64_t* limbs;
    };
  };

  bool is_small() const noexcept { return held_.capacity == 0; }
  void copy_limbs() noexcept;
  void free_limbs() noexcept;
  Integer& assign(const Integer& other) noexcept;
  void set_unsigned(std::uint64_t value) noexcept;
  static int compare(const Integer& a, const Integer& b) noexcept;

  Held held_;
};

Integer abs(Integer a) noexcept;
/// The greatest common divisor, >= 0; gcd(0, 0) = 0.
Integer gcd(const Integer& a, const Integer& b) noexcept;
/// The least common multiple, >= 0; 0 if a or b is.
Integer lcm(const Integer& a, const Integer& b) noexcept;
/// Divides *a by `factor` as often as that leaves no remainder; how often. REQUIRES *a != 0, factor >= 2.
std::uint64_t remove_factor(Integer* a, const Integer& factor);
/// a - m floor(a / m). REQUIRES m != 0.
std::uint64_t floor_remainder(const Integer& a, std::uint64_t m);
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
