// SPDX-License-Identifier: LGPL-3.0-or-later
// robust/simplest.h: the simplest fraction of an interval.
#pragma once
#include "robust/rational.h"

namespace veritope {

/// The number strictly between lo and hi with the least denominator, and of these the least one. REQUIRES 0 <= lo < hi.
/// @cost  one division a step of Euclid's algorithm
Rational simplest_between(const Rational& lo, const Rational& hi);

}  // namespace veritope
