// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/dms/fast/fast_pair_internal.h: the sums of fast_dms_internal.h at one point with pairs of binary64 numbers,
// for points where the kernels' bounds are too great or a sign is not decided. Bounds: docs/bounds/fast_dms.md, 7.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "solids/dms/fast/fast_region_internal.h"

namespace veritope::internal {

/// hi + lo, |lo| <= 2^-53 |hi|.
struct FastPair {
  double hi = 0, lo = 0;
};
/// The nearest number to x, and the nearest one to the rest.
FastPair pair_of(const Rational& x);

struct FastPairSums {
  std::vector<FastPair> value, gradient;  ///< by components, then by axes
  double error = 0, slope_error = 0;      ///< in units of the greatest control value
  bool is_open = false;                   ///< a sign was not decided
};

/// Adds what a unit adds at the point. `slack` is as many 2^-102 as sums have roundings.
void add_pairs(const FastRegionUnit& unit, const std::array<Rational, 3>& point, double slack,
               bool with_gradient, FastPairSums& sums);

}  // namespace veritope::internal
