// SPDX-License-Identifier: LGPL-3.0-or-later
// render/colour_map.h: colours of numbers in pictures: from dark violet over blue and green to yellow, brighter from
// each to the next.
#pragma once
#include "render/colour.h"

namespace veritope {

/// The colour of a share from 0 to 1: linear, channel by channel and rounded, between (68, 1, 84), (59, 82, 139),
/// (33, 145, 140), (94, 201, 98) and (253, 231, 37) at 0, 1/4, 1/2, 3/4 and 1, five colours of the map "viridis" of
/// Nathaniel Smith and Stefan van der Walt (CC0). Shares beyond 0 and 1 have the colours of these ends; that of NaN
/// is the one of 0.
Colour map_colour(double share);

}  // namespace veritope
