// SPDX-License-Identifier: LGPL-3.0-or-later
// robust/base/sign.h: the sign of an exact quantity, and the answer of a tier that may not know it.
#pragma once
#include <concepts>

namespace veritope {

/// The exact sign of a real number.
enum class Sign : int { kNegative = -1, kZero = 0, kPositive = 1 };

/// What one tier of a cascade says: the exact sign, or that it cannot tell.
enum class Sign3 : int { kNegative = -1, kZero = 0, kPositive = 1, kUncertain = 2 };

constexpr bool is_certain(Sign3 s) { return s != Sign3::kUncertain; }
/// REQUIRES is_certain(s).
constexpr Sign to_sign(Sign3 s) { return static_cast<Sign>(s); }
constexpr Sign3 to_sign3(Sign s) { return static_cast<Sign3>(s); }

constexpr Sign operator-(Sign s) { return static_cast<Sign>(-static_cast<int>(s)); }
constexpr Sign operator*(Sign a, Sign b) {
  return static_cast<Sign>(static_cast<int>(a) * static_cast<int>(b));
}
constexpr int to_int(Sign s) { return static_cast<int>(s); }

namespace internal {
void a_sign_can_only_be_compared_with_zero();  // neither constexpr nor defined: no constant calls it
/// The int 0 as a constant. No other number, no number of another type and no variable converts to it.
struct LiteralZero {
  template <std::same_as<int> Int>
  consteval LiteralZero(Int value) noexcept {
    if (value != 0) a_sign_can_only_be_compared_with_zero();
  }
};
}  // namespace internal

/// A sign compares with 0 as its number does: orient2d(p, q, r) > 0. Both != and 0 == s follow from s == 0.
/// Comparisons with other numbers do not compile, nor do those of a Sign3: an uncertain sign has no order.
constexpr bool operator==(Sign s, internal::LiteralZero) { return s == Sign::kZero; }
constexpr bool operator<(Sign s, internal::LiteralZero) { return s < Sign::kZero; }
constexpr bool operator>(Sign s, internal::LiteralZero) { return s > Sign::kZero; }
constexpr bool operator<=(Sign s, internal::LiteralZero) { return s <= Sign::kZero; }
constexpr bool operator>=(Sign s, internal::LiteralZero) { return s >= Sign::kZero; }
constexpr bool operator<(internal::LiteralZero, Sign s) { return Sign::kZero < s; }
constexpr bool operator>(internal::LiteralZero, Sign s) { return Sign::kZero > s; }
constexpr bool operator<=(internal::LiteralZero, Sign s) { return Sign::kZero <= s; }
constexpr bool operator>=(internal::LiteralZero, Sign s) { return Sign::kZero >= s; }

/// Sign of an integer that C++ can compare with zero. Without a branch, like the other signs of fixed width: signs are
/// often as good as random, and a mispredicted branch costs more than a short determinant.
template <typename T>
constexpr Sign sign_of(const T& v) {
  return static_cast<Sign>(static_cast<int>(v > T(0)) - static_cast<int>(v < T(0)));
}

}  // namespace veritope
