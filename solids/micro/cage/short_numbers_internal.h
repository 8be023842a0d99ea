// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/micro/cage/short_numbers_internal.h: numbers rounded to multiples of powers of two.
#pragma once
#include "robust/rational.h"

namespace veritope::internal {

/// The greatest multiple of the unit that is at most x. REQUIRES unit > 0.
Rational multiple_below(const Rational& x, const Rational& unit);
/// The least multiple of the unit that is at least x. REQUIRES unit > 0.
Rational multiple_above(const Rational& x, const Rational& unit);
/// The greatest power of two that is at most x. REQUIRES x > 0.
Rational power_of_two_below(const Rational& x);
/// A number from x to x (1 + 2^-10) whose numerator has at most 12 bits, or 0. REQUIRES x >= 0.
Rational short_above(const Rational& x);

}  // namespace veritope::internal
