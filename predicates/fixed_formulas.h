// SPDX-License-Identifier: LGPL-3.0-or-later
// predicates/fixed_formulas.h: the determinants of formulas.h in integers that are as wide as the
// operands need (lattice.h). The static_asserts are the proof that nothing wraps around.
#pragma once
#include <array>
#include <cstdint>

#include "predicates/lattice.h"
#include "robust/digits.h"
#include "robust/fixed_int.h"

namespace veritope::internal {

/// Bit lengths of the parts of a determinant of differences, if no difference exceeds 2^diff.
struct LatticeBudget {
  int diff;
  constexpr int product() const { return bits_of_product(diff, diff); }
  constexpr int minor() const { return bits_of_sum(2, product()); }  // a b - c d, or a^2 + b^2
  constexpr int minor3() const { return bits_of_sum(3, bits_of_product(diff, minor())); }
  constexpr int lift3() const { return bits_of_sum(3, product()); }
  constexpr int circle() const { return bits_of_sum(3, bits_of_product(minor(), minor())); }
  constexpr int sphere() const { return bits_of_sum(4, bits_of_product(lift3(), minor3())); }
};

constexpr int bits_held(std::int64_t*) { return 63; }
constexpr int bits_held(int128*) { return 127; }
template <int L>
constexpr int bits_held(FixedInt<L>*) {
  return FixedInt<L>::kBits;
}
// Counts bits by the place of the last column only; the static_asserts below show that each column holds its sums.
template <int N>
constexpr int bits_held(Columns<N>*) {
  return kDigitBits * (N - 1) + 127;
}
template <typename T>
inline constexpr int kBitsHeld = bits_held(static_cast<T*>(nullptr));

[[gnu::always_inline]] inline Digits<2> digits_of(int128 v) {
  return {{Columns<1>::low_digit(v), Columns<1>::high_digit(v)}};
}

/// a * b as an R, which must hold it.
template <typename R, typename A, typename B>
[[gnu::always_inline]] inline R times(const A& a, const B& b) {
  if constexpr (std::is_integral_v<R> || std::is_same_v<R, int128>) {
    return static_cast<R>(a) * b;
  } else if constexpr (std::is_same_v<R, Columns<2>>) {  // int64_t * int128
    return column_product(Digits<1>{{a}}, digits_of(b));
  } else if constexpr (std::is_same_v<R, Columns<3>>) {  // int128 * int128
    return column_product(digits_of(a), digits_of(b));
  } else if constexpr (std::is_same_v<R, Columns<4>>) {  // int128 * Columns<2>
    return column_product(digits_of(a), settled(b));
  } else if constexpr (std::is_integral_v<A>) {
    return times<R>(FixedInt<1>(a), b);
  } else if constexpr (std::is_same_v<A, int128>) {
    return times<R>(FixedInt<2>(a), b);
  } else if constexpr (std::is_same_v<B, int128>) {
    return times<R>(a, FixedInt<2>(b));
  } else {
    return wide_product(a, b);
  }
}

/// The types that hold a difference, a product of two, of three, and of four or five differences of
/// at most 2^Diff.
template <int Diff, typename One, typename Two, typename Three, typename Most>
struct Width {
  using D1 = One;
  using D2 = Two;
  using D3 = Three;
  using Last = Most;
  static constexpr LatticeBudget kBudget{Diff};
  static_assert(Diff < kBitsHeld<D1>);

  static D2 minor(const D1& x, const D1& y, const D1& z, const D1& w) {  // x y - z w
    return times<D2>(x, y) - times<D2>(z, w);
  }
};

/// Differences on a lattice of one limb, of two, and short ones: see lattice.h.
using OneLimb = Width<lattice_bits(1) + 1, std::int64_t, int128, Columns<2>, Columns<4>>;
using OneLimbCircle = Width<lattice_bits(1) + 1, std::int64_t, int128, Columns<2>, Columns<3>>;
using TwoLimbs = Width<lattice_bits(2) + 1, FixedInt<2>, FixedInt<4>, FixedInt<6>, FixedInt<10>>;
using TwoLimbsCircle =
    Width<lattice_bits(2) + 1, FixedInt<2>, FixedInt<4>, FixedInt<6>, FixedInt<8>>;
template <int L>
using LatticeWidth = std::conditional_t<L == 1, OneLimb, TwoLimbs>;
template <int L>
using LatticeWidthCircle = std::conditional_t<L == 1, OneLimbCircle, TwoLimbsCircle>;
using Short = Width<30, std::int64_t, std::int64_t, int128, FixedInt<3>>;
using ShortCircle = Width<30, std::int64_t, std::int64_t, int128, int128>;
using Tiny = Width<11, std::int64_t, std::int64_t, std::int64_t, std::int64_t>;

// The columns hold their sums. In units of 2^60 a low digit is below 4; for differences up to 2 the high digit of a
// minor or of x^2 + y^2 (2^123) is up to 2, that of x^2 + y^2 + z^2 (3 2^122) up to 3, that of a sum of three products
// of a minor and a difference (3 2^184) up to 3. A column holds less than 128 units squared; the carries, below 2^65,
// are far less than one.
static_assert(lattice_bits(1) + 1 == 61);
static_assert(3 * (2 * 4) < 127 && 3 * (2 * 2) < 127, "Columns<2> of orient3d and in_sphere");
static_assert(3 * (4 * 4) < 127 && 3 * (4 * 2 + 2 * 4) < 127, "Columns<3> of in_circle");
static_assert(4 * (4 * 4) < 127 && 4 * (4 * 4 + 3 * 4) < 127 && 4 * (4 * 3 + 3 * 4) < 127,
              "Columns<4> of in_sphere");

/// The sign of orient2d from u = b - a and v = c - a.
template <typename W, typename D = typename W::D1>
[[gnu::always_inline]] inline Sign orient2d_fixed(const std::array<D, 2>& x,
                                                  const std::array<D, 2>& y) {
  static_assert(W::kBudget.minor() < kBitsHeld<typename W::D2>);
  return sign_of(W::minor(x[0], y[1], y[0], x[1]));
}

/// The sign of orient3d from u = b - a, v = c - a, w = d - a, given axis by axis.
template <typename W, typename D = typename W::D1>
[[gnu::always_inline]] inline Sign orient3d_fixed(const std::array<D, 3>& x,
                                                  const std::array<D, 3>& y,
                                                  const std::array<D, 3>& z) {
  static_assert(W::kBudget.minor() < kBitsHeld<typename W::D2>);
  static_assert(W::kBudget.minor3() < kBitsHeld<typename W::D3>);
  using D3 = typename W::D3;
  return sign_of(times<D3>(x[2], W::minor(y[0], z[1], z[0], y[1])) +
                 times<D3>(y[2], W::minor(z[0], x[1], x[0], z[1])) +
                 times<D3>(z[2], W::minor(x[0], y[1], y[0], x[1])));
}

/// The sign of in_circle from a - d, b - d, c - d: x, y, x, y, x, y.
template <typename W, typename D = typename W::D1>
[[gnu::always_inline]] inline Sign in_circle_fixed(const std::array<D, 6>& p) {
  static_assert(W::kBudget.minor() < kBitsHeld<typename W::D2>);
  static_assert(W::kBudget.circle() < kBitsHeld<typename W::Last>);
  using D2 = typename W::D2;
  using Last = typename W::Last;
  const auto lift = [&](int i) -> D2 {
    return times<D2>(p[2 * i], p[2 * i]) + times<D2>(p[2 * i + 1], p[2 * i + 1]);
  };
  const auto minor = [&](int i, int j) {
    return W::minor(p[2 * i], p[2 * j + 1], p[2 * j], p[2 * i + 1]);
  };
  return sign_of(times<Last>(lift(0), minor(1, 2)) + times<Last>(lift(1), minor(2, 0)) +
                 times<Last>(lift(2), minor(0, 1)));
}

/// The sign of in_sphere from a - e, b - e, c - e, d - e: x, y, z, x, y, z, ...
template <typename W, typename D = typename W::D1>
[[gnu::always_inline]] inline Sign in_sphere_fixed(const std::array<D, 12>& p) {
  static_assert(W::kBudget.minor() < kBitsHeld<typename W::D2> &&
                W::kBudget.lift3() < kBitsHeld<typename W::D2>);
  static_assert(W::kBudget.minor3() < kBitsHeld<typename W::D3>);
  static_assert(W::kBudget.sphere() < kBitsHeld<typename W::Last>);
  using D2 = typename W::D2;
  using D3 = typename W::D3;
  using Last = typename W::Last;
  const auto lift = [&](int i) -> D2 {
    return times<D2>(p[3 * i], p[3 * i]) + times<D2>(p[3 * i + 1], p[3 * i + 1]) +
           times<D2>(p[3 * i + 2], p[3 * i + 2]);
  };
  const auto m = [&](int i, int j) {
    return W::minor(p[3 * i], p[3 * j + 1], p[3 * j], p[3 * i + 1]);
  };
  const auto z = [&](int i, const D2& minor) { return times<D3>(p[3 * i + 2], minor); };
  const D2 ab = m(0, 1), bc = m(1, 2), cd = m(2, 3), da = m(3, 0), ac = m(0, 2), bd = m(1, 3);
  const D3 abc = z(0, bc) - z(1, ac) + z(2, ab), bcd = z(1, cd) - z(2, bd) + z(3, bc);
  const D3 cda = z(2, da) + z(3, ac) + z(0, cd), dab = z(3, ab) + z(0, bd) + z(1, da);
  return sign_of(times<Last>(lift(0), bcd) - times<Last>(lift(1), cda) + times<Last>(lift(2), dab) -
                 times<Last>(lift(3), abc));
}

}  // namespace veritope::internal
