// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/micro/measure/bridge_volume_internal.h: the volumes of bridges in space. Internal to solids/micro/measure.
#pragma once
#include "interval/interval.h"
#include "solids/micro/microstructure.h"

namespace veritope::internal {

/// The sum of the integrals of det DT over all bridges, each with the sign that determinants have in its volume for
/// hands[volume]: +1 or -1. Bridges that cross knots are cut until their bounds, together, are `enough` apart, or at
/// a limit of parts. The result is the same for every number of jobs.
/// REQUIRES valid bridges: each is right-handed and one to one, in the parameters of its volume.
/// @cost  0.3 ms for a bridge in a tricubic span; up to 100 times that where it crosses a knot
Interval volume_of_bridges(const Microstructure& micro, const std::vector<int>& hands,
                           double enough, unsigned jobs);

}  // namespace veritope::internal
