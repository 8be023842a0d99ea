// SPDX-License-Identifier: LGPL-3.0-or-later
// robust/bounded.h: integers whose type knows a bound of their magnitude. Sums and products are as wide as their bounds
// ask, in int64_t, __int128 or FixedInt: nothing can wrap around, and no budget is written by hand. Which integer when:
// docs/integers.md.
#pragma once
#include <cstdint>
#include <type_traits>

#include "robust/base/int128.h"
#include "robust/base/sign.h"
#include "robust/fixed_int.h"

namespace veritope {

namespace internal {
constexpr int bits_of_terms(std::int64_t terms) {
  int bits = 0;
  while ((std::int64_t{1} << bits) < terms) ++bits;
  return bits;
}

/// Holds every v with |v| <= 2^Bits.
template <int Bits>
using HoldingBits = std::conditional_t<
    (Bits < 63), std::int64_t,
    std::conditional_t<(Bits < 127), int128, FixedInt<(Bits < 127 ? 3 : (Bits + 1) / 64 + 1)>>>;
static_assert(sizeof(HoldingBits<62>) == 8 && sizeof(HoldingBits<63>) == 16);
static_assert(sizeof(HoldingBits<126>) == 16 && sizeof(HoldingBits<127>) == 24);
static_assert(FixedInt<3>::kBits == 191, "[-2^191, 2^191)");
static_assert(sizeof(HoldingBits<190>) == 24 && sizeof(HoldingBits<191>) == 32);

template <typename T>
inline constexpr int kLimbsOf = sizeof(T) / 8;

/// v as a To, which holds it.
template <typename To, typename From>
[[gnu::always_inline]] constexpr To resized(const From& v) {
  if constexpr (std::is_same_v<To, From> || sizeof(To) <= 16) {
    return static_cast<To>(v);
  } else {
    return To(v);
  }
}

/// a * b as a To, which holds it.
template <typename To, typename A, typename B>
[[gnu::always_inline]] constexpr To product_as(const A& a, const B& b) {
  if constexpr (sizeof(To) <= 16) {
    return static_cast<To>(a) * static_cast<To>(b);
  } else {
    const auto whole = wide_product(FixedInt<kLimbsOf<A>>(a), FixedInt<kLimbsOf<B>>(b));
    To r;
    static_assert(kLimbsOf<To> <= kLimbsOf<A> + kLimbsOf<B>);
    VT_UNROLL for (int i = 0; i < kLimbsOf<To>; ++i) r.limb[i] = whole.limb[i];
    return r;
  }
}
}  // namespace internal

/// An integer v with |v| <= Terms * 2^Bits.
template <int Bits, std::int64_t Terms = 1>
class Bounded {
 public:
  static_assert(Bits >= 0 && Terms >= 1);
  static constexpr int kBits = Bits + internal::bits_of_terms(Terms);  ///< |v| <= 2^kBits
  using Held = internal::HoldingBits<kBits>;

  constexpr Bounded() = default;
  /// REQUIRES |v| <= Terms * 2^Bits: nobody looks.
  static constexpr Bounded trusted(const Held& v) { return Bounded(v); }
  constexpr const Held& held() const { return v_; }

  friend constexpr Sign sign_of(const Bounded& a) {
    using veritope::sign_of;
    return sign_of(a.v_);
  }

 private:
  constexpr explicit Bounded(const Held& v) : v_(v) {}
  Held v_{};
};

namespace internal {
template <int B1, std::int64_t T1, int B2, std::int64_t T2>
struct SumOfBounded {
  static constexpr int kBits = B1 > B2 ? B1 : B2;
  static constexpr std::int64_t in_larger(int bits, std::int64_t terms) {
    const int shift = kBits - bits;
    return shift >= 62 ? 1 : ((terms - 1) >> shift) + 1;
  }
  using Type = Bounded<kBits, in_larger(B1, T1) + in_larger(B2, T2)>;
};
}  // namespace internal

template <int B1, std::int64_t T1, int B2, std::int64_t T2>
[[gnu::always_inline]] constexpr auto operator+(const Bounded<B1, T1>& a,
                                                const Bounded<B2, T2>& b) {
  using R = typename internal::SumOfBounded<B1, T1, B2, T2>::Type;
  using Held = typename R::Held;
  return R::trusted(internal::resized<Held>(a.held()) + internal::resized<Held>(b.held()));
}
template <int B1, std::int64_t T1, int B2, std::int64_t T2>
[[gnu::always_inline]] constexpr auto operator-(const Bounded<B1, T1>& a,
                                                const Bounded<B2, T2>& b) {
  using R = typename internal::SumOfBounded<B1, T1, B2, T2>::Type;
  using Held = typename R::Held;
  return R::trusted(internal::resized<Held>(a.held()) - internal::resized<Held>(b.held()));
}
template <int B1, std::int64_t T1, int B2, std::int64_t T2>
[[gnu::always_inline]] constexpr auto operator*(const Bounded<B1, T1>& a,
                                                const Bounded<B2, T2>& b) {
  using R = Bounded<B1 + B2, T1 * T2>;
  return R::trusted(internal::product_as<typename R::Held>(a.held(), b.held()));
}
template <int B, std::int64_t T>
[[gnu::always_inline]] constexpr auto sqr(const Bounded<B, T>& a) {
  return a * a;
}

/// n * x over any ring; Bounded widens by what n needs.
template <int N, typename T>
constexpr T multiple(const T& x) {
  return T(N) * x;
}
template <int N, int B, std::int64_t T>
constexpr auto multiple(const Bounded<B, T>& x) {
  return Bounded<0, N>::trusted(N) * x;
}

namespace internal {
/// |v| <= 2^Bits?
template <int Bits, int B, std::int64_t T>
[[gnu::always_inline]] constexpr bool fits(const Bounded<B, T>& v) {
  using Held = typename Bounded<B, T>::Held;
  static_assert(sizeof(Held) <= 16 && Bits < Bounded<B, T>::kBits);
  constexpr Held kMost = Held{1} << Bits;
  return v.held() <= kMost && v.held() >= -kMost;
}
/// REQUIRES fits<Bits>(v).
template <int Bits, int B, std::int64_t T>
[[gnu::always_inline]] constexpr Bounded<Bits> narrowed(const Bounded<B, T>& v) {
  return Bounded<Bits>::trusted(static_cast<typename Bounded<Bits>::Held>(v.held()));
}
}  // namespace internal

}  // namespace veritope
