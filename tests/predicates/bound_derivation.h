// SPDX-License-Identifier: LGPL-3.0-or-later
// tests/predicates/bound_derivation.h: the derivation of docs/bounds/README.md, run. The formulas
// of predicates/formulas.h are instantiated with two number types that do not compute values but
// what rounding can do to them; the results are exact rationals that the tests compare with the
// constants in the code.
#pragma once
#include <gtest/gtest.h>

#include <array>
#include <map>

#include "robust/rational.h"

namespace veritope::bounds {

inline Rational unit_roundoff() { return Rational::power_of_two(-53); }
/// The largest error of a product that underflows, round to nearest with gradual underflow.
inline Rational underflow_unit() { return Rational::power_of_two(-1075); }
/// The unit of underflow if a thread flushed underflowing products to zero.
inline Rational flush_unit() { return Rational::power_of_two(-1022); }

inline Rational power(const Rational& base, int n) {
  Rational r(1);
  for (int i = 0; i < n; ++i) r *= base;
  return r;
}

/// How many factors (1 + d), |d| <= u, the worst monomial of a computed value carries (README, 2).
struct RoundingCount {
  int roundings = 0;
  friend constexpr RoundingCount operator+(RoundingCount a, RoundingCount b) {
    return {(a.roundings > b.roundings ? a.roundings : b.roundings) + 1};
  }
  friend constexpr RoundingCount operator-(RoundingCount a, RoundingCount b) { return a + b; }
  friend constexpr RoundingCount operator*(RoundingCount a, RoundingCount b) {
    return {a.roundings + b.roundings + 1};
  }
};

/// README, 3: the least kRel that the counts allow. det_roundings leaves out the last addition,
/// which cannot change the sign of its exact argument; magnitude_roundings is for S; two more are
/// for kRel * S and the addition of the underflow terms.
inline Rational derived_rel(int det_roundings, int magnitude_roundings) {
  const Rational u = unit_roundoff(), up = Rational(1) + u, down = Rational(1) - u;
  return (power(up, det_roundings) - Rational(1)) * up / power(down, magnitude_roundings + 2);
}

/// `terms`: S is at most that many times what the code computes in its place.
inline void expect_tight(double constant, int det_roundings, int magnitude_roundings,
                         const Rational& terms = Rational(1)) {
  const Rational c = Rational::from_double(constant);
  const Rational slack = Rational(1) + Rational::power_of_two(-20);
  const auto derived = [&](int roundings) {
    return terms * derived_rel(roundings, magnitude_roundings);
  };
  EXPECT_LE(derived(det_roundings), c);
  EXPECT_LE(c, derived(det_roundings) * slack);
  EXPECT_EQ(constant, round_up(derived(det_roundings)));
  // The test would notice a rounding that is forgotten on either side.
  EXPECT_GT(derived(det_roundings + 1), c);
  EXPECT_GT(c, derived(det_roundings - 1) * slack);
}

/// A polynomial in up to four magnitudes with non-negative rational coefficients.
struct Polynomial {
  std::map<std::array<int, 4>, Rational> coefficient;

  static Polynomial constant(Rational c) {
    Polynomial p;
    if (c.sign() != Sign::kZero) p.coefficient[{0, 0, 0, 0}] = std::move(c);
    return p;
  }
  static Polynomial symbol(int which) {
    Polynomial p;
    std::array<int, 4> exponent{};
    exponent[which] = 1;
    p.coefficient[exponent] = Rational(1);
    return p;
  }
  friend Polynomial operator+(Polynomial a, const Polynomial& b) {
    for (const auto& [e, c] : b.coefficient) a.coefficient[e] += c;
    return a;
  }
  friend Polynomial operator*(const Polynomial& a, const Polynomial& b) {
    Polynomial r;
    for (const auto& [e, c] : a.coefficient) {
      for (const auto& [f, d] : b.coefficient) {
        r.coefficient[{e[0] + f[0], e[1] + f[1], e[2] + f[2], e[3] + f[3]}] += c * d;
      }
    }
    return r;
  }
  Rational at(int i, int j = 0, int k = 0, int l = 0) const {
    const auto found = coefficient.find({i, j, k, l});
    return found == coefficient.end() ? Rational() : found->second;
  }
};

/// README, 4: `size` bounds |value| without underflow, `error` what underflow adds, with `unit` the
/// error of one product. A difference of inputs is exact when it is small: sums never underflow.
class UnderflowCount {
 public:
  UnderflowCount() = default;
  /// A computed difference of inputs, or an input, at most the given symbol in magnitude.
  static UnderflowCount bounded_by(int symbol, Rational unit) {
    UnderflowCount r;
    r.size = Polynomial::symbol(symbol);
    r.unit = std::move(unit);
    return r;
  }
  friend UnderflowCount operator+(const UnderflowCount& a, const UnderflowCount& b) {
    return {grow(a.size + b.size), grow(a.error + b.error), a.unit};
  }
  friend UnderflowCount operator-(const UnderflowCount& a, const UnderflowCount& b) {
    return a + b;
  }
  friend UnderflowCount operator*(const UnderflowCount& a, const UnderflowCount& b) {
    return {grow(a.size * b.size),
            grow(a.size * b.error + b.size * a.error + a.error * b.error) +
                Polynomial::constant(a.unit),
            a.unit};
  }

  Polynomial size, error;
  Rational unit;

 private:
  UnderflowCount(Polynomial s, Polynomial e, Rational u)
      : size(std::move(s)), error(std::move(e)), unit(std::move(u)) {}
  static Polynomial grow(const Polynomial& p) {
    return Polynomial::constant(Rational(1) + unit_roundoff()) * p;
  }
};

/// Absolute values change no count.
inline constexpr auto kSame = [](const auto& v) { return v; };

}  // namespace veritope::bounds
