// SPDX-License-Identifier: Apache-2.0 OR MIT
// patch_winding.h: the winding number of patches around a point; docs/certificates/points.md, section 6.
#pragma once
#include "patch_boxes.h"
#include "patch_lines.h"

// P3 if a piece or a curve is left over; where: for the message.
int64_t winding_number(const std::vector<Grid>& grids, const PatchBoxes& boxes,
                       const RationalPoint& point, int direction, const std::string& where,
                       PointUnits* units);

// Sums over some of the patches: all those of a closed surface that the ray may meet. False if a piece or a curve is
// left over.
bool sum_around(const std::vector<Grid>& grids, const std::vector<uint32_t>& patches,
                const RationalPoint& point, int direction, PointUnits* units, int64_t* sum);
