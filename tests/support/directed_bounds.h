// SPDX-License-Identifier: LGPL-3.0-or-later
// tests/support/directed_bounds.h: derivations of rounding bounds that hold in every rounding mode:
// docs/bounds/piece_net.md, 1.
#pragma once
#include "tests/predicates/bound_derivation.h"

namespace veritope::bounds {

inline RoundingCount operator/(RoundingCount a, RoundingCount b) { return a * b; }

/// A rounded operation errs by at most this times its exact result, in every rounding mode.
inline Rational directed_unit() { return Rational::power_of_two(-52); }

/// A value that carries k roundings, quotients among them, errs by at most this times its size; the bound that pays for
/// it loses `bound_roundings` roundings itself.
inline Rational derived_directed(int k, int bound_roundings) {
  const Rational down = Rational(1) - directed_unit();
  return (Rational(1) / power(down, k) - Rational(1)) / power(down, bound_roundings);
}

/// The constant is the derived one, and not that of one rounding more, nor of one fewer.
inline void expect_tight_directed(const Rational& constant, int k, int bound_roundings) {
  const Rational part = Rational(1) + Rational::power_of_two(-20);
  EXPECT_LT(derived_directed(k, bound_roundings), constant);
  EXPECT_LE(constant, derived_directed(k, bound_roundings) * part);
  EXPECT_GT(derived_directed(k + 1, bound_roundings), constant);
  EXPECT_GT(constant, derived_directed(k - 1, bound_roundings) * part);
}

}  // namespace veritope::bounds
