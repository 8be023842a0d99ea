// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/expression/enclosed_place_internal.h: places at irrational parameters, and normals there, in small boxes.
#pragma once
#include <array>

#include "interval/exact_box.h"
#include "solids/classify/algebraic_number.h"
#include "solids/patches/patch.h"

namespace veritope::internal {

/// A box of the domain of the patch's map that holds the place with these parameters of the square form (OnPatch); of
/// width 2^-126 or less, if their polynomials are known.
std::array<ExactInterval, 2> domain_enclosure(const Patch& patch, const AlgebraicPair& at);

/// Holds a positive multiple of the normal at each point of a box inside the domain: derivatives in its middle, widened
/// by bounds of second derivatives.
std::array<ExactInterval, 3> normal_enclosure(const Patch& patch,
                                              const std::array<ExactInterval, 2>& at);

ExactInterval sum(const ExactInterval& a, const ExactInterval& b);
ExactInterval difference(const ExactInterval& a, const ExactInterval& b);
ExactInterval product(const ExactInterval& a, const ExactInterval& b);

}  // namespace veritope::internal
