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

using EnclosedVector = std::array<ExactInterval, 3>;

/// An interval of width 2^-128 or less, if the polynomial is known, in [0, 1].
ExactInterval enclosed(const AlgebraicNumber& number);
/// A box of the domain that holds the points of a side at an interval of its parameter, in the direction of travel.
std::array<ExactInterval, 2> side_enclosure(const Patch& patch, std::uint32_t side,
                                            const ExactInterval& along);

/// Holds positive multiples of the derivatives along both axes, by one factor, and of the normal, at each point of a
/// box inside the domain: derivatives in its middle, widened by bounds of second derivatives.
struct JetEnclosure {
  std::array<EnclosedVector, 2> tangents;
  EnclosedVector normal;
};
JetEnclosure jet_enclosure(const Patch& patch, const std::array<ExactInterval, 2>& at);
/// That of the derivative along a side, in its direction of travel.
EnclosedVector along_side(const Patch& patch, std::uint32_t side, const JetEnclosure& at);

EnclosedVector crossed(const EnclosedVector& a, const EnclosedVector& b);
ExactInterval dotted(const EnclosedVector& a, const EnclosedVector& b);
/// That of all numbers of the interval; zero if they have several.
Sign sign_of(const ExactInterval& a);

ExactInterval sum(const ExactInterval& a, const ExactInterval& b);
ExactInterval difference(const ExactInterval& a, const ExactInterval& b);
ExactInterval product(const ExactInterval& a, const ExactInterval& b);

}  // namespace veritope::internal
