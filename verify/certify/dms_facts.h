// SPDX-License-Identifier: LGPL-3.0-or-later
// verify/certify/dms_facts.h: what certify says of a simplex-spline solid beside its verdict.
#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include "interval/interval.h"

namespace veritope {

struct DmsFacts {
  std::uint64_t tetrahedra = 0, control_points = 0;
  int degree = 1;
  /// If the solid is valid.
  std::uint64_t leaves = 0, patches = 0, bodies = 0;
  std::vector<std::uint64_t> genera;  ///< of the shells
  std::optional<Interval> volume;
};

}  // namespace veritope
