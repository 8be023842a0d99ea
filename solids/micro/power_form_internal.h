// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/micro/power_form_internal.h: polynomials by powers, in which maps are compared whatever their degrees are.
// Internal to solids/micro.
#pragma once
#include <vector>

#include "robust/rational.h"

namespace veritope::internal {

/// Coefficients of 1, s, s^2, ... of a polynomial in Bernstein form. REQUIRES at least one.
std::vector<Rational> powers_of(const std::vector<Rational>& bernstein);

}  // namespace veritope::internal
