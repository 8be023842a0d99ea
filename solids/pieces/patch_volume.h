// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/pieces/patch_volume.h: the volume that closed oriented patches enclose, in an interval. Theory: docs/THEORY.md
// §5.
#pragma once
#include <vector>

#include "interval/interval.h"
#include "solids/pieces/piece_forest.h"

namespace veritope {

/// The volume of each shell of the complex: a third of the integral of n·S over its patches (Gauss), in the model's
/// units. A shell whose normals point out of what it bounds has a positive volume. Polynomial patches: the mean of
/// Bernstein coefficients, as narrow as rounding allows. Rational ones: 1 / w^3 as a polynomial in w of an order that
/// suffices, with a bound of the rest, on pieces that are split where order 9 does not suffice, up to eight times: what
/// the rests add up to is at most `tolerance` times the cube of half the model's greatest length, in the frame;
/// rounding comes on top. How far from the origin the model lies does not count. @cost polynomial: O(coefficients)
std::vector<Interval> shell_volumes(PieceForest& forest, double tolerance);

}  // namespace veritope
