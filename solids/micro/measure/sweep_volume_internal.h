// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/micro/measure/sweep_volume_internal.h: the volumes of sweeps. Internal to solids/micro/measure.
#pragma once
#include <vector>

#include "interval/interval.h"
#include "solids/micro/microstructure.h"

namespace veritope::internal {

/// The sum over all sweeps. The result is the same for every number of jobs.
/// REQUIRES valid sweeps: each starts at a cap of one patch, is one to one, and its determinants have the sign that
/// hands[volume] says, +1 or -1, of the volume of its cell.
/// @cost  0.1 ms for a cap of degree 1, 1 in a tricubic volume, a few milliseconds in a rational one
Interval volume_of_sweeps(const Microstructure& micro, const std::vector<int>& hands,
                          unsigned jobs);

}  // namespace veritope::internal
