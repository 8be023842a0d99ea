// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/volumes/half_angle.h: tangents of rational numbers of degrees and square roots, enclosed in rationals.
#pragma once
#include "robust/rational.h"

namespace veritope::internal {

struct RationalRange {
  Rational lo, hi;
};

/// pi, with hi - lo < 2^-120.
const RationalRange& pi_range();
/// The tangent of so many degrees, with hi - lo < 2^-90 times the tangent. REQUIRES 0 <= degrees <= 45.
RationalRange tangent_range(const Rational& degrees);
/// The square root, with hi - lo <= 2^-100 hi; lo = hi if it is rational. REQUIRES square > 0.
RationalRange square_root_range(const Rational& square);

}  // namespace veritope::internal
