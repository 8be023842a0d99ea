// SPDX-License-Identifier: Apache-2.0 OR MIT
// star_ratio.h: quotients of long numbers, rounded down, for the corners of hulls.
#pragma once
#include "star.h"

// floor(x / (w 2^shift)), limited to +-kFarthest. Numbers of n limbs, lowest first, in two's complement; w > 0, 0 <=
// shift <= kMostShift. *exact: whether nothing was rounded; it means nothing where the quotient was limited.
int64_t floor_ratio(const uint64_t* x, const uint64_t* w, int n, int shift, bool* exact);
