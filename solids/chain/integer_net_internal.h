// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/chain/integer_net_internal.h: Bezier triangles with integer coefficients, up to positive factors: where signs
// are all that matters, they are cut without divisions.  Internal to solids/chain.
#pragma once
#include <array>

#include "robust/integer.h"
#include "splines/bezier_triangle.h"

namespace veritope::internal {

using IntegerNet = BezierTriangle<Integer>;

/// The map times one positive integer.
IntegerNet integer_net(const BezierTriangle<Rational>& map);

/// The pieces in the order of split_in_four: at the corners 0, 1, 2 of the domain, and in the middle; each times
/// 2^degree.
std::array<IntegerNet, 4> quarters_of(const IntegerNet& net);

}  // namespace veritope::internal
