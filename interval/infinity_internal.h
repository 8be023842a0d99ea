// SPDX-License-Identifier: LGPL-3.0-or-later
// interval/infinity_internal.h: the name by which the functions of intervals call infinity.
#pragma once
#include <limits>

namespace veritope::internal {

inline constexpr double kInfinity = std::numeric_limits<double>::infinity();

}  // namespace veritope::internal
