// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/pieces/patch_volume.h: the volume that closed oriented patches enclose, in an interval. Theory: docs/THEORY.md
// §5.
#pragma once
#include <vector>

#include "interval/interval.h"
#include "solids/pieces/piece_forest.h"

namespace veritope {

/// The volume of each shell of the complex: a third of the integral of n·S over its patches (Gauss), in the model's
/// units. A shell whose normals point out of what it bounds has a positive volume. A polynomial patch contributes the
/// mean of its Bernstein coefficients, as narrow as rounding allows. For a rational patch, 1 / w^3 is replaced by a
/// polynomial in w of sufficient order with a bound of the remainder; pieces are split where order 9 does not suffice,
/// up to eight times. The remainders add up to at most `tolerance` times the cube of half the model's greatest length,
/// in the frame; rounding comes on top. The distance of the model from the origin has no influence. @cost polynomial:
/// O(coefficients)
std::vector<Interval> shell_volumes(PieceForest& forest, double tolerance);

}  // namespace veritope
